#include "clients/cli/converge_option.h"

#include <limits>

namespace coapt {

void add_converge_option(Command command, ConvergeOption& option) {
  const Option converge = command.add_flag(
      "--converge", option.wanted,
      "Close on finer and finer meshes, each with four times the triangles, until the leak stands");
  command
      .add_option("--within", option.within_mm2,
                  "Largest change of the leak from one mesh to the next that ends --converge "
                  "(default: the larger of 0.5 mm2 and 5 % of the leak)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2")
      .needs(converge);
  command
      .add_option("--most-vertices", option.most_vertices,
                  "Of a mesh that --converge makes; one of 21,000 takes a minute")
      .check(number_from(6, 100000))
      .show_default()
      .needs(converge);
}

Json converge_json(const ConvergeOption& option) {
  Json json = {{"most_vertices", option.most_vertices}};
  if (option.within_mm2) json["within_mm2"] = *option.within_mm2;
  return json;
}

}  // namespace coapt
