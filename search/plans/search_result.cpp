#include "search/plans/search_result.h"

namespace coapt {

bool trusted(const RankedPlan& plan) {
  return trusted(Evaluation{plan.status, plan.crossing, plan.measure});
}

bool closes_finely(const RankedPlan& plan) {
  return plan.fine_levels == 0 ||
         (plan.fine && trusted(*plan.fine) && leak_mm2(*plan.fine) < kCompetentLeak_mm2);
}

bool closes_robustly(const RankedPlan& plan) {
  const OrificeStatistics& leak = plan.region.leak_mm2;
  return trusted(plan) && plan.region.failures == 0 && plan.region.closures > 1 &&
         leak.mean + leak.sd < kCompetentLeak_mm2 && closes_finely(plan);
}

bool closes_robustly(const SearchResult& result) {
  return !result.plans.empty() && closes_robustly(result.plans.front());
}

}  // namespace coapt
