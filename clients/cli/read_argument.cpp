#include "clients/cli/read_argument.h"

#include <algorithm>
#include <filesystem>

#include "core/presets/presets.h"
#include "core/valve/nearest_name.h"
#include "io/command_line/files.h"
#include "io/json/valve_json.h"

namespace coapt {
namespace {

std::string names_of_presets() {
  std::string names;
  for (const std::string& name : preset_names()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

bool is_preset(const std::string& name) {
  const std::vector<std::string>& names = preset_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Expected<Valve> read_argument(const std::string& argument,
                              Expected<Valve> (*read)(std::string_view)) {
  std::error_code ignored;
  if (argument != "-" && !std::filesystem::exists(argument, ignored)) {
    if (is_preset(argument)) return make_preset(argument);
    return Error{ErrorCode::InputOutput, "",
                 "no such file, and not a preset (" + names_of_presets() + ")" +
                     did_you_mean(argument, preset_names())};
  }
  const Expected<std::string> text = read_input(argument);
  if (!text) return text.errors();
  return read(*text);
}

}  // namespace

Expected<Valve> read_valve_argument(const std::string& argument) {
  return read_argument(argument, read_valve);
}

Expected<Valve> read_any_valve_argument(const std::string& argument) {
  return read_argument(argument, read_any_valve);
}

Expected<std::vector<NamedPlan>> read_plans_argument(const std::string& path) {
  const Expected<std::string> text = read_input(path);
  if (!text) return text.errors();
  return read_plans(*text);
}

Expected<RepairPlan> read_plan_argument(const std::string& path, int rank) {
  const Expected<std::vector<NamedPlan>> plans = read_plans_argument(path);
  if (!plans) return plans.errors();
  const auto count = std::ssize(*plans);
  if (rank > count)
    return Error{ErrorCode::OutOfRange, "",
                 "has no plan " + std::to_string(rank) + "; --rank must be from 1 to " +
                     std::to_string(count)};
  return (*plans)[static_cast<std::size_t>(rank - 1)].plan;
}

}  // namespace coapt
