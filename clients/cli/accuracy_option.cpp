#include <iostream>
#include <limits>

#include "clients/cli/closure_options.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "io/command_line/command_line.h"
#include "io/picture/text.h"

namespace coapt {

void add_accuracy_option(Command command, std::optional<double>& accuracy_mm2) {
  command
      .add_option("--accuracy", accuracy_mm2,
                  "Largest error of the orifice from stopping early, mm2, in 99 of 100 scenes: "
                  "uses the fastest tolerances measured to keep it (method fast)")
      .check(number_from(0.0, std::numeric_limits<double>::max()))
      .show_argument("MM2");
}

Expected<std::optional<AccuracyTier>> apply_accuracy(std::optional<double> accuracy_mm2,
                                                     ClosureOptions& closure) {
  if (!accuracy_mm2) return std::optional<AccuracyTier>();
  if (closure.method != Method::Fast)
    return Error{ErrorCode::Unsupported, "/accuracy",
                 "is known for method fast only; leave out --method thesis"};
  const Expected<AccuracyTier> tier = choose_tier(*accuracy_mm2, closure.membrane);
  if (!tier) return tier.errors();
  closure = at_tier(closure, *tier);
  const TierError& error = error_of(*tier, closure.membrane);
  std::cerr << "coapt: accuracy: residual " << tier->residual_tolerance << ", predicted way "
            << tier->way_tolerance_mm << " mm, membrane " << to_string(closure.membrane)
            << ": orifice within " << error.p99_mm2 << " mm2 of this mesh's own end in 99 of 100 "
            << "measured scenes, " << error.max_mm2 << " in all, at " << error.relative_time
            << " times the default's time; the error of the mesh is another\n";
  return std::optional<AccuracyTier>(*tier);
}

}  // namespace coapt
