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
constexpr const char* kValidity = "validity of the simulation";

Gate convergence(const Evaluation& repaired) {
  if (repaired.status == ClosureStatus::Converged && std::isfinite(repaired.measure.leak.area_mm2))
    return {"convergence", GateSeverity::Pass, "the closure converged", kValidity};
  return {"convergence", GateSeverity::Reject,
          "the closure did not converge: do not trust its figures", kValidity};
}

Gate crossing(const Evaluation& repaired) {
  if (!repaired.crossing)
    return {"crossing", GateSeverity::Pass, "no leaflet passes through another", kValidity};
  return {"crossing", GateSeverity::Reject,
          "leaflets pass through each other: do not trust the figures", kValidity};
}

Gate contact(const ValveMeasure& measure) {
  const auto& sections = measure.coaptation.sections;
  const auto apart = std::count_if(sections.begin(), sections.end(),
                                   [](const CoaptationSection& s) { return !s.contact; });
  if (apart == 0)
    return {"contact", GateSeverity::Pass,
            "leaflets touch at all " + std::to_string(sections.size()) + " sections", kPractice};
  return {"contact", GateSeverity::Warn,
          "leaflets do not touch at " + std::to_string(apart) + " of " +
              std::to_string(sections.size()) + " sections (a projection can hide it)",
          kPractice};
}

Gate coaptation_height(const Evaluation& repaired) {
  constexpr const char* kRule = "coaptation_height";
  // To the tenth that is told: what reads as the aim has reached it.
  const double height = std::round(10.0 * plan_closure(repaired).coaptation_mm) / 10.0;
  const std::string figure =
      "coaptation of A2 with P2 is " + with_decimals(height, 1) + " mm high, ";
  const std::string aim =
      "below the aim of " + shown(kCoaptationAim_mm) + " mm, whose evidence is weak";
  if (height >= kCoaptationAim_mm - kGateRounding)
    return {kRule, GateSeverity::Pass, figure + "not " + aim, kPractice};
  return {kRule, GateSeverity::Warn, figure + aim, kPractice};
}

Gate chordal_tension(const Evaluation& repaired, const Evaluation& before) {
  constexpr const char* kRule = "chordal_tension";
  if (!trusted(before))
    return {kRule, GateSeverity::NotAssessed,
            "the closure of the unrepaired valve cannot be trusted", kPractice};
  const double usual = before.measure.tension_max_n, now = repaired.measure.tension_max_n;
  const std::string figures =
      "from " + with_decimals(usual, 1) + " to " + with_decimals(now, 1) + " N";
  if (now <= kTensionRise * std::max(usual, kTensionFloor_n))
    return {kRule, GateSeverity::Pass, "highest chordal tension goes " + figures, kPractice};
  return {kRule, GateSeverity::Warn,
          "highest chordal tension rises more than threefold (" + figures +
              "), as with neochordae 5 % too short",
          kPractice};
}

/// Of the valve alone: what else matters, the septum, is not in the model.
Gate systolic_anterior_motion(const Evaluation& repaired, bool tethered) {
  constexpr const char* kRule = "systolic_anterior_motion";
  constexpr const char* kSource =
      "risk after repair of degenerative valves: Maslow 1999, Popa 2013 (J Cardiothorac Surg 8:O2)";
  const ValveMeasure& measure = repaired.measure;
  const double ratio = plan_closure(repaired).leaflet_ratio;
  if (!std::isfinite(ratio))
    return {kRule, GateSeverity::NotAssessed, "leaflets do not touch in the middle", kSource};
  const bool low = ratio < kLowLeafletRatio;
  const std::string figure = "anterior over posterior leaflet, annulus to coaptation: " +
                             with_decimals(measure.anterior_length_mm, 0) + " / " +
                             with_decimals(measure.posterior_length_mm, 0) +
                             " mm = " + with_decimals(ratio, 1) + ", ";
  if (tethered)
    return {kRule, GateSeverity::NotAssessed,
            figure +
                "is a sign of degenerative valves; here the papillary muscles tether the "
                "leaflets, which draws them away from the septum",
            kSource};
  return {kRule, low ? GateSeverity::Warn : GateSeverity::Pass,
          figure + (low ? "below " : "not below ") + shown(kLowLeafletRatio) +
              ", a static sign of risk; the other, less than 25 mm from coaptation to septum, "
              "is not in the model",
          kSource};
}

Gate regurgitation_grade(const ValveMeasure& measure) {
  return {"regurgitation_grade", GateSeverity::NotAssessed,
          "the leak of " + with_decimals(measure.leak.area_mm2, 1) +
              " mm2 is an anatomic area, not the effective one by which regurgitation is graded",
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
                             systolic_anterior_motion(repaired, tethered),
                             regurgitation_grade(repaired.measure)};
  if (!trusted(repaired))
    for (std::size_t i = 2; i < gates.size(); ++i) {
      gates[i].severity = GateSeverity::NotAssessed;
      gates[i].finding = "the closure of the repaired valve cannot be trusted";
    }
  return gates;
}

}  // namespace coapt
