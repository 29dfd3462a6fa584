// Everything that is drawn of a closed valve, in one document (coapt.scene/2), and of an open one.
#pragma once

#include "core/opened/opened_valve.h"
#include "core/repair/plan.h"
#include "core/valve/valve.h"
#include "io/json/json.h"

namespace coapt {

inline constexpr int kMostFrames = 60;  ///< that the service answers with

struct Scene {
  const Valve& valve;  ///< repaired, if it is
  const ClosureResult& closure;
  const Leak& leak;        ///< of that closure
  const RepairPlan& plan;  ///< of the repair: its sutures and seams are drawn
  int frames = 0;          ///< of the motion (ClosureResult::motion_mm), at most; 0: none
};

/// Long lists of points are flat, [x, y, z, x, y, z, ...], rounded to 0.001 mm; so are strains and tensions, to four
/// digits after the point. Sections are 0.025 apart along the line between the commissures. Of a closure
/// that flew apart there is no closed_mm, but null.
Json scene_to_json(const Scene& scene);

/// What is drawn of a valve that is not closed: all that does not move, and closed_mm null. `plan`: as of a Scene.
Json unloaded_scene_to_json(const Valve& valve, const RepairPlan& plan);

/// What is drawn of an open valve (coapt.opening/2 names it scene), written alike; `frames` as of a Scene. Of an opening that
/// flew apart there is no open_mm, but null.
Json opening_scene_to_json(const OpenedValve& opened, int frames);

}  // namespace coapt
