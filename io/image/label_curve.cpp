#include "io/image/label_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

#include "core/valve/number_text.h"
#include "core/valve/principal_axes.h"
#include "io/image/label_voxels.h"

namespace coapt {
namespace {

constexpr int kAngles = 72;
constexpr int kWidestGap = 12;  // angles without a voxel: 60 degrees, as of contours
constexpr int kNoisyGap = 3;    // of a thin ring on coarse voxels: 15 degrees
constexpr Index kLeastVoxels = 36;
// A band of 28 mm2 about 130 mm, in voxels of 0.15 mm: 1.1 million. Each takes 4 bytes.
constexpr Index kMostRingVoxels = 2'000'000;
constexpr double kLeastHole = 0.25;  // of the mean radius: what is nearer to the middle is no ring
constexpr double kWidestBand = 0.5;  // of the radius at its angle
constexpr int kLineSmoothings = 2;
constexpr int kCentrings =
    2;  // the middle is that of the line, not of voxels that are more on one side

/// Centres of a label's voxels, computed anew whenever they are needed: strangers' maps have a million of them.
class Centres {
 public:
  Centres(const LabelMap& map, const LabelVoxels& voxels, const LabelBox& box) : map_(map) {
    at_.reserve(static_cast<std::size_t>(box.count));
    for (Index k = box.min[2]; k <= box.max[2]; ++k)
      for (Index j = box.min[1]; j <= box.max[1]; ++j)
        for (Index i = box.min[0]; i <= box.max[0]; ++i)
          if (voxels(i, j, k))
            at_.push_back(static_cast<std::uint32_t>((k * map.size[1] + j) * map.size[0] + i));
  }

  double count() const { return static_cast<double>(at_.size()); }

  void each(const std::function<void(const Eigen::RowVector3d&)>& look) const {
    for (const Index at : at_) {
      const Index row = at / map_.size[0];
      look(map_.centre_mm(static_cast<double>(at % map_.size[0]),
                          static_cast<double>(row % map_.size[1]),
                          static_cast<double>(row / map_.size[1])));
    }
  }

  Eigen::RowVector3d middle() const {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    each([&](const Eigen::RowVector3d& point) { sum += point; });
    return sum / count();
  }

  /// In the plane, in the plane, across: columns.
  Eigen::Matrix3d axes(const Eigen::RowVector3d& middle) const {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    each([&](const Eigen::RowVector3d& point) {
      spread += (point - middle).transpose() * (point - middle);
    });
    return eigensystem(spread).vectors.rowwise().reverse();
  }

 private:
  static_assert(kMostVoxels <= std::numeric_limits<std::uint32_t>::max());
  const LabelMap& map_;
  std::vector<std::uint32_t> at_;  ///< in the label's layer
};

struct Gap {
  int angles = 0, end = 0;
};

struct Ring {
  Points line = Points::Zero(kAngles, 3);  ///< in the axes of the plane, about the middle
  std::array<int, kAngles> count{};
  double widest_band = 0.0;  ///< over the radius there
  double least_radius = 1e300, mean_radius = 0.0;
};

/// In the axes of the plane about the middle; z is across.
Ring sorted(const Centres& centres, const Eigen::RowVector3d& middle, const Eigen::Matrix3d& axes) {
  Ring ring;
  std::array<double, kAngles> least{}, most{};
  least.fill(1e300);
  centres.each([&](const Eigen::RowVector3d& centre) {
    const Eigen::RowVector3d point = (centre - middle) * axes;
    const double radius = point.head<2>().norm();
    const double turn = std::atan2(point.y(), point.x()) / (2.0 * std::numbers::pi) + 0.5;
    const int angle = std::min(kAngles - 1, static_cast<int>(turn * kAngles));
    const auto a = static_cast<std::size_t>(angle);
    ring.line.row(angle) += point;
    ++ring.count[a];
    least[a] = std::min(least[a], radius);
    most[a] = std::max(most[a], radius);
    ring.least_radius = std::min(ring.least_radius, radius);
    ring.mean_radius += radius / centres.count();
  });
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
              "; an annulus must be a closed band around the opening of the valve"};
}

}  // namespace

Expected<Points> label_curve(const LabelMap& map, const LabelAt& label) {
  const LabelVoxels voxels(map, label);
  const LabelBox box = voxels.box();
  if (box.count < kLeastVoxels || box.count > kMostRingVoxels)
    return no_ring(label,
                   "it has " + std::to_string(box.count) + " voxels, must have 36 to 2000000");
  const Centres centres(map, voxels, box);
  Eigen::RowVector3d middle = centres.middle();
  const Eigen::Matrix3d axes = centres.axes(middle);
  Ring ring;
  Gap gap;
  for (int pass = 0; pass <= kCentrings; ++pass) {
    ring = sorted(centres, middle, axes);
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
