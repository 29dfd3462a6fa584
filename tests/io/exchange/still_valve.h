// The small valve as if its closure had left it where it was: what files say of it can be told by hand.
#pragma once

#include "io/exchange/exported_valve.h"
#include "tests/scenes/small_valve.h"

namespace coapt {

/// Two states of motion: lifted by 2 mm (with all branch points and heads), then at rest.
inline ClosedValve still_valve() {
  ClosedValve exported;
  exported.valve = small_valve();
  const Valve& valve = exported.valve;
  exported.closure.status = ClosureStatus::Converged;
  exported.closure.closed_mm = valve.rest_mm;
  exported.closure.branch_points_mm = unstressed_shape(valve).chorda_ends_mm;
  exported.closure.tension_n = {{1.5, 0.75, 0.75}, {0.25}};
  Points state(valve.rest_mm.rows() + 1 + 2, 3);
  state << valve.rest_mm, valve.chordae[0].segments[0].branch_point_mm.transpose(),
      valve.heads[0].tip_mm.transpose(), valve.heads[1].tip_mm.transpose();
  Points lifted = state;
  lifted.col(2).array() += 2.0;
  exported.closure.motion_mm = {lifted, state};
  exported.measure = measure(valve, exported.closure);
  return exported;
}

}  // namespace coapt
