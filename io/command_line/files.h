// What commands read and write: files, standard input and output; what is wrong with them on standard error.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/valve/types.h"

namespace coapt {

/// As much as a JSON document may have (io/json/parse_json.h); a binary mesh of so many has 1.3 million triangles.
inline constexpr std::size_t kMostInputBytes = std::size_t{64} << 20;

/// The bytes of a file, or of standard input if `path` is "-", which can be read once.
Expected<std::string> read_input(const std::string& path, std::size_t most_bytes = kMostInputBytes);

/// A usage error if `path` is "-": for outputs beside a result that standard output carries.
std::string refuse_standard_output(const std::string& path);

/// Tests, before hours are spent, whether write_output() could write to `path` (if not empty).
/// Nothing is left behind. Returns an exit code and says on standard error why not.
int check_output(const std::string& path);

/// Writes to a file, or to standard output if `path` is "-" (which main() tests at the end); on a terminal printable_lines() of it.
/// Returns an exit code and says on standard error why it failed.
int write_output(const std::string& path, std::string_view bytes);

/// With those above it, if it is not there. Errors: InputOutput.
Errors make_directory(const std::string& path);

/// A word as a shell reads it.
std::string shell_quoted(const std::string& word);

/// Prints every error to standard error as "coapt: SOURCE: POINTER: message"; returns kBadInput.
int report_errors(const std::string& source, const Errors& errors);

/// The same for values that came from options of `command`: "/ap_mm" is printed as "--ap-mm", and
/// members of `options` as it says ({"/tips_mm", "--tips"}).
int report_option_errors(const std::string& command, Errors errors,
                         const std::map<std::string, std::string>& options = {});

}  // namespace coapt
