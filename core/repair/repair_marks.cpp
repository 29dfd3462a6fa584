#include "core/repair/repair_marks.h"

#include "core/repair/leaflet_resection.h"

namespace coapt {

RepairMarks repair_marks(const Valve& before, const Valve& repaired, const RepairPlan& plan) {
  RepairMarks marks;
  for (const RepairStep& step : plan.steps) {
    if (std::holds_alternative<Annuloplasty>(step)) marks.annulus_before_mm = before.annulus_mm;
    if (const auto* suture = std::get_if<PapillaryApproximation>(&step))
      marks.sutures.push_back({suture->side, papillary_tip_mm(before, suture->side),
                               papillary_tip_mm(repaired, suture->side),
                               anchor_mm(repaired, *suture)});
    if (const auto* cut = std::get_if<LeafletResection>(&step))
      marks.seams.push_back(seam_of(*cut, leaflet_coordinates(repaired), repaired));
  }
  return marks;
}

}  // namespace coapt
