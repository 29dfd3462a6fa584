#include "search/plans/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "core/closed/diagnosis.h"
#include "core/closure/predicted_start.h"
#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/valve/leaflet_point.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr int kUnits = 3;
constexpr double kPart =
    0.04;  // of the annulus' turn, a leaflet's width or height, over which a millimetre is measured

/// How one step may miss.
struct Way {
  int step = 0;
  StepError error = StepError::RingSize;
  double unit_mm = 1.0;
  std::function<std::optional<RepairStep>(double error_mm)> at;  ///< none: there is no such place
};

void add_ways(std::vector<Way>& ways, int index, const Annuloplasty& step) {
  ways.push_back({index, StepError::RingSize, kRingSizeStep_mm, [step](double error_mm) {
                    Annuloplasty other = step;
                    if (auto* const own = std::get_if<OwnRing>(&other.ring))
                      own->sizes_below -=
                          static_cast<int>(std::lround(error_mm / kRingSizeStep_mm));
                    if (auto* const made = std::get_if<CatalogueRing>(&other.ring))
                      made->size_mm += error_mm;
                    if (auto* const designed = std::get_if<DesignedRing>(&other.ring))
                      designed->size_mm += error_mm;
                    return other;
                  }});
}

/// Where around the annulus it is sewn. @param ringed with its ring in place
double around_of(const Valve& ringed, const PapillaryApproximation& step) {
  if (step.anchor == Anchor::AnnulusPoint) return step.annulus_around;
  const Vec3 anchor = anchor_mm(ringed, step);
  Eigen::Index nearest = 0;
  (ringed.annulus_mm.rowwise() - anchor.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return annulus_around(ringed)[static_cast<std::size_t>(nearest)];
}

void add_ways(std::vector<Way>& ways, int index, const PapillaryApproximation& step,
              const Valve& ringed) {
  ways.push_back({index, StepError::SutureLength, 1.0, [step](double error_mm) {
                    PapillaryApproximation other = step;
                    other.suture_length_mm += error_mm;
                    return other;
                  }});
  const double around = around_of(ringed, step);
  const double part_mm = (annulus_point_mm(ringed, around + 0.5 * kPart) -
                          annulus_point_mm(ringed, around - 0.5 * kPart))
                             .norm();
  ways.push_back({index, StepError::SutureAnchor, 1.0, [=](double error_mm) {
                    PapillaryApproximation other = step;
                    other.anchor = Anchor::AnnulusPoint;
                    const double place = around + kPart * error_mm / part_mm;
                    other.annulus_around = place - std::floor(place);
                    return other;
                  }});
}

bool is_share(double value) { return value >= kShare.min && value <= kShare.max; }

/// Places on the leaflets of the plan's own closure.
class ClosedLeaflets {
 public:
  ClosedLeaflets(const Valve& valve, const Points& closed_mm)
      : valve_(valve), closed_mm_(closed_mm), coordinates_(leaflet_coordinates(valve)) {}
  /// Of the leaflet's width or height.
  double part_of_mm(const LeafletPoint& from, const LeafletPoint& to) const {
    return kPart / std::max((at(from) - at(to)).norm(), 1e-6);
  }

 private:
  Vec3 at(const LeafletPoint& point) const {
    const Insertion insertion = locate(valve_, coordinates_, point);
    Vec3 place = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      place += insertion.weights[static_cast<std::size_t>(k)] *
               closed_mm_.row(valve_.faces(insertion.face, k)).transpose();
    return place;
  }
  const Valve& valve_;
  const Points& closed_mm_;
  LeafletCoordinates coordinates_;
};

void add_ways(std::vector<Way>& ways, int index, const Neochorda& step,
              const ClosedLeaflets& leaflets) {
  ways.push_back({index, StepError::NeochordaLength, 1.0, [step](double error_mm) {
                    Neochorda other = step;
                    other.length_mm += error_mm;
                    return other;
                  }});
  const LeafletPoint& point = step.insertion;
  LeafletPoint aside = point, inner = point, outer = point;
  aside.along += point.along > 0.5 ? -kPart : kPart;
  inner.height = std::max(point.height - kPart, 0.0);
  outer.height = inner.height + kPart;
  const auto stitched = [step](double along, double height) -> std::optional<RepairStep> {
    Neochorda other = step;
    other.insertion.along = along;
    other.insertion.height = height;
    if (!is_share(along) || !is_share(height)) return std::nullopt;
    return other;
  };
  ways.push_back({index, StepError::StitchAlongLeaflet, 1.0,
                  [=, part = leaflets.part_of_mm(point, aside)](double error_mm) {
                    return stitched(point.along + part * error_mm, point.height);
                  }});
  ways.push_back({index, StepError::StitchTowardsEdge, 1.0,
                  [=, part = leaflets.part_of_mm(inner, outer)](double error_mm) {
                    return stitched(point.along, point.height + part * error_mm);
                  }});
}

Valve with_rings(const Valve& valve, RepairPlan plan) {
  std::erase_if(plan.steps,
                [](const RepairStep& step) { return !std::holds_alternative<Annuloplasty>(step); });
  const Expected<Valve> ringed = apply_plan(valve, plan);
  return ringed ? *ringed : valve;
}

std::vector<Way> ways_of(const PlanEvaluations& evaluations, const PlanRecord& plan,
                         const Valve& repaired, const Points& closed_mm) {
  std::vector<Way> ways;
  const Valve ringed = with_rings(evaluations.valve(), plan.plan);
  const ClosedLeaflets leaflets(repaired, closed_mm);
  for (int i = 0; i < std::ssize(plan.plan.steps); ++i) {
    const RepairStep& step = plan.plan.steps[static_cast<std::size_t>(i)];
    if (const auto* const ring = std::get_if<Annuloplasty>(&step)) add_ways(ways, i, *ring);
    if (const auto* const suture = std::get_if<PapillaryApproximation>(&step))
      add_ways(ways, i, *suture, ringed);
    if (const auto* const neochorda = std::get_if<Neochorda>(&step))
      add_ways(ways, i, *neochorda, leaflets);
  }
  return ways;
}

/// Leaks at one, two, ... units to one side, as far as the step can be done.
std::vector<double> closed_along(const PlanEvaluations& evaluations, const PlanRecord& plan,
                                 const std::shared_ptr<const ClosureResult>& planned,
                                 const Way& way, double side) {
  std::vector<double> leaks;
  std::shared_ptr<const ClosureResult> last = planned, before_last;
  for (int unit = 1; unit <= kUnits && !evaluations.cancelled(); ++unit) {
    const std::optional<RepairStep> step = way.at(side * unit * way.unit_mm);
    if (!step) break;
    RepairPlan other = plan.plan;
    other.steps[static_cast<std::size_t>(way.step)] = *step;
    const Expected<Valve> valve = apply_plan(evaluations.valve(), other);
    if (!valve) break;
    std::optional<ClosureResult> predicted;
    if (before_last)
      predicted = predicted_start(valve->faces, std::array{ClosureShare{last.get(), 2.0},
                                                           ClosureShare{before_last.get(), -1.0}});
    const ClosedPlan closed = with_leak_surface(
        *valve, evaluations.evaluate(*valve, predicted ? &*predicted : last.get()));
    const bool is_trusted = trusted(closed.evaluation);
    leaks.push_back(is_trusted ? closed.evaluation.measure.leak.area_mm2
                               : std::numeric_limits<double>::quiet_NaN());
    before_last = is_trusted ? last : nullptr;
    if (is_trusted) last = closed.closure;
  }
  return leaks;
}

/// Of one side, from 0 outwards: where the leak first exceeds the limit; none if it does not.
std::optional<double> first_leak_mm(const std::vector<std::pair<double, double>>& side) {
  for (std::size_t i = 0; i < side.size(); ++i) {
    const auto [error_mm, leak_mm2] = side[i];
    if (leak_mm2 <= kTraceLeak_mm2) continue;
    if (i == 0) return 0.0;
    const auto [last_mm, last_mm2] = side[i - 1];
    if (std::isnan(leak_mm2)) return last_mm;
    return last_mm + (kTraceLeak_mm2 - last_mm2) / (leak_mm2 - last_mm2) * (error_mm - last_mm);
  }
  return std::nullopt;
}

}  // namespace

