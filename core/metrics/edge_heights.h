// How high tissue lies beside a point of a view: at the nearest edge of the mesh in that view, because every line of
// an orifice's outline is that of an edge, or runs beside one by half the tissue's thickness.
#pragma once

#include <vector>

#include "core/metrics/annulus.h"

namespace coapt {

class EdgeHeights {
 public:
  /// @param closed_mm |V| x 3, finite.
  EdgeHeights(const Faces& faces, const Points& closed_mm, const AnnulusFrame& plane);

  /// Above the plane, of the nearest edge. Takes as long as there are edges.
  double at(const Vec2& point_mm) const;

 private:
  struct Edge {
    Vec2 from_mm, along_mm;     // in the plane
    double height_mm, rise_mm;  // at its start; from there to its end
  };
  std::vector<Edge> edges_;
};

}  // namespace coapt
