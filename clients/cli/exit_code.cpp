#include "clients/cli/exit_code.h"

#include "search/evaluator.h"

namespace coapt {

int exit_code_of(const ClosureResult& closure) {
  return trusted(closure) ? exit_code::kOk : exit_code::kNotClosed;
}

int exit_code_of(const SearchResult& result) {
  if (result.stop == SearchStop::Cancelled) return exit_code::kInterrupted;
  return closes_robustly(result) ? exit_code::kOk : exit_code::kNoRobustPlan;
}

}  // namespace coapt
