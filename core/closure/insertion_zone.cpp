#include "core/closure/insertion_zone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/closure/contact.h"

namespace coapt {
namespace {

constexpr double kPartsPerRadius =
    8.0;  // of a face's edge: the cone is integrated over small faces
constexpr int kMostParts = 40;

std::array<Vec3, 3> corners_of(const Valve& valve, Index face) {
  return {valve.rest_mm.row(valve.faces(face, 0)), valve.rest_mm.row(valve.faces(face, 1)),
          valve.rest_mm.row(valve.faces(face, 2))};
}

double longest_edge_mm(const std::array<Vec3, 3>& c) {
  return std::sqrt(std::max(
      {(c[0] - c[1]).squaredNorm(), (c[1] - c[2]).squaredNorm(), (c[2] - c[0]).squaredNorm()}));
}

/// Faces that have a point within the radius and are joined to the first by such faces.
std::vector<Index> faces_around(const Valve& valve, int first, const Vec3& centre,
                                double radius_mm) {
  std::vector<Index> near;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const auto c = corners_of(valve, f);
    const double reach = radius_mm + longest_edge_mm(c);
    if ((c[0] - centre).squaredNorm() >= reach * reach) continue;
    const Vec3 w = closest_point_weights(centre, c[0], c[1], c[2]);
    if (f == first || (w[0] * c[0] + w[1] * c[1] + w[2] * c[2] - centre).norm() < radius_mm)
      near.push_back(f);
  }
  std::set<int> reached = {valve.faces(first, 0), valve.faces(first, 1), valve.faces(first, 2)};
  std::vector<Index> joined;
  for (bool more = true; more;) {
    more = false;
    for (Index& f : near) {
      if (f < 0) continue;
      const std::array<int, 3> nodes = {valve.faces(f, 0), valve.faces(f, 1), valve.faces(f, 2)};
      if (std::none_of(nodes.begin(), nodes.end(), [&](int n) { return reached.contains(n); }))
        continue;
      reached.insert(nodes.begin(), nodes.end());
      joined.push_back(f);
      f = -1;
      more = true;
    }
  }
  std::sort(joined.begin(), joined.end());
  return joined;
}

}  // namespace

std::vector<NodeShare> insertion_zone(const Valve& valve, const Insertion& insertion,
                                      double radius_mm) {
  const Vec3 centre = position(insertion, valve.faces, valve.rest_mm);
  std::map<int, double> weights;
  double sum = 0.0;
  if (radius_mm > 0.0)
    for (const Index f : faces_around(valve, insertion.face, centre, radius_mm)) {
      const auto [a, b, c] = corners_of(valve, f);
      const int parts = std::clamp(
          static_cast<int>(std::ceil(kPartsPerRadius * longest_edge_mm({a, b, c}) / radius_mm)), 1,
          kMostParts);
      const double part = 1.0 / parts;
      const Vec3 from = a - centre, ab = part * (b - a), ac = part * (c - a);
      // Small faces in rows; every second one of a row is upside down.
      std::array<double, 3> shares = {0.0, 0.0, 0.0};
      for (int i = 0; i < parts; ++i)
        for (int j = 0; j < 2 * (parts - i) - 1; ++j) {
          const double third = (j % 2 == 0 ? 1.0 : 2.0) / 3.0;
          const double u = i + third, v = j / 2 + third;
          const double away2 = (from + u * ab + v * ac).squaredNorm();
          if (away2 >= radius_mm * radius_mm) continue;
          const double cone = radius_mm - std::sqrt(away2);
          shares[0] += cone * (parts - u - v);
          shares[1] += cone * u;
          shares[2] += cone * v;
        }
      const double each = ab.cross(ac).norm();  // twice the area of a small face
      for (int k = 0; k < 3; ++k) {
        weights[valve.faces(f, k)] += each * part * shares[k];
        sum += each * part * shares[k];
      }
    }
  if (sum <= 0.0)
    for (int k = 0; k < 3; ++k) {
      weights[valve.faces(insertion.face, k)] += insertion.weights[k];
      sum += insertion.weights[k];
    }
  std::vector<NodeShare> shares;
  for (const auto& [node, weight] : weights)
    if (weight > 0.0) shares.push_back({node, weight / sum});
  return shares;
}

}  // namespace coapt
