#include "search/rings/ring_gain.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "search/plans/objective.h"
#include "search/plans/plan_opening.h"
#include "search/rings/ring_cost.h"

namespace coapt {
namespace {

/// Mean of what is known.
class KnownMean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    sum_ += value;
    ++count_;
  }
  double value() const { return count_ > 0 ? sum_ / count_ : std::nan(""); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// A member's disturbances as if each were a member.
std::vector<RingOutcome> by_disturbance(const RingOutcome& outcome) {
  std::vector<RingOutcome> units;
  for (const double leak : outcome.leaks_mm2) {
    units.push_back(outcome);
    units.back().leaks_mm2 = {leak};
  }
  return units;
}

}  // namespace

RingFigures figures_of(const std::vector<RingOutcome>& outcomes) {
  KnownMean below, leak, gradient, durability, tenting, suture, normal, stenotic, undersized, size;
  for (const RingOutcome& outcome : outcomes) {
    below.add(100.0 * share_below(outcome));
    leak.add(mean_leak_mm2(outcome));
    gradient.add(outcome.gradient_mmhg);
    durability.add(outcome.durability_mm);
    tenting.add(outcome.tenting_mm);
    suture.add(outcome.suture_max_n);
    normal.add(outcome.suture_normal_n);
    if (std::isfinite(outcome.gradient_mmhg))
      stenotic.add(outcome.gradient_mmhg > kStenosis_mmhg ? 100.0 : 0.0);
    undersized.add(outcome.sizes_below > kMostSizesBelow ? 100.0 : 0.0);
    size.add(outcome.size_mm);
  }
  return {.below_percent = below.value(),
          .leak_mm2 = leak.value(),
          .gradient_mmhg = gradient.value(),
          .durability_mm = durability.value(),
          .tenting_mm = tenting.value(),
          .suture_max_n = suture.value(),
          .suture_normal_n = normal.value(),
          .stenotic_percent = stenotic.value(),
          .undersized_percent = undersized.value(),
          .size_mm = size.value()};
}

std::vector<RingVerdict> verdicts_of(const std::vector<RingMember>& members,
                                     const std::vector<RingOutcome>& design,
                                     const std::vector<RingOutcome>& generic) {
  std::vector<std::string> aetiologies = {""};
  for (const RingMember& member : members)
    if (std::find(aetiologies.begin(), aetiologies.end(), member.aetiology) == aetiologies.end())
      aetiologies.push_back(member.aetiology);
  std::vector<RingVerdict> verdicts;
  for (const std::string& aetiology : aetiologies) {
    std::vector<RingOutcome> ours, theirs;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (!aetiology.empty() && members[i].aetiology != aetiology) continue;
      ours.push_back(design[i]);
      theirs.push_back(generic[i]);
    }
    RingVerdict verdict{.aetiology = aetiology,
                        .members = static_cast<int>(ours.size()),
                        .design = figures_of(ours),
                        .generic = figures_of(theirs)};
    if (members.size() == 1) {
      ours = by_disturbance(design[0]);
      theirs = by_disturbance(generic[0]);
    }
    std::vector<double> below, leak;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      below.push_back(100.0 * (share_below(ours[i]) - share_below(theirs[i])));
      leak.push_back(mean_leak_mm2(theirs[i]) - mean_leak_mm2(ours[i]));
    }
    verdict.below_percent = mean_interval(below);
    verdict.leak_mm2 = mean_interval(leak);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace coapt
