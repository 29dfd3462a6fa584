#include "clients/cli/exit_code.h"

#include <algorithm>

namespace coapt {
namespace {

bool competent(const RankedPlan& plan) {
  return plan.status == ClosureStatus::Converged && !plan.crossing &&
         plan.leak_mm2.nominal < kCompetentMm2;
}

}  // namespace

int exit_code_of(const ClosureResult& closure) {
  const bool closed = closure.status == ClosureStatus::Converged && !closure.crossing;
  return closed ? exit_code::kOk : exit_code::kNotClosed;
}

int exit_code_of(const SearchResult& result) {
  if (result.stop == SearchStop::Cancelled) return exit_code::kInterrupted;
  const bool any = std::any_of(result.plans.begin(), result.plans.end(), competent);
  return any ? exit_code::kOk : exit_code::kNoCompetentPlan;
}

}  // namespace coapt
