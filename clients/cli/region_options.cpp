#include "clients/cli/commands.h"
#include "clients/cli/number_option.h"

namespace coapt {

void add_region_options(CLI::App& command, SearchOptions& options) {
  command.add_option("--threads", options.threads, "0: all cores; the plans are the same")
      ->check(number_from(0, 1024))
      ->capture_default_str();
  command
      .add_option("--region-points", options.region_points,
                  "Perturbations, of 1089, at which each ranked plan is scored")
      ->check(number_from(1, 1089))
      ->capture_default_str();
}

}  // namespace coapt
