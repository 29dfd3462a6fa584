#include "io/exchange/valve_labels.h"

#include <algorithm>
#include <cmath>

#include "core/closure/contact.h"
#include "core/metrics/leaflet_sides.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kVoxel_mm = 0.5, kMargin_mm = 4.0;  // of the grid about a valve
constexpr double kBand_mm = 1.0;                     // radius of the annulus
constexpr double kHalfDiagonal = 0.87;  // of a voxel's edge: nearer centres leave no hole
constexpr double kLeastInside = 0.99;   // share of the vertices
constexpr double kMostAlong = 1e6;  // voxels of a grid about a valve: a closure may have flown far
constexpr double kLooked = 1e5;     // voxels between two questions whether to go on

/// The voxels of a box of the map, each with the part that is the nearest so far.
class NearestParts {
 public:
  NearestParts(LabelMap& map, const Points& points_mm, double reach_mm,
               const std::function<bool()>& cancelled)
      : map_(map), to_voxels_(map.to_lps_mm.inverse()), cancelled_(cancelled) {
    reach_ = reach_mm * to_voxels_.topLeftCorner<3, 3>().rowwise().norm();
    for (Eigen::Index i = 0; i < points_mm.rows(); ++i) hold(points_mm.row(i).transpose());
    low_ = (low_ - reach_).array().floor().max(0.0).matrix();
    for (Index i = 0; i < 3; ++i)
      high_[i] = std::min(std::ceil(high_[i] + reach_[i]),
                          static_cast<double>(map.size[static_cast<std::size_t>(i)] - 1));
    const Vec3 count = (high_ - low_).array() + 1.0;
    if (!(count.minCoeff() > 0.0)) return;
    nearest_mm_.assign(static_cast<std::size_t>(count.prod()), 1e30F);
  }

  /// A triangle (or an edge, twice its end) as thick as twice `half_mm`. It takes what no other part is nearer to.
  void draw(const std::array<Vec3, 3>& corners, double half_mm, std::uint16_t label) {
    Vec3 low = low_, high = high_;
    for (Index i = 0; i < 3; ++i) {
      double least = 1e300, most = -1e300;
      for (const Vec3& corner : corners) {
        const double at = in_voxels(corner)[i];
        least = std::min(least, at);
        most = std::max(most, at);
      }
      low[i] = std::max(low_[i], std::ceil(least - reach_[i]));
      high[i] = std::min(high_[i], std::floor(most + reach_[i]));
    }
    for (double k = low[2]; k <= high[2]; ++k)
      for (double j = low[1]; j <= high[1]; ++j) {
        if (is_over(std::max(1.0, high[0] - low[0] + 1.0))) return;
        for (double i = low[0]; i <= high[0]; ++i) {
          const Vec3 at = map_.centre_mm(i, j, k);
          const Vec3 weights = closest_point_weights(at, corners[0], corners[1], corners[2]);
          const double away =
              (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - at)
                  .norm();
          float& nearest = nearest_mm_[index(i, j, k)];
          if (away > half_mm || static_cast<float>(away) >= nearest) continue;
          nearest = static_cast<float>(away);
          map_.voxels[static_cast<std::size_t>(
              (static_cast<Index>(k) * map_.size[1] + static_cast<Index>(j)) * map_.size[0] +
              static_cast<Index>(i))] = label;
        }
      }
  }

  /// Whether it was cancelled; what is drawn then has no end.
  bool was_cancelled() const { return was_cancelled_; }

  /// What is drawn from here on goes over what was.
  void begin_over() { std::fill(nearest_mm_.begin(), nearest_mm_.end(), 1e30F); }

  Vec3 in_voxels(const Vec3& point_mm) const {
    return (to_voxels_ * Eigen::Vector4d(point_mm[0], point_mm[1], point_mm[2], 1.0)).head<3>();
  }

 private:
  /// Before `more` voxels are looked at.
  bool is_over(double more) {
    looked_ += more;
    if (looked_ < kLooked || was_cancelled_) return was_cancelled_;
    looked_ = 0.0;
    return was_cancelled_ = cancelled_ && cancelled_();
  }

  void hold(const Vec3& point_mm) {
    const Vec3 at = in_voxels(point_mm);
    low_ = low_.cwiseMin(at);
    high_ = high_.cwiseMax(at);
  }
  std::size_t index(double i, double j, double k) const {
    const Vec3 count = (high_ - low_).array() + 1.0;
    return static_cast<std::size_t>(((k - low_[2]) * count[1] + (j - low_[1])) * count[0] +
                                    (i - low_[0]));
  }

