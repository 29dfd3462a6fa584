#include "search/plans/closure_gates.h"

#include <algorithm>
#include <cmath>

#include "core/valve/number_text.h"
#include "search/plans/gate_parts.h"
#include "search/plans/objective.h"

namespace coapt {
namespace {

constexpr double kTensionRise = 3.0;     // neochordae 5 % too short: no leak, three times the force
constexpr double kTensionFloor_n = 0.2;  // below it a rise means nothing
constexpr const char* kGrading = "echocardiographic grading";
constexpr const char* kValidity = "validity of the closure";

Gate convergence(const Evaluation& repaired) {
  if (repaired.status == ClosureStatus::Converged && std::isfinite(repaired.measure.leak.area_mm2))
    return {"convergence", GateSeverity::Pass, "the closure converged", kValidity};
  return {"convergence", GateSeverity::Reject,
          "the closure did not converge; its results are unreliable", kValidity};
}

Gate crossing(const Evaluation& repaired) {
  if (!repaired.crossing)
    return {"crossing", GateSeverity::Pass, "the leaflets do not cross", kValidity};
  return {"crossing", GateSeverity::Reject, "the leaflets cross; the results are unreliable",
          kValidity};
}

Gate contact(const ValveMeasure& measure) {
  const auto& sections = measure.coaptation.sections;
  const auto apart = std::count_if(sections.begin(), sections.end(),
                                   [](const CoaptationSection& s) { return !s.contact; });
  if (apart == 0)
    return {"contact", GateSeverity::Pass,
            "the leaflets coapt in all " + std::to_string(sections.size()) + " sections",
            kPractice};
  return {"contact", GateSeverity::Warn,
          "the leaflets do not coapt in " + std::to_string(apart) + " of " +
              std::to_string(sections.size()) + " sections (a projection can hide this)",
          kPractice};
}

Gate coaptation_height(const Evaluation& repaired) {
  constexpr const char* kRule = "coaptation_height";
  // To the tenth that is told: what reads as the aim has reached it.
  const double height = std::round(10.0 * plan_closure(repaired).coaptation_mm) / 10.0;
  const std::string figure =
      "the coaptation height of A2 with P2 is " + with_decimals(height, 1) + " mm, ";
  const std::string aim =
      "the target of " + shown(kCoaptationAim_mm) + " mm, which rests on weak evidence";
  if (height >= kCoaptationAim_mm - kGateRounding)
    return {kRule, GateSeverity::Pass, figure + "at or above " + aim, kPractice};
  return {kRule, GateSeverity::Warn, figure + "below " + aim, kPractice};
}

Gate chordal_tension(const Evaluation& repaired, const Evaluation& before) {
  constexpr const char* kRule = "chordal_tension";
  if (!trusted(before))
    return {kRule, GateSeverity::NotAssessed, "the closure of the unrepaired valve is unreliable",
            kPractice};
  const double usual = before.measure.tension_max_n, now = repaired.measure.tension_max_n;
  const std::string figures =
      "from " + with_decimals(usual, 1) + " to " + with_decimals(now, 1) + " N";
  if (now <= kTensionRise * std::max(usual, kTensionFloor_n))
    return {kRule, GateSeverity::Pass, "the highest chordal tension changes " + figures, kPractice};
  return {kRule, GateSeverity::Warn,
          "the highest chordal tension rises more than threefold (" + figures +
              "), as with neochordae 5 % too short",
          kPractice};
}

/// Of the valve alone: what else matters, the septum, is not in the model. A risk that was there before speaks against no plan.
Gate systolic_anterior_motion(const Evaluation& repaired, const Evaluation& before, bool tethered) {
  constexpr const char* kRule = "systolic_anterior_motion";
  constexpr const char* kSource =
      "risk after repair of degenerative valves: Maslow 1999, Popa 2013 (J Cardiothorac Surg 8:O2)";
  const ValveMeasure& measure = repaired.measure;
  const double ratio = plan_closure(repaired).leaflet_ratio;
  if (!std::isfinite(ratio))
    return {kRule, GateSeverity::NotAssessed, "the leaflets do not coapt in the middle", kSource};
  const bool low = ratio < kLowLeafletRatio;
  const double usual = plan_closure(before).leaflet_ratio;
  const bool raised = raises_sam_risk(ratio, usual);
  const std::string figure =
      "SAM risk: the ratio of anterior to posterior leaflet length, annulus to coaptation, is " +
      with_decimals(ratio, 1) + " (" + with_decimals(measure.anterior_length_mm, 0) + " / " +
      with_decimals(measure.posterior_length_mm, 0) + " mm)";
  if (tethered)
    return {kRule, GateSeverity::NotAssessed,
            figure +
                ", which predicts SAM in degenerative valves only; these leaflets are tethered, "
                "which draws them away from the septum",
            kSource};
  return {
      kRule, raised ? GateSeverity::Warn : GateSeverity::Pass,
      figure + ", " + (low ? "below " : "not below ") + shown(kLowLeafletRatio) +
          (low && !raised
               ? ", but not lower than before the repair (" + with_decimals(usual, 1) + ")"
               : "") +
          ". The distance from coaptation to septum (C-sept; risk below 25 mm) cannot be assessed",
      kSource};
}

Gate regurgitation_grade(const ValveMeasure& measure) {
  return {"regurgitation_grade", GateSeverity::NotAssessed,
          "the leak of " + with_decimals(measure.leak.area_mm2, 1) +
              " mm² is an anatomic area; regurgitation is graded by the effective orifice area",
          kGrading};
}

}  // namespace

std::vector<Gate> closure_gates(const Evaluation& repaired, const Evaluation& before,
                                bool tethered) {
  std::vector<Gate> gates = {convergence(repaired),
                             crossing(repaired),
                             contact(repaired.measure),
                             coaptation_height(repaired),
                             chordal_tension(repaired, before),
                             systolic_anterior_motion(repaired, before, tethered),
                             regurgitation_grade(repaired.measure)};
  if (!trusted(repaired))
    for (std::size_t i = 2; i < gates.size(); ++i) {
      gates[i].severity = GateSeverity::NotAssessed;
      gates[i].finding = "the closure of the repaired valve is unreliable";
    }
  return gates;
}

}  // namespace coapt
