#include "core/metrics/edge_heights.h"

#include <algorithm>
#include <limits>

namespace coapt {

EdgeHeights::EdgeHeights(const Faces& faces, const Points& closed_mm, const AnnulusFrame& plane) {
  const auto height_mm = [&](const Vec3& point) {
    return (point - plane.origin_mm).dot(plane.normal);
  };
  for (Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Vec3 from = closed_mm.row(faces(f, k)), to = closed_mm.row(faces(f, (k + 1) % 3));
      const Vec2 from_mm = project(plane, from);
      edges_.push_back({from_mm, project(plane, to) - from_mm, height_mm(from),
                        height_mm(to) - height_mm(from)});
    }
}

double EdgeHeights::at(const Vec2& point_mm) const {
  double nearest = std::numeric_limits<double>::infinity(), height_mm = 0.0;
  for (const Edge& edge : edges_) {
    const Vec2 way = point_mm - edge.from_mm;
    const double length = edge.along_mm.squaredNorm();
    const double share = length > 0.0 ? std::clamp(way.dot(edge.along_mm) / length, 0.0, 1.0) : 0.0;
    const double distance = (way - share * edge.along_mm).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    height_mm = edge.height_mm + share * edge.rise_mm;
  }
  return height_mm;
}

}  // namespace coapt
