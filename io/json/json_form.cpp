#include "io/json/json_form.h"

#include "io/json/json.h"

namespace coapt {
namespace {

bool same_type(const Json& a, const Json& b) {
  return a.is_null() || b.is_null() || a.type() == b.type() || (a.is_number() && b.is_number());
}

}  // namespace

std::string differs_in_form(const Json& example, const Json& json) {
  if (!same_type(example, json)) return "/";
  if (json.is_null() || example.is_null()) return "";
  if (example.is_object()) {
    for (const auto& [name, value] : example.items()) {
      const auto found = json.find(name);
      if (found == json.end()) return '/' + name;
      if (const std::string inside = differs_in_form(value, *found); !inside.empty())
        return '/' + name + (inside == "/" ? "" : inside);
    }
  } else if (example.is_array() && !example.empty()) {
    for (std::size_t i = 0; i < json.size(); ++i)
      if (const std::string inside = differs_in_form(example.front(), json[i]); !inside.empty())
        return '/' + std::to_string(i) + (inside == "/" ? "" : inside);
  }
  return "";
}

}  // namespace coapt
