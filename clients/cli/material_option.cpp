#include "clients/cli/material_option.h"

#include <algorithm>

namespace coapt {

std::string flag_of(const Dimension& dimension) {
  std::string flag = "--" + std::string(dimension.name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag == "--pressure-mmhg" ? "--pressure" : flag;
}

void add_material_option(Command command, MaterialOption& option) {
  const std::vector<const Dimension*> table = material_table();
  option.given.resize(table.size());
  for (std::size_t m = 0; m < table.size(); ++m)
    command.add_option(flag_of(*table[m]), option.given[m], table[m]->what)
        .group("Pressure and tissue, overriding the valve's own")
        .show_default("the valve's");
}

bool is_given(const MaterialOption& option) { return !values_of(option).empty(); }

std::vector<MaterialValue> values_of(const MaterialOption& option) {
  std::vector<MaterialValue> values;
  const std::vector<const Dimension*> table = material_table();
  for (std::size_t m = 0; m < option.given.size(); ++m)
    if (option.given[m]) values.push_back({table[m], *option.given[m]});
  return values;
}

Json material_json(const MaterialOption& option) {
  Json json = Json::object();
  for (const auto& [dimension, value] : values_of(option)) json[dimension->name] = value;
  return json;
}

}  // namespace coapt
