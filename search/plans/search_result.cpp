#include "search/plans/search_result.h"

#include <cmath>

namespace coapt {
namespace {

constexpr double kCertain = 0.95;

}  // namespace

bool trusted(const RankedPlan& plan) {
  return trusted(Evaluation{plan.status, plan.crossing, plan.measure});
}

bool closes_finely(const RankedPlan& plan) {
  return plan.fine_levels == 0 ||
         (plan.fine && trusted(*plan.fine) && plan.fine->leak_mm2 < kCompetentLeak_mm2);
}

bool closes_robustly(const RankedPlan& plan, double more_mm2) {
  const LeakStatistics& leak = plan.region.leak_mm2;
  return trusted(plan) && plan.region.failures == 0 && plan.region.closures > 1 &&
         leak.mean + more_mm2 + leak.sd < kCompetentLeak_mm2 && closes_finely(plan);
}

bool closes_robustly(const SearchResult& result) {
  return !result.plans.empty() && closes_robustly(result.plans.front());
}

bool survives_draws(const RankedPlan& plan) {
  return std::isnan(plan.share_of_draws_ahead) || plan.share_of_draws_ahead > kCertain;
}

bool ties_with_next(const RankedPlan& plan) {
  const double ahead = plan.probability_outranks_next;
  return (ahead >= 1.0 - kCertain && ahead <= kCertain) || !survives_draws(plan);
}

}  // namespace coapt