  LabelMap& map_;
  Eigen::Matrix4d to_voxels_;
  Vec3 reach_;  ///< voxels
  Vec3 low_ = Vec3::Constant(1e300), high_ = Vec3::Constant(-1e300);
  std::vector<float> nearest_mm_;
  const std::function<bool()>& cancelled_;
  double looked_ = 0.0;  ///< voxels since it was asked last
  bool was_cancelled_ = false;
};

double share_inside(const LabelMap& map, const Points& points_mm) {
  const Eigen::Matrix4d to_voxels = map.to_lps_mm.inverse();
  Eigen::Index inside = 0;
  for (Eigen::Index v = 0; v < points_mm.rows(); ++v) {
    Eigen::Vector4d at = Eigen::Vector4d::Ones();
    at.head<3>() = points_mm.row(v).transpose();
    const Vec3 voxel = (to_voxels * at).head<3>();
    bool in = true;
    for (Index i = 0; i < 3; ++i)
      in = in && voxel[i] > -0.5 &&
           voxel[i] < static_cast<double>(map.size[static_cast<std::size_t>(i)]) - 0.5;
    inside += in ? 1 : 0;
  }
  return static_cast<double>(inside) / static_cast<double>(points_mm.rows());
}

}  // namespace

ImageGeometry label_grid_about(const Points& points_mm) {
  const Vec3 low = points_mm.colwise().minCoeff().transpose().array() - kMargin_mm;
  const Vec3 high = points_mm.colwise().maxCoeff().transpose().array() + kMargin_mm;
  ImageGeometry grid;
  grid.to_lps_mm.diagonal().head<3>().setConstant(kVoxel_mm);
  grid.to_lps_mm.col(3).head<3>() = low;
  for (Index i = 0; i < 3; ++i)
    grid.size[static_cast<std::size_t>(i)] =
        static_cast<Index>(std::min(kMostAlong, std::ceil((high[i] - low[i]) / kVoxel_mm))) + 1;
  return grid;
}

Expected<LabelMap> valve_labels(const ClosedValve& exported, const ValveShape& shape,
                                const ImageGeometry* grid, const std::function<bool()>& cancelled) {
  const Valve& valve = exported.valve;
  const ImageGeometry voxels = grid != nullptr ? *grid : label_grid_about(shape.vertices_mm);
  if (voxels.voxels() > static_cast<double>(kMostLabelVoxels))
    return Error{ErrorCode::OutOfRange, "/grid",
                 "takes " + with_decimals(voxels.voxels(), 0) + " voxels, must have at most " +
                     std::to_string(kMostLabelVoxels) + "; give a grid of coarser voxels"};
  LabelMap map;
  map.size = voxels.size;
  map.to_lps_mm = voxels.to_lps_mm;
  map.placed = true;
  map.names = {{0, 1, "Anterior leaflet"}, {0, 2, "Posterior leaflet"}, {0, 3, "Annulus"}};
  if (const double inside = share_inside(map, shape.vertices_mm); inside < kLeastInside)
    return Error{
        ErrorCode::BadGeometry, "/grid",
        "holds " + significant(100.0 * inside, 3) +
            " % of the valve; must be the grid of the images that the valve was made from"};
  map.voxels.assign(static_cast<std::size_t>(map.size[0] * map.size[1] * map.size[2]), 0);
  const double edge = map.to_lps_mm.topLeftCorner<3, 3>().colwise().norm().maxCoeff();
  const double half = std::max(0.5 * valve.tissue.thickness_mm, kHalfDiagonal * edge);
  const double band = std::max(kBand_mm, kHalfDiagonal * edge);
  NearestParts parts(map, shape.vertices_mm, std::max(half, band), cancelled);
  const auto vertex = [&](int v) { return Vec3(shape.vertices_mm.row(v).transpose()); };
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    parts.draw({vertex(valve.faces(f, 0)), vertex(valve.faces(f, 1)), vertex(valve.faces(f, 2))},
               half, sides[static_cast<std::size_t>(f)] == Leaflet::Anterior ? 1 : 2);
  parts.begin_over();
  for (std::size_t i = 0; i < valve.annulus.size(); ++i) {
    const Vec3 from = vertex(valve.annulus[i]);
    const Vec3 to = vertex(valve.annulus[(i + 1) % valve.annulus.size()]);
    parts.draw({from, to, to}, band, 3);
  }
  if (parts.was_cancelled()) return Error{ErrorCode::Busy, "", "was cancelled"};
  return map;
}

}  // namespace coapt
