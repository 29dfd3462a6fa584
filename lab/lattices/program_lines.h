#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace coapt {

/// Standard output of a command, line by line. @param status where its exit status goes, -1 if it could not be started; may be null.
inline std::vector<std::string> lines_of(const std::string& command, int* status = nullptr) {
  if (status != nullptr) *status = -1;
  std::vector<std::string> lines;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return lines;
  char line[512];
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    lines.emplace_back(line);
    if (!lines.back().empty() && lines.back().back() == '\n') lines.back().pop_back();
  }
  const int ended = pclose(pipe);
  if (status != nullptr) *status = ended;
  return lines;
}

}  // namespace coapt
