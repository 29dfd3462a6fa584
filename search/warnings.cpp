#include "search/warnings.h"

#include <algorithm>
#include <cstdio>

#include "core/repair/annuloplasty.h"
#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"

namespace coapt {
namespace {

constexpr double kRounding = 1e-6;
constexpr double kStenoticRing_mm = 27.0;  // predicts functional stenosis
constexpr double kTensionRise = 3.0;     // neochordae 5 % too short: no leak, three times the force
constexpr double kTensionFloor_n = 0.2;  // below it a rise means nothing

std::string mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

using Lines = std::vector<std::string>;

void about(const Annuloplasty& ring, const Operation& operation, Lines& lines) {
  const Valve& valve = operation.valve;
  const double transverse = transverse_diameter_mm(valve, annulus_frame(valve));
  const double width =
      ring.shape == "own"
          ? transverse - kRingSizeStep_mm * ring.sizes_below
          : ring_width_mm(*find_ring(operation.catalogue, ring.shape), ring.size_mm);
  if (width > transverse)
    lines.push_back("ring wider than the annulus (" + mm(width) + " against " + mm(transverse) +
                    "): it would stretch it");
  if ((ring.shape == "own" ? width : ring.size_mm) <= kStenoticRing_mm)
    lines.push_back("ring of 27 mm or less predicts functional stenosis; filling is not simulated");
  const double sizes = std::max((transverse - width) / kRingSizeStep_mm,
                                ring_sizes_below(valve, operation.repaired));
  if (sizes > kMostSizesBelow + kRounding)
    lines.push_back(
        "annulus made smaller by more than 4 ring sizes (of its width or area): rejected in "
        "practice");
}

void about(const PapillaryApproximation& suture, const Operation&, Lines& lines) {
  if (suture.anchor == Anchor::AnnulusPoint && suture.annulus_around > 0.5)
    lines.push_back("anchor on the posterior annulus impaired filling; filling is not simulated");
}

void about(const Neochorda& step, const Operation& operation, Lines& lines) {
  for (const PapillaryHead& head : operation.valve.heads) {
    if (head.id != step.head) continue;
    const bool lateral_point = step.insertion.along < 0.5;
    const bool lateral_head = head.side == Side::Anterolateral;
    if (step.insertion.along != 0.5 && lateral_point != lateral_head)
      lines.push_back("neochorda from " + head.id + " crosses to the other half of the valve");
  }
  if (step.length_mm < kUsualNeochordaMm.min || step.length_mm > kUsualNeochordaMm.max)
    lines.push_back("neochorda of " + mm(step.length_mm) + ": usual are 10 to 30 mm");
}

void about(const ChordalLengthChange&, const Operation&, Lines&) {}
void about(const ChordalExcision&, const Operation&, Lines&) {}
void about(const ChordalTransfer&, const Operation&, Lines&) {}

void about_movement(double movement, const char* side, Lines& lines) {
  if (movement > kRejectedMovement_mm)
    lines.push_back(std::string(side) + " muscle moved by " + mm(movement) +
                    ": more than 15 mm is rejected in practice");
  else if (movement > kUsualMovement_mm)
    lines.push_back(std::string(side) + " muscle moved by " + mm(movement) +
                    ": more than 10 mm is unusual");
}

}  // namespace

std::vector<std::string> operation_warnings(const Operation& operation) {
  Lines lines;
  for (const RepairStep& step : operation.plan.steps)
    std::visit([&](const auto& s) { about(s, operation, lines); }, step);
  const Effort asked = effort(operation.valve, operation.repaired, operation.plan);
  about_movement(asked.anterolateral_movement_mm, "anterolateral", lines);
  about_movement(asked.posteromedial_movement_mm, "posteromedial", lines);
  return lines;
}

std::vector<std::string> closure_warnings(const RankedPlan& plan, const Evaluation& before) {
  Lines lines;
  if (plan.status != ClosureStatus::Converged)
    lines.push_back("the closure did not come to rest: figures are not to be trusted");
  if (plan.crossing)
    lines.push_back("leaflets pass through each other: figures are not to be trusted");
  const double tension = plan.measure.tension_max_n, usual = before.measure.tension_max_n;
  if (tension > kTensionRise * std::max(usual, kTensionFloor_n))
    lines.push_back("peak chordal tension rises more than threefold");
  const auto& sections = plan.measure.coaptation.sections;
  const auto apart = std::count_if(sections.begin(), sections.end(),
                                   [](const CoaptationSection& s) { return !s.contact; });
  if (apart > 0)
    lines.push_back("leaflets do not touch at " + std::to_string(apart) +
                    " of 9 sections (a projection can hide it)");
  if (plan.leak_mm2.worst > kGoodRepair_mm2)
    lines.push_back("leaks more than 5 mm2 somewhere in the region of interest");
  if (plan.region_closures > 1 && plan.region_failures > 0)
    lines.push_back(std::to_string(plan.region_failures) + " of " +
                    std::to_string(plan.region_closures) +
                    " closures in the region of interest failed and are left out of its figures");
  return lines;
}

}  // namespace coapt
