#include "io/exchange/label_doubts.h"

#include "core/valve/counted.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

// Of a leaflet's voxels, in the outermost layer of the map: 0.4 % of one that is cropped tight, 5 % of one that is cut off.
constexpr double kCutShare = 0.02;
// The same of a layer inside the map that ends like a cut (docs/experiments.md).
constexpr double kFlatShare = 0.0175;

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
