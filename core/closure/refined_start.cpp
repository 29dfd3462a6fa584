#include "core/closure/refined_start.h"

#include "core/valve/subdivide.h"

namespace coapt {

ClosureResult refined_start(const Valve& valve, const ClosureResult& closed) {
  ClosureResult start;
  start.method = closed.method;
  start.membrane = closed.membrane;
  start.status = closed.status;
  start.crossing = closed.crossing;
  start.closed_mm = with_midpoints(closed.closed_mm,
                                   subdivide(valve.faces, static_cast<int>(valve.rest_mm.rows())));
  start.branch_points_mm = closed.branch_points_mm;
  for (const int face : closed.guarded_faces)
    for (int part = 0; part < 4; ++part) start.guarded_faces.push_back(4 * face + part);
  return start;
}

}  // namespace coapt
