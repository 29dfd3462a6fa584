#include "lab/twins/echo_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "search/random_share.h"

namespace coapt {
namespace {

/// Where a ray meets the leaflets first, moved up by half the thickness.
struct Seen {
  Vec3 point_mm = Vec3::Zero(), normal = Vec3::Zero();
};

/// By cell of the lattice of rays.
std::map<std::pair<int, int>, Seen> first_met(const ClosedValve& closed, double spacing_mm) {
  const Points& x = closed.closure.closed_mm;
  const Faces& faces = closed.valve.faces;
  std::map<std::pair<int, int>, Seen> seen;
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Vec3 a = x.row(faces(f, 0)), b = x.row(faces(f, 1)), c = x.row(faces(f, 2));
    const Vec3 area = (b - a).cross(c - a);
    if (area.z() <= 0.0) continue;  // shows its ventricular side
    const Vec3 normal = area.normalized();
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    for (int i = static_cast<int>(std::ceil(low.x() / spacing_mm)); i * spacing_mm <= high.x(); ++i)
      for (int j = static_cast<int>(std::ceil(low.y() / spacing_mm)); j * spacing_mm <= high.y();
           ++j) {
        const double px = i * spacing_mm, py = j * spacing_mm;
        const auto side = [&](const Vec3& p, const Vec3& q) {
          return (q.x() - p.x()) * (py - p.y()) - (q.y() - p.y()) * (px - p.x());
        };
        if (side(a, b) < 0.0 || side(b, c) < 0.0 || side(c, a) < 0.0) continue;
        const double z =
            a.z() - (normal.x() * (px - a.x()) + normal.y() * (py - a.y())) / normal.z();
        const Vec3 top = Vec3(px, py, z) + 0.5 * closed.valve.tissue.thickness_mm * normal;
        Seen& cell = seen[{i, j}];
        if (cell.normal.isZero() || top.z() > cell.point_mm.z()) cell = {top, normal};
      }
  }
  return seen;
}

void cut_holes(std::vector<Seen>& seen, const EchoOptions& options, std::mt19937_64& engine) {
  const double covered = options.holes_share * static_cast<double>(seen.size()) *
                         options.spacing_mm * options.spacing_mm;
  const double hole_mm2 = 0.25 * 3.14159265358979323846 * options.hole_mm * options.hole_mm;
  const auto holes = static_cast<int>(covered / hole_mm2);
  for (int i = 0; i < holes && !seen.empty(); ++i) {
    const Vec3 centre = seen[engine() % seen.size()].point_mm;
    std::erase_if(seen, [&](const Seen& point) {
      return (point.point_mm - centre).norm() < 0.5 * options.hole_mm;
    });
  }
}

Points smoothed(const Points& points, double sd_mm) {
  const double reach = 2.5 * sd_mm;
  Points means(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (Eigen::Index j = 0; j < points.rows(); ++j) {
      const double square = (points.row(i) - points.row(j)).squaredNorm();
      if (square > reach * reach) continue;
      const double weight = std::exp(-0.5 * square / (sd_mm * sd_mm));
      sum += weight * Vec3(points.row(j));
      weights += weight;
    }
    means.row(i) = (sum / weights).transpose();
  }
  return means;
}

}  // namespace

Points echo_view(const ClosedValve& closed, const EchoOptions& options, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<Seen> seen;
  for (const auto& [cell, point] : first_met(closed, options.spacing_mm)) seen.push_back(point);
  cut_holes(seen, options, engine);
  Points points(std::ssize(seen), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Seen& point = seen[static_cast<std::size_t>(i)];
    points.row(i) =
        (point.point_mm + options.noise_mm * normal_share(engine) * point.normal).transpose();
  }
  return smoothed(points, options.smoothing_mm);
}

}  // namespace coapt
