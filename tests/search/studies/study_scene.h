// Studies that close nothing: the orifice is a function of where the tips lie.
#pragma once

#include <functional>

#include "search/studies/geometry_studies.h"
#include "tests/scenes/small_valve.h"

namespace coapt {

using OrificeOf = std::function<double(const Vec3& displacement_mm)>;

inline DisplacementGrid grid_of(Displaced displaced, int nodes, double step_mm,
                                const OrificeOf& area_mm2, int ring_sizes_below = 0) {
  DisplacementGrid grid{displaced, ring_sizes_below, nodes, step_mm, {}};
  for (int t = 0; t < nodes; ++t)
    for (int p = 0; p < nodes; ++p)
      for (int a = 0; a < nodes; ++a) grid.area_mm2.push_back(area_mm2(step_mm * Vec3(t, p, a)));
  return grid;
}

/// What is known at every whole millimetre from `low` to `high` along each axis, for all classes.
inline OrificeTableOptions known_at_nodes(int low, int high, const OrificeOf& area_mm2) {
  OrificeTableOptions options;
  for (const Displaced displaced : kDisplaced)
    for (int t = low; t <= high; ++t)
      for (int p = low; p <= high; ++p)
        for (int a = low; a <= high; ++a)
          options.known[key_of(displacement(displaced, Vec3(t, p, a)))] = {area_mm2(Vec3(t, p, a)),
                                                                           0.0, true};
  return options;
}

/// Of the small valve, one end state a closure: quick.
inline OrificeTable small_table(OrificeTableOptions options) {
  options.closure.samples = 1;
  return OrificeTable(small_valve(), std::move(options));
}

}  // namespace coapt
