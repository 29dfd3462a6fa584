#include "core/metrics/leaflet_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/closure/contact.h"
#include "core/metrics/coaptation.h"
#include "core/metrics/leaflet_sides.h"
#include "core/metrics/quantile.h"

namespace coapt {
namespace {

std::array<Vec3, 3> corners(const Valve& valve, const Points& points, Index face) {
  return {points.row(valve.faces(face, 0)), points.row(valve.faces(face, 1)),
          points.row(valve.faces(face, 2))};
}

double area(const std::array<Vec3, 3>& c) { return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm(); }

/// [vertex]: whether a face of a leaflet that has not this vertex lies within `reach_mm` of it.
/// @param leaflet_of of each face
std::vector<bool> touching(const Valve& valve, const Points& closed_mm, double reach_mm,
                           const std::vector<int>& leaflet_of) {
  std::vector<std::set<int>> leaflets(valve.rest_mm.rows());
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) leaflets[valve.faces(f, k)].insert(leaflet_of[f]);
  Boxes vertices{closed_mm.array() - reach_mm, closed_mm.array() + reach_mm};
  Boxes faces{Points(valve.faces.rows(), 3), Points(valve.faces.rows(), 3)};
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const auto [a, b, c] = corners(valve, closed_mm, f);
    faces.low_mm.row(f) = a.cwiseMin(b).cwiseMin(c);
    faces.high_mm.row(f) = a.cwiseMax(b).cwiseMax(c);
  }
  std::vector<bool> found(valve.rest_mm.rows(), false);
  for (const auto& [v, f] : overlapping(vertices, faces)) {
    if (found[v] || leaflets[v].contains(leaflet_of[f])) continue;
    const auto [a, b, c] = corners(valve, closed_mm, f);
    const Vec3 p = closed_mm.row(v);
    const Vec3 w = closest_point_weights(p, a, b, c);
    found[v] = (w[0] * a + w[1] * b + w[2] * c - p).norm() <= reach_mm;
  }
  return found;
}

}  // namespace

std::array<double, 2> principal_stretches(const std::array<Vec3, 3>& rest_mm,
                                          const std::array<Vec3, 3>& closed_mm) {
  const Vec3 ab = rest_mm[1] - rest_mm[0], ac = rest_mm[2] - rest_mm[0];
  const Vec3 x = ab.normalized(), y = ab.cross(ac).cross(ab).normalized();
  Eigen::Matrix2d rest;
  rest << x.dot(ab), x.dot(ac), y.dot(ab), y.dot(ac);
  Eigen::Matrix<double, 3, 2> closed;
  closed << closed_mm[1] - closed_mm[0], closed_mm[2] - closed_mm[0];
  const Eigen::Matrix<double, 3, 2> gradient = closed * rest.inverse();
  const Eigen::Matrix2d c = gradient.transpose() * gradient;
  const double mean = 0.5 * c.trace();
  const double apart = Vec2(0.5 * (c(0, 0) - c(1, 1)), c(0, 1)).norm();
  return {std::sqrt(mean + apart), std::sqrt(std::max(0.0, mean - apart))};
}

std::vector<LeafletMeasure> measure_leaflets(const Valve& valve, const Points& closed_mm,
                                             double contact_distance_mm) {
  const double reach_mm = contact_distance_mm > 0.0
                              ? contact_distance_mm
                              : kContactThicknesses * valve.tissue.thickness_mm;
  std::vector<int> leaflet_of;
  for (int f = 0; f < valve.faces.rows(); ++f) leaflet_of.push_back(leaflet_index(valve, f));
  const std::vector<bool> touches = touching(valve, closed_mm, reach_mm, leaflet_of);
  std::vector<LeafletMeasure> leaflets(leaflet_count(valve));
  std::vector<std::vector<double>> stretches(leaflets.size());
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const int index = leaflet_of[f];
    LeafletMeasure& leaflet = leaflets[index];
    leaflet.name = leaflet_name(valve, f);
    const auto rest = corners(valve, valve.rest_mm, f), closed = corners(valve, closed_mm, f);
    leaflet.rest_area_mm2 += area(rest);
    leaflet.closed_area_mm2 += area(closed);
    for (int k = 0; k < 3; ++k)
      if (touches[valve.faces(f, k)]) leaflet.contact_share += area(closed) / 3.0;
    stretches[index].push_back(principal_stretches(rest, closed)[0]);
  }
  for (std::size_t i = 0; i < leaflets.size(); ++i) {
    if (leaflets[i].closed_area_mm2 > 0.0) leaflets[i].contact_share /= leaflets[i].closed_area_mm2;
    if (!stretches[i].empty()) leaflets[i].stretch_median = quantile(std::move(stretches[i]), 0.5);
  }
  return leaflets;
}

double coaptation_area_index(const Valve& valve, const Points& closed_mm) {
  if (!closed_mm.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<int> side_of;
  for (const Leaflet side : leaflet_sides(valve)) side_of.push_back(static_cast<int>(side));
  const std::vector<bool> touches =
      touching(valve, closed_mm, kContactThicknesses * valve.tissue.thickness_mm, side_of);
  double contact_mm2 = 0.0, all_mm2 = 0.0;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const double area_mm2 = area(corners(valve, closed_mm, f));
    all_mm2 += area_mm2;
    for (int k = 0; k < 3; ++k) contact_mm2 += touches[valve.faces(f, k)] ? area_mm2 / 3.0 : 0.0;
  }
  return contact_mm2 / all_mm2;
}

}  // namespace coapt
