#include "search/studies/physiology.h"

#include <algorithm>
#include <cmath>

#include "core/closed/diagnosis.h"

namespace coapt {

const std::vector<PhysiologyQuantity>& physiology_quantities() {
  using enum PhysiologyTrial;
  using V = PhysiologyValues;
  static const std::vector<PhysiologyQuantity> all = {
      {"leak", "Leak at the valve's own pressure", "mm2", Rest, &V::leak_mm2},
      {"coaptation_length", "Coaptation height, A2 with P2", "mm", Rest, &V::coaptation_length_mm},
      {"coaptation_height", "Coaptation height, mean of nine sections", "mm", Rest,
       &V::coaptation_height_mm},
      {"depth_hinge", "Coaptation point below the hinge line", "mm", Rest, &V::depth_hinge_mm},
      {"depth_plane", "Coaptation point below the best-fit plane of the annulus", "mm", Rest,
       &V::depth_plane_mm},
      {"tenting_area", "Tenting area, mid-valve section", "mm2", Rest, &V::tenting_area_mm2},
      {"strut", "Mean tension of a strut chorda", "N", Rest, &V::strut_n},
      {"anterior_marginal", "Largest tension of an anterior marginal trunk", "N", Rest,
       &V::anterior_marginal_n},
      {"strut_over_marginal", "Ratio of strut to largest anterior marginal tension", "", Rest,
       &V::strut_over_marginal},
      {"struts_cut_ratio", "Increase of A2's marginal tension with both struts cut, factor", "",
       StrutsCut, &V::struts_cut_ratio},
      {"muscle_anterolateral", "Force of the anterolateral muscle", "N", Rest,
       &V::muscle_anterolateral_n},
      {"muscle_posteromedial", "Force of the posteromedial muscle", "N", Rest,
       &V::muscle_posteromedial_n},
      {"muscle_share", "Ratio of both muscle forces to the closing force", "", Rest,
       &V::muscle_share},
      {"annular_force", "Septal-lateral force of the annulus", "N", Rest, &V::annular_force_n},
      {"a2_radial", "Radial strain of A2", "%", Rest, &V::a2_radial_percent},
      {"a2_circumferential", "Circumferential strain of A2", "%", Rest,
       &V::a2_circumferential_percent},
      {"a2_areal", "Areal strain of A2", "%", Rest, &V::a2_areal_percent},
      {"posterior_squeezed", "Fraction of the posterior leaflet compressed by more than a tenth",
       "", Rest, &V::posterior_squeezed_share},
      {"papillary_systole", "Distance between the papillary tips, systole", "mm", Rest,
       &V::papillary_systole_mm},
      {"papillary_diastole", "Distance between the papillary tips, diastole", "mm", Rest,
       &V::papillary_diastole_mm},
      {"leak_60", "Leak at 60 mmHg", "mm2", Pressures, &V::leak_60_mm2},
      {"leak_90", "Leak at 90 mmHg", "mm2", Pressures, &V::leak_90_mm2},
      {"leak_200", "Leak at 200 mmHg", "mm2", Pressures, &V::leak_200_mm2},
      {"leak_200_over_60", "Ratio of the leak at 200 mmHg to that at 60 mmHg", "", Pressures,
       &V::leak_200_over_60},
      {"ring_40", "Leak with a generic-classic ring of 40 mm", "mm2", Rings, &V::ring_40_mm2},
      {"ring_38", "Leak with a ring of 38 mm", "mm2", Rings, &V::ring_38_mm2},
      {"ring_36", "Leak with a ring of 36 mm", "mm2", Rings, &V::ring_36_mm2},
      {"ring_34", "Leak with a ring of 34 mm", "mm2", Rings, &V::ring_34_mm2},
      {"ring_32", "Leak with a ring of 32 mm", "mm2", Rings, &V::ring_32_mm2},
      {"ring_30", "Leak with a ring of 30 mm", "mm2", Rings, &V::ring_30_mm2},
      {"opening", "Opening area", "mm2", Opening, &V::opening_mm2},
      {"gradient", "Mean gradient", "mmHg", Opening, &V::gradient_mmhg},
      {"opening_own_0", "Opening with a ring of the valve's own size", "mm2", RingOpenings,
       &V::opening_own_0_mm2},
      {"opening_own_2", "Opening with a ring two sizes below", "mm2", RingOpenings,
       &V::opening_own_2_mm2},
      {"opening_own_4", "Opening with a ring four sizes below", "mm2", RingOpenings,
       &V::opening_own_4_mm2},
      {"gradient_own_0", "Mean gradient with a ring of the valve's own size", "mmHg", RingOpenings,
       &V::gradient_own_0_mmhg},
      {"gradient_own_4", "Mean gradient with a ring four sizes below", "mmHg", RingOpenings,
       &V::gradient_own_4_mmhg},
      {"ring_opening_share", "Ratio of the widest opening with a ring to that without", "",
       RingOpenings, &V::ring_opening_share},
      {"gradient_slope", "Change of the gradient per mm of ring size", "mmHg/mm", RingOpenings,
       &V::gradient_slope_mmhg_mm},
      {"opening_clip", "Opening with one clip", "mm2", Clips, &V::opening_clip_mm2},
      {"clip_share", "Ratio of the opening with one clip to that without", "", Clips,
       &V::clip_share},
      {"two_clips_share", "Ratio of the opening with two clips to that with one", "", Clips,
       &V::two_clips_share},
      {"clip_gradient", "Mean gradient with one clip", "mmHg", Clips, &V::clip_gradient_mmhg}};
  return all;
}

const PhysiologyQuantity* find_quantity(const std::string& name) {
  for (const PhysiologyQuantity& quantity : physiology_quantities())
    if (quantity.name == name) return &quantity;
  return nullptr;
}

ValveKind kind_of(const Valve& valve, const PhysiologyValues& values) {
  if (values.leak_mm2 < kMildLeak_mm2) return ValveKind::Healthy;
  const bool ruptured =
      std::any_of(valve.chordae.begin(), valve.chordae.end(),
                  [](const Chorda& c) { return c.ruptured && c.kind == ChordaKind::Marginal; });
  return ruptured || values.tenting_area_mm2 < 0.0 ? ValveKind::Prolapse : ValveKind::Functional;
}

Species species_of(const Valve& valve) {
  return valve.name.find("porcine") != std::string::npos ? Species::Porcine : Species::Human;
}

const char* to_string(PhysiologyVerdict verdict) {
  switch (verdict) {
    case PhysiologyVerdict::Met:
      return "met";
    case PhysiologyVerdict::Below:
      return "below";
    case PhysiologyVerdict::Above:
      return "above";
    case PhysiologyVerdict::Unknown:
      return "unknown";
    case PhysiologyVerdict::NoRange:
      return "no range";
  }
  return "";
}

PhysiologyRow physiology_row(const PhysiologyQuantity& quantity, const PhysiologyValues& values,
                             ValveKind kind, Species species) {
  PhysiologyRow row{&quantity, values.*quantity.value, find_range(quantity.name, kind, species),
                    PhysiologyVerdict::Met};
  if (!std::isfinite(row.value))
    row.verdict = PhysiologyVerdict::Unknown;
  else if (row.range == nullptr)
    row.verdict = PhysiologyVerdict::NoRange;
  else if (row.value < row.range->low)
    row.verdict = PhysiologyVerdict::Below;
  else if (row.value > row.range->high)
    row.verdict = PhysiologyVerdict::Above;
  return row;
}

Physiology study_physiology(const Valve& valve, const PhysiologyOptions& options) {
  const PhysiologyValues values = physiology_values(valve, options);
  Physiology physiology{options.kind.value_or(kind_of(valve, values)),
                        options.species.value_or(species_of(valve)),
                        !options.kind,
                        !options.species,
                        {},
                        values.unfinished};
  for (const PhysiologyQuantity& quantity : physiology_quantities())
    if (quantity.trial == PhysiologyTrial::Rest ||
        std::find(options.trials.begin(), options.trials.end(), quantity.trial) !=
            options.trials.end())
      physiology.rows.push_back(
          physiology_row(quantity, values, physiology.kind, physiology.species));
  return physiology;
}

}  // namespace coapt
