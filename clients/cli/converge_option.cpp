#include "clients/cli/converge_option.h"

#include <limits>

namespace coapt {

void add_converge_option(Command command, ConvergeOption& option) {
  const Option converge = command.add_flag(
      "--converge", option.wanted,
      "Refine the mesh, with four times the triangles at each level, until the leak has converged");
  command
      .add_option("--within", option.within_mm2,
                  "Convergence criterion of --converge: largest change of the leak between two "
                  "levels (default: the larger of 0.5 mm2 and 5 % of the leak)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2")
      .needs(converge);
  command
      .add_option("--most-vertices", option.most_vertices,
                  "Largest number of vertices of a mesh made by --converge; 21,000 vertices take "
                  "about a minute")
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
