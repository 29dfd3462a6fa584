#include "search/plans/gates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/number_text.h"
#include "search/plans/gate_parts.h"

namespace coapt {
namespace {

std::string mm(double value) { return with_decimals(value, 1) + " mm"; }

/// Of several findings the most severe are told.
void tell(Gate& gate, GateSeverity severity, const std::string& finding) {
  if (severity < gate.severity) return;
  if (severity > gate.severity) gate.finding.clear();
  gate.severity = severity;
  gate.finding += (gate.finding.empty() ? "" : "; ") + finding;
}

Gate gate(const char* rule) { return {rule, GateSeverity::Pass, "", kPractice}; }

Gate not_assessed(const char* rule, const char* finding) {
  return {rule, GateSeverity::NotAssessed, finding, kPractice};
}

template <class Step>
std::vector<Step> steps_of(const RepairPlan& plan) {
  std::vector<Step> found;
  for (const RepairStep& step : plan.steps)
    if (const Step* one = std::get_if<Step>(&step)) found.push_back(*one);
  return found;
}

/// Says that a rule has no subject, if nothing was found.
Gate or_none(Gate gate, const char* none) {
  if (gate.finding.empty()) gate.finding = none;
  return gate;
}

struct RingWidths {
  double transverse_mm;  ///< of the annulus before
  double ring_mm;
  double label_mm;
};

RingWidths widths(const Annuloplasty& step, const SurgicalOperation& operation) {
  const double transverse = transverse_diameter_mm(operation.valve);
  if (const auto* own = std::get_if<OwnRing>(&step.ring)) {
    const double width = transverse - kRingSizeStep_mm * own->sizes_below;
    return {transverse, width, width};
  }
  if (const auto* designed = std::get_if<DesignedRing>(&step.ring))
    return {transverse, designed->size_mm, designed->size_mm};
  const auto& ring = std::get<CatalogueRing>(step.ring);
  return {transverse, ring_width_mm(*find_ring(ring.shape), ring.size_mm), ring.size_mm};
}

Gate ring_width(const SurgicalOperation& operation) {
  Gate rule = gate("ring_width");
  for (const Annuloplasty& ring : steps_of<Annuloplasty>(operation.plan)) {
    const RingWidths width = widths(ring, operation);
    const std::string figures =
        " the annulus (" + mm(width.ring_mm) + " versus " + mm(width.transverse_mm) + ")";
    if (is_too_wide(operation.valve, width.ring_mm))
      tell(rule, GateSeverity::Warn, "the ring is wider than" + figures + " and would stretch it");
    else if (width.ring_mm > width.transverse_mm + kGateRounding)
      tell(rule, GateSeverity::Pass, "the ring is of the size closest to" + figures);
    else
      tell(rule, GateSeverity::Pass, "the ring is no wider than" + figures);
  }
  return or_none(rule, "no ring");
}

Gate ring_stenosis(const SurgicalOperation& operation) {
  Gate rule = gate("ring_stenosis");
  for (const Annuloplasty& ring : steps_of<Annuloplasty>(operation.plan)) {
    const double label = widths(ring, operation).label_mm;
    if (label <= kStenoticRing_mm + kGateRounding)
      tell(rule, GateSeverity::Warn,
           "the ring size is " + mm(label) + "; " + shown(kStenoticRing_mm) +
               " mm or less predicts functional stenosis");
    else
      tell(rule, GateSeverity::Pass,
           "the ring size of " + mm(label) + " exceeds " + shown(kStenoticRing_mm) + " mm");
  }
  return or_none(rule, "no ring");
}

std::string ring_words(const Annuloplasty& step) {
  if (std::holds_alternative<OwnRing>(step.ring)) return "the ring in the annulus's own shape";
  return (std::holds_alternative<DesignedRing>(step.ring) ? "the designed ring " : "the ring ") +
         shape_of(step);
}

Gate undersizing(const SurgicalOperation& operation) {
  Gate rule = gate("undersizing");
  for (const Annuloplasty& ring : steps_of<Annuloplasty>(operation.plan)) {
    const double sizes = ring_sizes_below(operation.valve, operation.repaired);
    constexpr double kLeast = 0.05;  // sizes that are printed
    const std::string true_size = mm(true_ring_size_mm(operation.valve)) + " (by area); ";
    const double usual = operation.untethered ? kMostSizesBelowUntethered : kMostSizesBelow;
    const std::string figure =
        ring_words(ring) + " is " +
        (sizes < kLeast ? "of the true size or larger, which is " + true_size
                        : with_decimals(sizes, 1) + " sizes below the true size of " + true_size);
    if (sizes > kMostSizesBelow + kGateRounding)
      tell(
          rule, GateSeverity::Reject,
          figure + "more than " + shown(kMostSizesBelow) + " sizes below are not used in practice");
    else
      tell(rule, sizes > usual + kGateRounding ? GateSeverity::Warn : GateSeverity::Pass,
           figure + "up to " + shown(usual) + " sizes below are used in practice" +
               (operation.untethered ? " where no leaflet is tethered" : ""));
  }
  return or_none(rule, "no ring");
}

Gate papillary_movement(const SurgicalOperation& operation) {
  Gate rule = gate("papillary_movement");
  const Effort asked = effort(operation.valve, operation.repaired, operation.plan);
  const auto about = [&rule](double movement, Side side) {
    const std::string figure =
        "the " + std::string(to_string(side)) + " papillary muscle is relocated by " + mm(movement);
    if (movement > kRejectedMovement_mm + kGateRounding)
      tell(rule, GateSeverity::Reject,
           figure + "; more than " + shown(kRejectedMovement_mm) + " mm is not done in practice");
    else if (movement > kUsualMovement_mm + kGateRounding)
      tell(rule, GateSeverity::Warn,
           figure + "; more than " + shown(kUsualMovement_mm) + " mm is unusual");
    else if (movement > 0.0)
      tell(rule, GateSeverity::Pass, figure);
  };
  about(asked.anterolateral_movement_mm, Side::Anterolateral);
  about(asked.posteromedial_movement_mm, Side::Posteromedial);
  return or_none(rule, "no papillary muscle is relocated");
}

/// apply_plan() refuses what this rule forbids.
Gate suture_length(const SurgicalOperation& operation) {
  Gate rule = gate("suture_length");
  for (const auto& suture : steps_of<PapillaryApproximation>(operation.plan))
    tell(rule, GateSeverity::Pass,
         "the " + std::string(to_string(suture.side)) + " suture of " +
             mm(suture.suture_length_mm) + " is shorter neither than " + shown(kSutureMm.min) +
             " mm nor than half the distance before the repair");
  return or_none(rule, "no papillary suture");
}

Gate filling(const SurgicalOperation& operation) {
  Gate rule = gate("filling");
  for (const auto& suture : steps_of<PapillaryApproximation>(operation.plan))
    if (suture.anchor == Anchor::AnnulusPoint && suture.annulus_around > 0.5 &&
        suture.annulus_around < 1.0)
      tell(rule, GateSeverity::Warn,
           "the " + std::string(to_string(suture.side)) +
               " papillary muscle is tied to the posterior annulus, which is associated with "
               "impaired filling; filling is not simulated");
  return rule.severity == GateSeverity::Warn
             ? rule
             : not_assessed("filling", "ventricular filling is not simulated");
}

Gate neochorda_length(const SurgicalOperation& operation) {
  Gate rule = gate("neochorda_length");
  for (const Neochorda& step : steps_of<Neochorda>(operation.plan)) {
    const bool usual = step.length_mm >= kUsualNeochordaMm.min - kGateRounding &&
                       step.length_mm <= kUsualNeochordaMm.max + kGateRounding;
    tell(rule, usual ? GateSeverity::Pass : GateSeverity::Warn,
         "the neochorda is " + mm(step.length_mm) + " long" +
             (usual ? "" : " (" + shown(kUsualNeochordaMm) + " mm is usual)"));
  }
  return or_none(rule, "no neochorda");
}

Gate neochorda_half(const SurgicalOperation& operation) {
  Gate rule = gate("neochorda_half");
  for (const Neochorda& step : steps_of<Neochorda>(operation.plan))
    for (const PapillaryHead& head : operation.valve.heads) {
      if (head.id != step.head) continue;
      const double own = head.side == Side::Anterolateral ? 0.0 : 1.0;
      const bool crosses = std::abs(step.insertion.along - own) > 0.5;
      tell(rule, crosses ? GateSeverity::Warn : GateSeverity::Pass,
           "the neochorda from " + head.id +
               (crosses ? " crosses to the other half of the valve" : " stays in its half"));
    }
  return or_none(rule, "no neochorda");
}

Gate native_chordae(const SurgicalOperation& operation) {
  Gate rule = gate("native_chordae");
  const auto holds_edge = [&operation](const std::string& id) {
    return std::any_of(
        operation.valve.chordae.begin(), operation.valve.chordae.end(), [&id](const Chorda& c) {
          return c.id == id && (c.kind == ChordaKind::Marginal || c.kind == ChordaKind::Neochorda);
        });
  };
  for (const ChordalExcision& step : steps_of<ChordalExcision>(operation.plan))
    if (holds_edge(step.chorda))
      tell(rule, GateSeverity::Warn,
           "chorda " + step.chorda + " is cut, so the free edge loses its support there");
    else
      tell(rule, GateSeverity::Pass,
           "chorda " + step.chorda + " is cut; it does not support the free edge");
  for (const ChordalTransfer& step : steps_of<ChordalTransfer>(operation.plan))
    tell(rule, GateSeverity::Pass,
         "chorda " + step.chorda + " is transferred, so its neighbours take over its load");
  for (const ChordalLengthChange& step : steps_of<ChordalLengthChange>(operation.plan))
    tell(rule, GateSeverity::Pass, "chorda " + step.chorda + " is changed in length, not cut");
  return or_none(rule, "no native chorda is changed");
}

}  // namespace

const char* to_string(GateSeverity severity) {
  switch (severity) {
    case GateSeverity::Pass:
      return "pass";
    case GateSeverity::Warn:
      return "warn";
    case GateSeverity::Reject:
      return "reject";
    case GateSeverity::NotAssessed:
      return "not_assessed";
  }
  return "";
}

std::vector<Gate> operation_gates(const SurgicalOperation& operation) {
  return {ring_width(operation),         ring_stenosis(operation),  undersizing(operation),
          papillary_movement(operation), suture_length(operation),  filling(operation),
          neochorda_length(operation),   neochorda_half(operation), native_chordae(operation)};
}

bool is_rejected(const std::vector<Gate>& gates) {
  return std::any_of(gates.begin(), gates.end(),
                     [](const Gate& gate) { return gate.severity == GateSeverity::Reject; });
}

int avoidable_warnings(const std::vector<Gate>& gates) {
  static constexpr std::array kAvoidable = {
      "filling",       "systolic_anterior_motion", "ring_stenosis", "opening_area",
      "mean_gradient", "papillary_movement",       "undersizing",   "ring_width"};
  return static_cast<int>(std::count_if(gates.begin(), gates.end(), [](const Gate& gate) {
    return gate.severity == GateSeverity::Warn &&
           std::find(kAvoidable.begin(), kAvoidable.end(), gate.rule) != kAvoidable.end();
  }));
}

std::vector<std::string> warnings_of(const std::vector<Gate>& gates) {
  std::vector<std::string> lines;
  for (const Gate& gate : gates)
    if (gate.severity == GateSeverity::Warn || gate.severity == GateSeverity::Reject)
      lines.push_back(gate.finding);
  return lines;
}

}  // namespace coapt
