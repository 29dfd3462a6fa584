#include "lab/lattices/lattice_findings.h"

#include <optional>

#include "core/metrics/quantile.h"
#include "search/plans/exploration.h"

namespace coapt {
namespace {

constexpr int kMostSizes = 5;

struct Scored {
  double cost = 0.0, sizes_below = 0.0;
  RegionReport region;

  bool closes() const { return region.leak_mm2.nominal < kTraceLeak_mm2; }
};

/// Every plan of the lattice by branch and point.
class Scores {
 public:
  explicit Scores(const SolvedLattice& lattice)
      : lattice_(lattice),
        monitor_(0.0, nullptr),
        evaluate_([&lattice](const Valve&, const ClosureResult*) {
          return ClosedPlan{lattice.before, nullptr};
        }),
        evaluations_(evaluate_, lattice.of.valve, {1, lattice.closures, {}, {}, {}}, monitor_) {}

  /// Nothing if practice rejects it or it cannot be done.
  std::optional<Scored> at(const Branch& branch, const LatticePoint& point) {
    PlanRecord& record = evaluations_.record(lattice_.space->plan(branch, point));
    if (is_infeasible(record) || !evaluations_.close_here(record, kChosenBy)) return std::nullopt;
    return Scored{evaluations_.cost(record, kChosenBy), record.effort.sizes_below,
                  region_report(record, kChosenBy)};
  }

 private:
  const SolvedLattice& lattice_;
  SearchMonitor monitor_;
  Evaluator evaluate_;
  PlanEvaluations evaluations_;
};

/// The branch with the saddle peak where this one has one trigone more; null if there is none.
const Branch* with_saddle_peak(const PlanSpace& space, const Branch& branch, bool anterolateral) {
  Choice choice = branch.choice;
  std::optional<Anchor>& anchor = anterolateral ? choice.anterolateral : choice.posteromedial;
  if (anchor != Anchor::IpsilateralTrigone) return nullptr;
  anchor = Anchor::SaddlePeak;
  for (const Branch& other : space.branches())
    if (differences(other.choice, choice) == 0) return &other;
  return nullptr;
}

}  // namespace

LatticeFindings findings_of(const SolvedLattice& lattice) {
  Scores scores(lattice);
  LatticeFindings findings;
  for (int size = 0; size < kMostSizes; ++size)
    findings.rings.push_back({1.0 * size, size + 1.0, 0, 0, 0.0});
  std::vector<double> cost, mean, sd;
  AnchorPairs& pairs = findings.anchors;
  for (const Branch& branch : lattice.space->branches())
    for (std::int64_t number = 0; number < point_count(branch); ++number) {
      const LatticePoint at = point_at(branch, number);
      const std::optional<Scored> plan = scores.at(branch, at);
      if (!plan) continue;
      const LeakStatistics& leak = plan->region.leak_mm2;
      if (!branch.choice.ring.empty() && plan->closes() && plan->region.failures == 0 &&
          plan->sizes_below < kMostSizes) {
        RingTightness& ring = findings.rings[static_cast<std::size_t>(plan->sizes_below)];
        ++ring.closing;
        ring.robust += leak.mean + leak.sd < kTraceLeak_mm2;
        ring.sd_mm2 += leak.sd;
      }
      for (const bool anterolateral : {true, false}) {
        const Branch* other = with_saddle_peak(*lattice.space, branch, anterolateral);
        if (other == nullptr) continue;
        const std::optional<Scored> saddle = scores.at(*other, at);
        if (!saddle || !(plan->closes() || saddle->closes())) continue;
        const LeakStatistics& theirs = saddle->region.leak_mm2;
        ++pairs.pairs;
        pairs.trigone_cheaper += plan->cost < saddle->cost;
        pairs.trigone_tighter += leak.sd < theirs.sd;
        cost.push_back(plan->cost - saddle->cost);
        mean.push_back(leak.mean - theirs.mean);
        sd.push_back(leak.sd - theirs.sd);
      }
    }
  for (RingTightness& ring : findings.rings)
    if (ring.closing > 0) ring.sd_mm2 /= ring.closing;
  if (pairs.pairs > 0) {
    pairs.cost_difference = quantile(cost, 0.5);
    pairs.mean_difference_mm2 = quantile(mean, 0.5);
    pairs.sd_difference_mm2 = quantile(sd, 0.5);
  }
  return findings;
}

}  // namespace coapt
