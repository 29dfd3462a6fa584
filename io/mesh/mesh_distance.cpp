#include "io/mesh/mesh_distance.h"

#include <algorithm>

#include "core/closure/contact.h"

namespace coapt {

double distance_mm(const std::vector<TriangleMesh>& sheets, const Vec3& point) {
  double best = 1e300;
  for (const TriangleMesh& sheet : sheets) {
    for (Eigen::Index f = 0; f < sheet.faces.rows(); ++f) {
      const Vec3 a = sheet.vertices_mm.row(sheet.faces(f, 0)),
                 b = sheet.vertices_mm.row(sheet.faces(f, 1)),
                 c = sheet.vertices_mm.row(sheet.faces(f, 2));
      const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      const Vec3 outside = (low - point).cwiseMax(point - high).cwiseMax(0.0);
      if (outside.norm() >= best) continue;
      const Vec3 weights = closest_point_weights(point, a, b, c);
      best = std::min(best, (weights[0] * a + weights[1] * b + weights[2] * c - point).norm());
    }
  }
  return best;
}

}  // namespace coapt
