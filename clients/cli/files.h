// What commands read and write: files, standard input and output, presets.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/valve.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// Help text of an argument read by read_valve_argument.
inline constexpr const char* kValveHelp =
    "Valve file (coapt.valve/1), - for standard input, or the name of a preset if there is no such "
    "file";

/// The bytes of a file, or of standard input if `path` is "-", which can be read once; at most 64
/// MiB.
Expected<std::string> read_input(const std::string& path);

/// A valve file, standard input ("-"), or a preset if no file has that name.
Expected<Valve> read_valve_argument(const std::string& argument);

/// The same; the file may also hold a valve that is not mitral (coapt.valve/2).
Expected<Valve> read_any_valve_argument(const std::string& argument);

/// The plans of a file or of standard input ("-"): see io/json/plan_document.h.
Expected<std::vector<NamedPlan>> read_plans_argument(const std::string& path);

/// The one of them at `rank`, from 1.
Expected<RepairPlan> read_plan_argument(const std::string& path, int rank = 1);

/// A usage error if `path` is "-": for outputs beside a result that standard output carries.
std::string refuse_standard_output(const std::string& path);

/// Tests, before hours are spent, whether write_output() could write to `path` (if not empty).
/// Nothing is left behind. Returns an exit code and says on standard error why not.
int check_output(const std::string& path);

/// Writes to a file, or to standard output if `path` is "-" (which main() tests at the end). Returns
/// an exit code and says on standard error why it failed.
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
