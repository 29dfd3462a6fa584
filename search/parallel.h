// The one parallel loop of coapt.
#pragma once

#include <vector>

#include "search/threads.h"

namespace coapt {

/// Calls function(i) for each i in [0, count), on `threads` threads (0: all cores), in any order;
/// each call may write only what belongs to index i. An exception is held back until all calls have
/// ended; that of the smallest index is then thrown here.
template <class Function>
void for_each_index(int count, int threads, const Function& function) {
  std::vector<Thrown> thrown(count);
  [[maybe_unused]] const int team = threads > 0 ? threads : all_cores();
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) num_threads(team)
#endif
  for (int i = 0; i < count; ++i) thrown[i].returns([&] { function(i); });
  for (const Thrown& one : thrown) one.rethrow();
}

}  // namespace coapt
