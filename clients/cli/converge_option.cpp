#include "clients/cli/converge_option.h"

#include <chrono>
#include <limits>
#include <vector>

#include "io/json/result_json.h"

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

TimedConvergence converge(const Valve& valve, const ConvergeOption& option,
                          const ClosureOptions& closure) {
  using Clock = std::chrono::steady_clock;
  MeshConvergenceOptions options;
  options.closure = closure;
  options.most_vertices = option.most_vertices;
  if (option.within_mm2) {
    options.within_mm2 = *option.within_mm2;
    options.within_share = 0.0;
  }
  std::vector<double> seconds;
  Clock::time_point started = Clock::now();
  MeshConvergence convergence = close_until_settled(valve, options, [&](const MeshLevel&) {
    seconds.push_back(std::chrono::duration<double>(Clock::now() - started).count());
    started = Clock::now();
  });
  Json json = to_json(convergence, options);
  for (std::size_t i = 0; i < seconds.size(); ++i) json["levels"][i]["seconds"] = seconds[i];
  return {std::move(convergence), std::move(json)};
}

}  // namespace coapt
