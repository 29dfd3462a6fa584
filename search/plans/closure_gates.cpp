#include <algorithm>
#include <cmath>
#include <cstdio>

#include "search/plans/gates.h"

namespace coapt {
namespace {

constexpr double kRounding = 1e-6;
constexpr double kCoaptationAim_mm = 8.0;
constexpr double kTensionRise = 3.0;     // neochordae 5 % too short: no leak, three times the force
constexpr double kTensionFloor_n = 0.2;  // below it a rise means nothing
constexpr const char* kPractice = "surgical practice";
constexpr const char* kGrading = "echocardiographic grading";
constexpr const char* kValidity = "validity of the simulation";

std::string one_decimal(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

Gate convergence(const Evaluation& repaired) {
  if (repaired.status == ClosureStatus::Converged && std::isfinite(leak_mm2(repaired.measure)))
    return {"convergence", GateSeverity::Pass, "the closure came to rest", kValidity};
  return {"convergence", GateSeverity::Reject,
          "the closure did not come to rest: figures are not to be trusted", kValidity};
}

Gate crossing(const Evaluation& repaired) {
  if (!repaired.crossing)
    return {"crossing", GateSeverity::Pass, "no leaflet passes through another", kValidity};
  return {"crossing", GateSeverity::Reject,
          "leaflets pass through each other: figures are not to be trusted", kValidity};
}

Gate contact(const ValveMeasure& measure) {
  const auto& sections = measure.coaptation.sections;
  const auto apart = std::count_if(sections.begin(), sections.end(),
                                   [](const CoaptationSection& s) { return !s.contact; });
  if (apart == 0)
    return {"contact", GateSeverity::Pass, "leaflets touch at all 9 sections", kPractice};
  return {"contact", GateSeverity::Warn,
          "leaflets do not touch at " + std::to_string(apart) +
              " of 9 sections (a projection can hide it)",
          kPractice};
}

Gate coaptation_height(const Evaluation& repaired) {
  const double height = plan_closure(repaired).coaptation_mm;
  const std::string figure = "coaptation of A2 with P2 is " + one_decimal(height) + " mm high: ";
  if (height >= kCoaptationAim_mm - kRounding)
    return {"coaptation_height", GateSeverity::Pass,
            figure + "8 mm is the aim, the evidence for it is weak", kPractice};
  return {"coaptation_height", GateSeverity::Warn,
          figure + "8 mm is only an aim, the evidence for it is weak", kPractice};
}

Gate chordal_tension(const Evaluation& repaired, const Evaluation& before) {
  constexpr const char* kRule = "chordal_tension";
  if (!trusted(before))
    return {kRule, GateSeverity::NotAssessed, "the unrepaired valve's closure is not to be trusted",
            kPractice};
  const double usual = before.measure.tension_max_n, now = repaired.measure.tension_max_n;
  const std::string figures = "from " + one_decimal(usual) + " to " + one_decimal(now) + " N";
  if (now <= kTensionRise * std::max(usual, kTensionFloor_n))
    return {kRule, GateSeverity::Pass, "peak chordal tension goes " + figures, kPractice};
  return {kRule, GateSeverity::Warn,
          "peak chordal tension rises more than threefold (" + figures +
              "), as with neochordae 5 % too short",
          kPractice};
}

Gate regurgitation_grade(const ValveMeasure& measure) {
  return {"regurgitation_grade", GateSeverity::NotAssessed,
          "the orifice of " + one_decimal(measure.orifice.area_mm2) +
              " mm2 is anatomic, not the effective one by which regurgitation is graded",
          kGrading};
}

}  // namespace

std::vector<Gate> closure_gates(const Evaluation& repaired, const Evaluation& before) {
  std::vector<Gate> gates = {convergence(repaired),
                             crossing(repaired),
                             contact(repaired.measure),
                             coaptation_height(repaired),
                             chordal_tension(repaired, before),
                             regurgitation_grade(repaired.measure)};
  if (!trusted(repaired))
    for (std::size_t i = 2; i < gates.size(); ++i) {
      gates[i].severity = GateSeverity::NotAssessed;
      gates[i].finding = "the repaired valve's closure is not to be trusted";
    }
  return gates;
}

}  // namespace coapt
