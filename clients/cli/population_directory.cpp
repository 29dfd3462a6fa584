#include "clients/cli/population_directory.h"

#include <filesystem>

#include "io/command_line/files.h"
#include "io/json/population_json.h"

namespace coapt {

Expected<Population> read_population_directory(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const Expected<std::string> text = read_input(
      fs::is_directory(path, ignored) ? (fs::path(path) / "population.json").string() : path);
  if (!text) return text.errors();
  return read_population(*text);
}

}  // namespace coapt
