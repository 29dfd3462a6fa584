#include "io/exchange/label_doubts.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/valve/contour.h"
#include "core/valve/counted.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

// Of a leaflet's voxels, in the outermost layer of the map: 0.4 % of one that is cropped tight, 5 % of one that is cut off.
constexpr double kCutShare = 0.02;
// The same of a layer inside the map that ends like a cut (docs/experiments.md).
constexpr double kFlatShare = 0.0175;

// Of a band's middle line, with a leaflet beside the band: 1 in a sound map of 0.7 mm voxels, 0.93 with the band moved by 1.4 mm in its
// plane, 0.58 by 2.8 mm, 0 by 1.4 mm across it.
constexpr double kBesideShare = 0.9;
constexpr double kMostSearched = 1e5;  // voxels about a point

/// Whether a voxel of these lies within `reach_mm` of a point.
bool is_near(const Vec3& point_mm, double reach_mm, const LabelMap& map,
             const std::vector<LabelVoxels>& leaflets) {
  const Eigen::Matrix3d steps = map.to_lps_mm.topLeftCorner<3, 3>();
  const Vec3 at = steps.partialPivLu().solve(point_mm - map.to_lps_mm.topRightCorner<3, 1>());
  const Vec3 reach = reach_mm * steps.colwise().norm().cwiseInverse().transpose();
  if (!((2.0 * reach.array() + 1.0).prod() < kMostSearched)) return false;
  Voxel low, high;
  for (Index axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    low[a] = static_cast<Index>(std::ceil(at[axis] - reach[axis]));
    high[a] = static_cast<Index>(std::floor(at[axis] + reach[axis]));
  }
  for (Index k = low[2]; k <= high[2]; ++k)
    for (Index j = low[1]; j <= high[1]; ++j)
      for (Index i = low[0]; i <= high[0]; ++i)
        if (std::any_of(leaflets.begin(), leaflets.end(),
                        [&](const LabelVoxels& leaflet) { return leaflet(i, j, k); }) &&
            (map.centre_mm(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) -
             point_mm)
                    .norm() <= reach_mm)
          return true;
  return false;
}

std::string frame_words(const LabelMap& map) {
  const Vec3 edges = map.to_lps_mm.topLeftCorner<3, 3>().colwise().norm();
  return "voxels of " + significant(edges[0], 3) + " x " + significant(edges[1], 3) + " x " +
         significant(edges[2], 3) + " mm";
}

}  // namespace

std::optional<ImportDecision> cut_off(const LabelVoxels& voxels, const std::string& leaflet) {
  const LabelBox box = voxels.box();
  const auto is_more = [&box](Index count, double share) {
    return static_cast<double>(count) > share * static_cast<double>(box.count);
  };
  if (const Index cut = voxels.at_border(); is_more(cut, kCutShare))
    return ImportDecision{
        "labels",
        "the " + leaflet + " reaches the border of the label map, with " + counted(cut, "voxel"),
        "what lies beyond the border is missing", true, 0.5};
  if (const Index flat = voxels.flat_end(box); is_more(flat, kFlatShare))
    return ImportDecision{
        "labels",
        "the " + leaflet + " ends flat, with " + counted(flat, "voxel") + " in one plane of voxels",
        "it may have been cut off there", true, 0.5};
  return {};
}

double band_over_leaflets_mm(const LabelVoxels& band, const Points& line_mm, const LabelMap& map,
                             const std::vector<LabelVoxels>& leaflets) {
  const Eigen::Matrix3d steps = map.to_lps_mm.topLeftCorner<3, 3>();
  const double volume_mm3 = static_cast<double>(band.box().count) * std::abs(steps.determinant());
  const double half_mm = std::sqrt(volume_mm3 / (std::numbers::pi * ArcLength(line_mm).total_mm()));
  const double reach_mm = half_mm + steps.colwise().norm().maxCoeff();
  Index beside = 0;
  for (Index i = 0; i < line_mm.rows(); ++i)
    beside += is_near(line_mm.row(i), reach_mm, map, leaflets) ? 1 : 0;
  return static_cast<double>(beside) >= kBesideShare * static_cast<double>(line_mm.rows()) ? half_mm
                                                                                           : 0.0;
}

std::vector<ImportDecision> map_decisions(const LabelMap& map, bool phase_given) {
  std::vector<ImportDecision> decisions;
  if (map.phases > 1)
    decisions.push_back(
        {"labels",
         "phase " + std::to_string(map.phase) + " of " + std::to_string(map.phases) + " is used",
         phase_given ? "as given"
                     : "it is the first phase with labels; use --phase to select another",
         !phase_given, phase_given ? 1.0 : 0.5});
  else if (phase_given)
    decisions.push_back({"options", "phase not used", "the label map has one phase", true});
  if (map.masks > 0)
    decisions.push_back(
        {"labels",
         std::to_string(map.masks) + " masks taken as one label each" +
             (map.masks > map.layers ? ", one of them as the background" : ""),
         "they contain only 0 and 1 and hardly overlap; use --phase if they are phases", true,
         0.8});
  if (!map.frame_doubt.empty())
    decisions.push_back({"labels", map.frame_doubt, "the header contradicts itself", true, 0.5});
  decisions.push_back(
      {"labels", frame_words(map) + (map.placed ? ", in the patient's frame, LPS" : ""),
       map.placed ? "stated in the label map"
                  : "the label map does not state patient axes, so voxel axes are used"});
  return decisions;
}

}  // namespace coapt
