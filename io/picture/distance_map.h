// Where a closed shape lies off another: its leaflets from either side, coloured by signed distance.
#pragma once

#include <string>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct DistanceMap {
  Points vertices_mm;             ///< n x 3
  Faces faces;                    ///< m x 3
  std::vector<double> signed_mm;  ///< n
  double range_mm = 1.0;          ///< where the colours end: red at +, blue at -
  std::string title, caption;     ///< a line each
  std::string doubt{};            ///< a line in the colour of warnings; empty: none
};

/// PNG bytes. Seen from where the mean normal of the faces points (of coapt's leaflets: the atrium) and from behind, with
/// y upwards as far as the view allows.
std::string distance_map_png(const DistanceMap& map);

/// The end of a colour scale for these distances: 1, 2 or 5 times a power of ten, not below their 95th percentile.
double round_range_mm(double p95_mm);

}  // namespace coapt
