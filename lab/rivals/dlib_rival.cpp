#include "lab/rivals/dlib_rival.h"

#include <dlib/global_optimization/global_function_search.h>

namespace coapt::rivals {

// The loop of find_min_global itself, which takes no seed.
void search_by_dlib(const RivalProblem& problem, const SharesCost& cost) {
  const auto dimensions = static_cast<long>(problem.counts.size());
  dlib::matrix<double, 0, 1> lower(dimensions);
  dlib::matrix<double, 0, 1> upper(dimensions);
  for (long k = 0; k < dimensions; ++k) {
    lower(k) = 0.0;
    upper(k) = problem.counts[static_cast<std::size_t>(k)] - 1.0;
  }
  dlib::global_function_search search(
      dlib::function_spec(lower, upper, std::vector<bool>(problem.counts.size(), true)));
  search.set_seed(static_cast<time_t>(problem.seed));
  for (int call = 0; call < kMostDlibCalls; ++call) {
    dlib::function_evaluation_request request = search.get_next_x();
    std::vector<double> shares;
    for (long k = 0; k < dimensions; ++k)
      shares.push_back(
          share_of(static_cast<int>(request.x()(k)), problem.counts[static_cast<std::size_t>(k)]));
    const std::optional<double> value = cost(shares);
    if (!value) return;
    request.set(-*value);  // it maximises
  }
}

}  // namespace coapt::rivals
