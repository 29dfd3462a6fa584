#include "operations/operation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace coapt {
namespace {

using namespace door;

constexpr std::array<std::pair<unsigned, const char*>, 5> kDoors = {{{kCommandLine, "command_line"},
                                                                     {kService, "service"},
                                                                     {kPython, "python"},
                                                                     {kBrowser, "browser"},
                                                                     {kFarm, "farm"}}};

}  // namespace

std::vector<std::string> door_names(unsigned doors) {
  std::vector<std::string> names;
  for (const auto& [one, name] : kDoors)
    if ((doors & one) != 0) names.emplace_back(name);
  return names;
}

const Operation* operation_at(std::span<const Operation> among, std::string_view path) {
  const auto found = std::find_if(among.begin(), among.end(), [&](const Operation& one) {
    return one.read != nullptr && path == one.path;
  });
  return found == among.end() ? nullptr : &*found;
}

}  // namespace coapt
