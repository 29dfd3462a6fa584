#include "search/plans/start_check.h"

#include <algorithm>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "search/parallel.h"

namespace coapt {
namespace {

struct TwoEnds {
  bool closed = false, trusted = false;
  double apart_mm = 0.0, leak_difference_mm2 = 0.0;
};

TwoEnds compare_ends(const ClosedPlan& a, const ClosedPlan& b) {
  TwoEnds ends{.closed = true, .trusted = trusted(a.evaluation) && trusted(b.evaluation)};
  if (!ends.trusted || !a.closure || !b.closure) return ends;
  const Points& x = a.closure->closed_mm;
  ends.apart_mm =
      std::sqrt((x - b.closure->closed_mm).squaredNorm() / static_cast<double>(x.rows()));
  ends.leak_difference_mm2 =
      std::abs(leak_mm2(a.evaluation.measure) - leak_mm2(b.evaluation.measure));
  return ends;
}

}  // namespace

std::optional<StartCheck> check_starts(PlanEvaluations& evaluations, const PlanRecord& plan,
                                       int nodes) {
  const int count = std::min(kStartSample, nodes - 1);
  if (count < 1 || evaluations.cancelled() || !evaluations.closed(plan).closure)
    return std::nullopt;
  const Expected<Valve> repaired = apply_plan(evaluations.valve(), plan.plan);
  std::vector<TwoEnds> ends(count);
  for_each_index(count, evaluations.threads(), [&](int i) {
    if (evaluations.cancelled()) return;
    const int node = (i + 1) * (nodes - 1) / count;
    const Valve disturbed = disturb(*repaired, plan.plan, disturbances()[node]);
    ends[i] =
        compare_ends(evaluations.closed(plan, node), evaluations.evaluate(disturbed, nullptr));
  });
  StartCheck check;
  for (const TwoEnds& of : ends) {
    if (!of.closed) return std::nullopt;
    check.closures += of.trusted;
    check.elsewhere += of.apart_mm > kElsewhere_mm;
    check.leak_difference_max_mm2 = std::max(check.leak_difference_max_mm2, of.leak_difference_mm2);
  }
  return check;
}

}  // namespace coapt
