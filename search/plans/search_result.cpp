#include "search/plans/search_result.h"

namespace coapt {

bool trusted(const RankedPlan& plan) {
  return trusted(Evaluation{plan.status, plan.crossing, plan.measure});
}

bool closes_finely(const RankedPlan& plan) {
  return plan.fine_levels == 0 ||
         (plan.fine && trusted(*plan.fine) && plan.fine->leak_mm2 < kMildLeak_mm2);
}

bool is_acceptable(const SearchResult& result) {
  return !result.plans.empty() && result.plans.front().is_acceptable;
}

}  // namespace coapt
