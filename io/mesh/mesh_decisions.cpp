#include "io/mesh/mesh_decisions.h"

#include <algorithm>
#include <cmath>

#include "core/valve/number_text.h"
#include "io/mesh/hanging_profile.h"
#include "io/mesh/plausibility.h"
#include "io/mesh/sheet_repair.h"

namespace coapt {
namespace {

constexpr double kUsuallyOff_mm = 5.0;  // of given commissures along the annulus; more is looked at

std::string about_commissures(const Skirt& skirt) {
  if (skirt.commissures_off_mm > kUsuallyOff_mm)
    return "the commissures lie up to " + with_decimals(skirt.commissures_off_mm, 0) +
           " mm along the annulus from where the sheets meet; up to " + shown(kUsuallyOff_mm) +
           " mm is usual";
  return skirt.commissures_measured || skirt.commissures_given
             ? ""
             : "a skirt does not show where the leaflets meet";
}

ImportDecision landmark_decision(const Skirt& skirt) {
  const bool look = skirt.commissures_off_mm > kUsuallyOff_mm;
  return {"landmarks",
          std::string("commissures ") +
              (skirt.commissures_given      ? "as given"
               : skirt.commissures_measured ? "where the two sheets meet"
                                            : "38 % of the annulus apart, centred on its front") +
              ", saddle peak highest in front, mid-posterior half-way, trigones 66 % of the way "
              "from the peak to the commissures; segments by thirds of arc, fibres circumferential",
          about_commissures(skirt), look, look ? 0.5 : 1.0};
}

}  // namespace

std::vector<ImportDecision> closed_decisions(const Skirt& skirt, double hidden_mm,
                                             const Valve& valve) {
  return {
      {"mesh",
       std::to_string(skirt.stations) + " stations of equal annulus arc (" +
           significant(skirt.spacing_mm, 3) + " mm) x " + std::to_string(skirt.rows) + " rows, " +
           std::to_string(valve.faces.rows()) + " triangles",
       "the leaflets hang from the annulus, 20 degrees inwards"},
      landmark_decision(skirt),
      {"state",
       "imaged closed, under pressure; heights of the open leaflets are the exposed lengths / " +
           significant(kClosedStretch, 3) + " + " + significant(hidden_mm, 2) +
           " mm hidden in coaptation; heights at the commissures are those of a human valve",
       "exposed at A2 " + significant(skirt.anterior_exposed_mm, 3) + " mm, at P2 " +
           significant(skirt.posterior_exposed_mm, 3) +
           " mm; coapt fit estimates the hidden height, chordae and tips from the same surface"}};
}

std::vector<ImportDecision> mesh_decisions(const FramedSource& source, const Skirt& skirt,
                                           const Valve& valve, bool own_tissue,
                                           const ClosureBudget& budget) {
  const auto bare = std::count(skirt.interpolated.begin(), skirt.interpolated.end(), true);
  const TwoWayDistance off = two_way_distance(source.leaflets, valve, budget);
  double input_area = 0.0;
  for (const TriangleMesh& sheet : source.leaflets) input_area += area_mm2(sheet);
  const auto counted = [](auto number) { return std::to_string(number); };
  std::vector<ImportDecision> told;
  told.push_back({"mesh",
                  "cut by half-planes through the annulus axis to " + counted(skirt.stations) +
                      " stations of equal annulus arc (" + significant(skirt.spacing_mm, 3) +
                      " mm) x " + counted(skirt.rows) + " rows, " + counted(valve.faces.rows()) +
                      " triangles; smoothed along the annulus with a half-width of " +
                      significant(skirt.hat_mm, 3) + " mm",
                  "distance from the sheets " + significant(off.to_sheets_rms_mm, 3) + " mm RMS, " +
                      significant(off.to_sheets_max_mm, 3) + " mm at most, of the sheets from it " +
                      significant(off.from_sheets_rms_mm, 3) + " and " +
                      significant(off.from_sheets_max_mm, 3) + " mm; area " +
                      counted(std::lround(area_mm2({valve.rest_mm, valve.faces}))) +
                      " mm2 (sheets " + counted(std::lround(input_area)) + " mm2)",
                  is_far(off), is_far(off) ? 0.5 : 1.0});
  told.push_back({"annulus",
                  "sheets joined to the annulus line; holes and notches bridged, " +
                      significant(skirt.widest_bridge_mm, 3) + " mm wide at most",
                  "they were " + significant(skirt.annulus_gap_mm, 3) + " mm apart on average"});
  told.push_back({"commissures",
                  counted(bare) + " stations without a sheet interpolated between their neighbours",
                  "which closes the commissures"});
  told.push_back(landmark_decision(skirt));
  told.push_back({"state",
                  valve.tissue.reference == TissueReference::InVivo
                      ? "the imaged state is interpreted as that of the unpressurised heart"
                      : "the imaged state is interpreted as stress-free",
                  std::string(source.pressed_annulus_mm.rows() > 0
                                  ? "the import includes annulus and papillary tips under pressure"
                                  : "annulus and papillary tips are used under pressure as well") +
                      (own_tissue ? "; tissue and pressure are those of the files"
                                  : "; tissue of table 2.1 of the thesis")});
  return told;
}

}  // namespace coapt
