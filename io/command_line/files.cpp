#include "io/command_line/files.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"

namespace coapt {
namespace {

Error larger_than(std::size_t most_bytes) {
  return {ErrorCode::InputOutput, "", "larger than " + std::to_string(most_bytes >> 20) + " MiB"};
}

/// @param expected_bytes 0: not known.
Expected<std::string> read_stream(std::istream& stream, std::size_t most_bytes,
                                  std::size_t expected_bytes = 0) {
  if (expected_bytes > most_bytes) return larger_than(most_bytes);
  std::string bytes;
  bytes.reserve(expected_bytes);
  std::string block(std::size_t{1} << 16, '\0');
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) ||
         stream.gcount() > 0) {
    bytes.append(block, 0, static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > most_bytes) return larger_than(most_bytes);
  }
  if (stream.bad()) return Error{ErrorCode::InputOutput, "", "cannot be read"};
  return bytes;
}

int report_unwritable(const std::string& path) {
  std::cerr << "coapt: " << printable(path) << ": cannot be written\n";
  return exit_code::kFailure;
}

}  // namespace

Expected<std::string> read_input(const std::string& path, std::size_t most_bytes) {
  if (path == "-") {
    if (std::cin.eof())
      return Error{ErrorCode::InputOutput, "", "standard input can be read only once"};
    return read_stream(std::cin, most_bytes);
  }
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    return Error{ErrorCode::InputOutput, "", "is a directory"};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{ErrorCode::InputOutput, "", "cannot be opened"};
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  return read_stream(file, most_bytes, unknown ? 0 : size);
}

std::string refuse_standard_output(const std::string& path) {
  return path == "-" ? "must be a file, because the result is written to standard output" : "";
}

int check_output(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status before = fs::status(path, ignored);
  // Opening and closing a pipe would end it for its reader.
  if (path.empty() || fs::is_fifo(before)) return exit_code::kOk;
  if (!std::ofstream(path, std::ios::app)) return report_unwritable(path);
  if (!fs::exists(before)) fs::remove(path, ignored);
  return exit_code::kOk;
}

int write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    if (isatty(STDOUT_FILENO) == 1)
      std::cout << printable_lines(bytes);
    else
      std::cout << bytes;
    return exit_code::kOk;
  }
  std::ofstream file(path, std::ios::binary);
  if (file && file << bytes << std::flush) return exit_code::kOk;
  return report_unwritable(path);
}

Errors make_directory(const std::string& path) {
  std::error_code failed;
  std::filesystem::create_directories(path, failed);
  if (!failed) return {};
  return {Error{ErrorCode::InputOutput, "", path + ": cannot be created: " + failed.message()}};
}

std::string shell_quoted(const std::string& word) {
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("-_./:,+", c) != nullptr;
  });
  if (plain && !word.empty()) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + '\'';
}

int report_errors(const std::string& source, const Errors& errors) {
  for (const Error& error : errors) {
    std::cerr << "coapt: " << printable(source) << ": ";
    if (!error.path.empty()) std::cerr << printable(error.path) << ": ";
    std::cerr << printable(error.message) << '\n';
  }
  return exit_code::kBadInput;
}

int report_option_errors(const std::string& command, Errors errors,
                         const std::map<std::string, std::string>& options) {
  for (Error& error : errors) {
    if (error.path.empty()) continue;
    const std::string field = error.path.substr(0, error.path.find('/', 1));
    const auto known = options.find(field);
    std::string option = known != options.end() ? known->second : "--" + field.substr(1);
    std::replace(option.begin(), option.end(), '_', '-');
    error.path.replace(0, field.size(), option);
  }
  return report_errors(command, errors);
}

}  // namespace coapt
