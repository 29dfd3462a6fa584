#include "core/repair/approximation.h"

#include <algorithm>

#include "core/repair/limits.h"

namespace coapt {
namespace {

bool has_heads(const Valve& valve, Side side) {
  return std::any_of(valve.heads.begin(), valve.heads.end(),
                     [side](const PapillaryHead& head) { return head.side == side; });
}

}  // namespace

Range suture_range_mm(double distance_mm) {
  return {std::max(kSutureMm.min, kLeastSutureShare * distance_mm),
          std::min(kSutureMm.max, distance_mm)};
}

double anchor_distance_mm(const Valve& valve, const PapillaryApproximation& step) {
  if (!has_heads(valve, step.side)) return 0.0;
  return (papillary_tip_mm(valve, step.side) - anchor_mm(valve, step)).norm();
}

bool check_approximation(const PapillaryApproximation& step, const Valve& valve,
                         const std::string& path, ProblemList& problems) {
  if (!has_heads(valve, step.side)) {
    problems.add(ErrorCode::ImpossibleStep, path + "/side",
                 std::string("is ") + to_string(step.side) +
                     ", but this valve has no papillary head on that side");
    return false;
  }
  if (step.anchor == Anchor::AnnulusPoint &&
      !check_range(problems, path + "/annulus_around", step.annulus_around, kShare))
    return false;
  const double distance = anchor_distance_mm(valve, step);
  const Range accepted = suture_range_mm(distance);
  if (step.suture_length_mm >= accepted.min && step.suture_length_mm <= accepted.max) return true;
  const bool slack = step.suture_length_mm > distance;
  problems.add(ErrorCode::ImpossibleStep, path + "/suture_length_mm",
               "is " + shown(step.suture_length_mm) +
                   (slack ? " mm, slack: longer than the distance from tip to anchor;" : " mm;") +
                   " must be from " + shown(accepted.min) + " to " + shown(accepted.max) +
                   " mm (neither below " + shown(kSutureMm.min) +
                   " mm nor below half the present distance)");
  return false;
}

void apply_approximation(const PapillaryApproximation& step, Valve& valve) {
  const Vec3 anchor = anchor_mm(valve, step);
  const Vec3 tip = papillary_tip_mm(valve, step.side);
  const double distance = (tip - anchor).norm();
  const Vec3 move = (1.0 - step.suture_length_mm / distance) * (anchor - tip);
  for (PapillaryHead& head : valve.heads)
    if (head.side == step.side) head.tip_mm += move;
}

const PapillaryApproximation* suture_of(const RepairPlan& plan, Side side) {
  for (const RepairStep& step : plan.steps)
    if (const auto* suture = std::get_if<PapillaryApproximation>(&step))
      if (suture->side == side) return suture;
  return nullptr;
}

int sutured_muscles(const RepairPlan& plan) {
  return (suture_of(plan, Side::Anterolateral) != nullptr) +
         (suture_of(plan, Side::Posteromedial) != nullptr);
}

}  // namespace coapt