const char* to_string(StepError error) {
  switch (error) {
    case StepError::RingSize:
      return "ring_size";
    case StepError::SutureLength:
      return "suture_length";
    case StepError::SutureAnchor:
      return "suture_anchor";
    case StepError::NeochordaLength:
      return "neochorda_length";
    case StepError::StitchAlongLeaflet:
      return "stitch_along_leaflet";
    case StepError::StitchTowardsEdge:
      return "stitch_towards_edge";
  }
  return "";
}

ToleranceCurve with_margin(ToleranceCurve curve) {
  std::vector<std::pair<double, double>> less, more;
  for (std::size_t i = 0; i < curve.error_mm.size(); ++i) {
    if (curve.error_mm[i] <= 0.0) less.emplace_back(-curve.error_mm[i], curve.leak_mm2[i]);
    if (curve.error_mm[i] >= 0.0) more.emplace_back(curve.error_mm[i], curve.leak_mm2[i]);
  }
  std::reverse(less.begin(), less.end());
  curve.margin_mm = std::numeric_limits<double>::infinity();
  curve.leaks_beyond = false;
  for (const auto& side : {less, more})
    if (const std::optional<double> leaks = first_leak_mm(side)) {
      curve.margin_mm = std::min(curve.margin_mm, *leaks);
      curve.leaks_beyond = true;
    }
  if (curve.leaks_beyond) return curve;
  for (const auto& side : {less, more})  // a side that nobody can go limits nothing
    if (side.size() > 1) curve.margin_mm = std::min(curve.margin_mm, side.back().first);
  if (!std::isfinite(curve.margin_mm)) curve.margin_mm = 0.0;
  return curve;
}

