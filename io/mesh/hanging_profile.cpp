#include "io/mesh/hanging_profile.h"

#include <utility>

#include "core/metrics/section.h"

namespace coapt {
namespace {

constexpr double kStep_mm = 1.0;  // of the length that is measured: finer steps follow noise

/// From one point to the next at least kStep_mm away, and to the last.
double coarse_length_mm(const std::vector<Vec3>& line) {
  double sum = 0.0;
  Vec3 from = line.front();
  for (const Vec3& point : line) {
    if ((point - from).norm() < kStep_mm) continue;
    sum += (point - from).norm();
    from = point;
  }
  return sum + (line.back() - from).norm();
}

}  // namespace

std::optional<ExposedLeaflet> exposed_leaflet(const TriangleMesh& sheet, const Vec3& annulus_mm,
                                              double reach_mm) {
  std::optional<ExposedLeaflet> found;
  double nearest = reach_mm;
  for (const SectionLine& line : cut(sheet.faces, sheet.vertices_mm, {annulus_mm, Vec3::UnitX()})) {
    const Vec3 &first = line.points_mm.front(), &last = line.points_mm.back();
    for (const auto& [near, far] : {std::pair(first, last), std::pair(last, first)}) {
      const double distance = (near - annulus_mm).norm();
      if (distance > nearest) continue;
      nearest = distance;
      found = {distance + coarse_length_mm(line.points_mm), far};
    }
  }
  return found;
}

}  // namespace coapt
