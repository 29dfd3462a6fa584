#include "io/image/label_curve.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/valve/number_text.h"
#include "io/image/label_voxels.h"

namespace coapt {
namespace {

constexpr int kAngles = 72;
constexpr int kWidestGap = 12;  // angles without a voxel: 60 degrees, as of contours
constexpr int kNoisyGap = 3;    // of a thin ring on coarse voxels: 15 degrees
constexpr Index kLeastVoxels = 36;
// A band of 28 mm2 about 130 mm, in voxels of 0.15 mm: 1.1 million. Each takes 100 bytes.
constexpr Index kMostRingVoxels = 2'000'000;
constexpr double kLeastHole = 0.25;  // of the mean radius: what is nearer to the middle is no ring
constexpr double kWidestBand = 0.5;  // of the radius at its angle
constexpr int kLineSmoothings = 2;
constexpr int kCentrings =
    2;  // the middle is that of the line, not of voxels that are more on one side

Points centres(const LabelMap& map, const LabelVoxels& voxels, const LabelBox& box) {
  Points points(box.count, 3);
  Index row = 0;
  for (Index k = box.min[2]; k <= box.max[2]; ++k)
    for (Index j = box.min[1]; j <= box.max[1]; ++j)
      for (Index i = box.min[0]; i <= box.max[0]; ++i)
        if (voxels(i, j, k))
          points.row(row++) =
              map.centre_mm(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  return points;
}

struct Gap {
  int angles = 0, end = 0;
};

struct Ring {
  Points line = Points::Zero(kAngles, 3);  ///< in the axes of the plane, about the middle
  std::array<int, kAngles> count{};
  double widest_band = 0.0;  ///< over the radius there
  double least_radius = 1e300, mean_radius = 0.0;
};

/// `points` in the axes of the plane, about the middle; z is across.
Ring sorted(const Points& points) {
  Ring ring;
  std::array<double, kAngles> least{}, most{};
  least.fill(1e300);
  for (Index p = 0; p < points.rows(); ++p) {
    const double radius = points.row(p).head<2>().norm();
    const double turn = std::atan2(points(p, 1), points(p, 0)) / (2.0 * std::numbers::pi) + 0.5;
    const int angle = std::min(kAngles - 1, static_cast<int>(turn * kAngles));
    const auto a = static_cast<std::size_t>(angle);
    ring.line.row(angle) += points.row(p);
    ++ring.count[a];
    least[a] = std::min(least[a], radius);
    most[a] = std::max(most[a], radius);
    ring.least_radius = std::min(ring.least_radius, radius);
    ring.mean_radius += radius / static_cast<double>(points.rows());
  }
  for (int a = 0; a < kAngles; ++a) {
    const auto at = static_cast<std::size_t>(a);
    if (ring.count[at] == 0) continue;
    ring.line.row(a) /= ring.count[at];
    ring.widest_band =
        std::max(ring.widest_band, (most[at] - least[at]) / ring.line.row(a).head<2>().norm());
  }
  return ring;
}

/// Angles without a voxel between those that have one. @return the longest run of them, and the angle after it
Gap bridge(Ring& ring) {
  const auto has = [&](int a) {
    return ring.count[static_cast<std::size_t>((a + 2 * kAngles) % kAngles)] > 0;
  };
  Gap widest;
  const Points known = ring.line;
  for (int a = 0; a < kAngles; ++a) {
    if (has(a)) continue;
    int back = 1, ahead = 1;
    while (!has(a - back) && back < kAngles) ++back;
    while (!has(a + ahead) && ahead < kAngles) ++ahead;
    if (back + ahead - 1 > widest.angles) widest = {back + ahead - 1, (a + ahead) % kAngles};
    const double share = static_cast<double>(back) / (back + ahead);
    ring.line.row(a) = (1.0 - share) * known.row((a - back + kAngles) % kAngles) +
                       share * known.row((a + ahead) % kAngles);
  }
  return widest;
}

Error no_ring(const LabelAt& label, const std::string& why) {
  return {ErrorCode::BadGeometry, "",
          "has a label " + std::to_string(label.value) + " that is not a ring: " + why +
              "; an annulus must be a closed band around the orifice"};
}

}  // namespace

Expected<Points> label_curve(const LabelMap& map, const LabelAt& label) {
  const LabelVoxels voxels(map, label);
  const LabelBox box = voxels.box();
  if (box.count < kLeastVoxels || box.count > kMostRingVoxels)
    return no_ring(label,
                   "it has " + std::to_string(box.count) + " voxels, must have 36 to 2000000");
  const Points points = centres(map, voxels, box);
  Eigen::RowVector3d middle = points.colwise().mean();
  const Points centred = points.rowwise() - middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred.transpose() * centred);
  Eigen::Matrix3d axes;  // columns: in the plane, in the plane, across
  axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1), solver.eigenvectors().col(0);
  Ring ring;
  Gap gap;
  for (int pass = 0; pass <= kCentrings; ++pass) {
    ring = sorted((points.rowwise() - middle) * axes);
    gap = bridge(ring);
    if (gap.angles > kWidestGap)
      return no_ring(label,
                     "it is open over " + std::to_string(gap.angles * 360 / kAngles) + " degrees");
    if (pass < kCentrings) middle += ring.line.colwise().mean() * axes.transpose();
  }
  if (ring.least_radius < kLeastHole * ring.mean_radius)
    return no_ring(label, "it has no central hole");
  if (ring.widest_band > kWidestBand)
    return no_ring(
        label, "it is wider than half its radius of " + significant(ring.mean_radius, 3) + " mm");
  for (int pass = 0; pass < kLineSmoothings; ++pass) {
    const Points line = ring.line;
    for (int a = 0; a < kAngles; ++a)
      ring.line.row(a) = 0.25 * line.row((a + kAngles - 1) % kAngles) + 0.5 * line.row(a) +
                         0.25 * line.row((a + 1) % kAngles);
  }
  const Points line = (ring.line * axes.transpose()).rowwise() + middle;
  if (gap.angles <= kNoisyGap) return line;
  Points open(kAngles - gap.angles, 3);
  for (Eigen::Index i = 0; i < open.rows(); ++i) open.row(i) = line.row((gap.end + i) % kAngles);
  return open;
}

}  // namespace coapt