std::vector<ToleranceCurve> step_tolerances(PlanEvaluations& evaluations, const PlanRecord& plan) {
  const Valve repaired = evaluations.repaired(plan);
  const ClosedPlan planned = with_leak_surface(repaired, evaluations.closed(plan));
  if (planned.closure == nullptr || !trusted(planned.evaluation) || evaluations.cancelled())
    return {};
  const std::vector<Way> ways = ways_of(evaluations, plan, repaired, planned.closure->closed_mm);
  const int count = static_cast<int>(ways.size());
  std::vector<std::vector<double>> sides(2 * ways.size());  // less, more of each way
  for_each_index(2 * count, evaluations.threads(), [&](int i) {
    sides[static_cast<std::size_t>(i)] =
        closed_along(evaluations, plan, planned.closure, ways[static_cast<std::size_t>(i / 2)],
                     i % 2 == 0 ? -1.0 : 1.0);
  });
  if (evaluations.cancelled()) return {};
  std::vector<ToleranceCurve> curves;
  for (std::size_t way = 0; way < ways.size(); ++way) {
    ToleranceCurve curve{ways[way].step, ways[way].error, {}, {}};
    const auto add = [&](double units, double leak_mm2) {
      curve.error_mm.push_back(units * ways[way].unit_mm);
      curve.leak_mm2.push_back(leak_mm2);
    };
    const std::vector<double>&less = sides[2 * way], &more = sides[2 * way + 1];
    for (std::size_t i = less.size(); i > 0; --i) add(-static_cast<double>(i), less[i - 1]);
    add(0.0, planned.evaluation.measure.leak.area_mm2);
    for (std::size_t i = 0; i < more.size(); ++i) add(static_cast<double>(i + 1), more[i]);
    curves.push_back(with_margin(std::move(curve)));
  }
  return curves;
}

}  // namespace coapt
