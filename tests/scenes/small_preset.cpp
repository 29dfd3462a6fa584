#include "tests/scenes/small_preset.h"

#include <map>
#include <utility>

#include "core/presets/presets.h"

namespace coapt {

const Valve& shared_preset(const std::string& name, int triangles) {
  static std::map<std::pair<std::string, int>, Valve> made;
  const std::pair key(name, triangles);
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  return made.emplace(key, *make_preset(name, triangles)).first->second;
}

const Valve& small_preset(const std::string& name) { return shared_preset(name, 200); }

}  // namespace coapt
