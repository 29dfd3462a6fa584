// The one parallel loop of coapt.
#pragma once

#include <omp.h>

#include <exception>
#include <vector>

namespace coapt {

/// Calls function(i) for each i in [0, count), on `threads` threads (0: all cores), in any order;
/// each call may write only what belongs to index i. An exception is held back until all calls have
/// ended; that of the smallest index is then thrown here.
template <class Function>
void for_each_index(int count, int threads, const Function& function) {
  std::vector<std::exception_ptr> thrown(count);
  const int team = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(team)
  for (int i = 0; i < count; ++i) {
    try {
      function(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  }
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

}  // namespace coapt
