#include "core/closure/hinges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace coapt {
namespace {

constexpr double kLeastArea = 0.2;  // of the unstressed one
constexpr double kLeastHalfCosine = 1e-3;

Vec3 corner(const Points& x, int node) { return x.row(node); }

/// Of the squared cross product of two sides, from what it is at rest.
double least_of(double twice_area_mm2) { return std::pow(kLeastArea * twice_area_mm2, 2); }

/// Angle / 4 has this tangent.
double quarter(const HingeTurn& now) { return 0.25 * now.t; }

}  // namespace

double least_mm4(const Points& rest_mm, const Faces& faces, Index face) {
  const Vec3 a = corner(rest_mm, faces(face, 0));
  const Vec3 ab = corner(rest_mm, faces(face, 1)) - a, ac = corner(rest_mm, faces(face, 2)) - a;
  return least_of(ab.cross(ac).norm());
}

std::vector<Hinge> make_hinges(const Valve& valve) {
  std::vector<Hinge> hinges;
  if (valve.tissue.bending_n_mm == 0.0) return hinges;
  std::map<std::pair<int, int>, int> opposite;  // [directed edge]: the third vertex of its face
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      opposite[{valve.faces(f, k), valve.faces(f, (k + 1) % 3)}] = valve.faces(f, (k + 2) % 3);
  for (const auto& [edge, third] : opposite) {
    if (edge.first > edge.second) continue;
    const auto other = opposite.find({edge.second, edge.first});
    if (other == opposite.end()) continue;
    Hinge hinge;
    hinge.node = {edge.first, edge.second, third, other->second};
    const Vec3 x0 = corner(valve.rest_mm, hinge.node[0]);
    const Vec3 e = corner(valve.rest_mm, hinge.node[1]) - x0;
    const std::array<double, 2> twice_area = {
        e.cross(corner(valve.rest_mm, hinge.node[2]) - x0).norm(),
        e.cross(corner(valve.rest_mm, hinge.node[3]) - x0).norm()};
    const double areas = 0.5 * (twice_area[0] + twice_area[1]);
    hinge.stiffness_n_mm = valve.tissue.bending_n_mm * e.squaredNorm() / areas;
    hinge.least_mm4 = {least_of(twice_area[0]), least_of(twice_area[1])};
    hinge.rest = turn(hinge, valve.rest_mm).t;
    hinges.push_back(hinge);
  }
  return hinges;
}

HingeTurn turn(const Hinge& hinge, const Points& x) {
  const Vec3 x0 = corner(x, hinge.node[0]);
  const Vec3 e = corner(x, hinge.node[1]) - x0, to2 = corner(x, hinge.node[2]) - x0,
             to3 = corner(x, hinge.node[3]) - x0;
  const Vec3 n1 = e.cross(to2), n2 = to3.cross(e);
  const double e2 = e.squaredNorm(), length = std::sqrt(e2);
  const double q1 = std::max(n1.squaredNorm(), hinge.least_mm4[0]);
  const double q2 = std::max(n2.squaredNorm(), hinge.least_mm4[1]);
  const double per_areas = 1.0 / std::sqrt(q1 * q2);
  const double cosine = std::clamp(n1.dot(n2) * per_areas, -1.0, 1.0);
  const double sine = n1.cross(n2).dot(e) * per_areas / length;
  const double half_cosine = std::sqrt(0.5 * (1.0 + cosine));
  const double half_sine = 0.5 * sine / std::max(half_cosine, kLeastHalfCosine);
  HingeTurn now;
  now.t = 4.0 * half_sine / (1.0 + half_cosine);
  now.gradient[2] = (-length / q1) * n1;
  now.gradient[3] = (-length / q2) * n2;
  const double s1 = to2.dot(e) / e2, s2 = to3.dot(e) / e2;
  now.gradient[0] = (s1 - 1.0) * now.gradient[2] + (s2 - 1.0) * now.gradient[3];
  now.gradient[1] = -s1 * now.gradient[2] - s2 * now.gradient[3];
  now.size[2] = length / std::sqrt(q1);
  now.size[3] = length / std::sqrt(q2);
  now.size[0] = std::abs(s1 - 1.0) * now.size[2] + std::abs(s2 - 1.0) * now.size[3];
  now.size[1] = std::abs(s1) * now.size[2] + std::abs(s2) * now.size[3];
  return now;
}

double hinge_energy(const Hinge& hinge, const Points& x) {
  // The integral of the moment over the angle.
  const double now = std::atan(quarter(turn(hinge, x))), rest = std::atan(0.25 * hinge.rest);
  const auto integral = [](double quarter_angle) {
    return -16.0 * std::log(std::cos(quarter_angle));
  };
  return hinge.stiffness_n_mm * (integral(now) - integral(rest) - 4.0 * hinge.rest * (now - rest));
}

void add_hinge_forces(const Hinge& hinge, const Points& x, Points& force) {
  const HingeTurn now = turn(hinge, x);
  const double moment = hinge.stiffness_n_mm * (now.t - hinge.rest);
  for (std::size_t k = 0; k < 4; ++k) force.row(hinge.node[k]) -= moment * now.gradient[k];
}

std::array<double, 4> row_sums(const Hinge& hinge, const Points& x) {
  const HingeTurn now = turn(hinge, x);
  std::array<double, 4> sums = now.size;
  const double turned = std::abs(now.t - hinge.rest);
  const double stiffness = hinge.stiffness_n_mm * (1.0 + quarter(now) * quarter(now) + turned) *
                           std::accumulate(sums.begin(), sums.end(), 0.0);
  for (double& sum : sums) sum *= stiffness;
  // As the hinge turns, its gradients turn and grow: what the first term does not cover.
  const double per_mm = 1.0 / (corner(x, hinge.node[1]) - corner(x, hinge.node[0])).norm();
  const double moment_n = hinge.stiffness_n_mm * turned * per_mm;
  for (std::size_t k = 0; k < 2; ++k)
    sums[k] += moment_n * (3.0 * (now.size[2] + now.size[3]) + 4.0 * per_mm);
  for (std::size_t k = 2; k < 4; ++k) sums[k] += 2.0 * moment_n * now.size[k];
  return sums;
}

}  // namespace coapt
