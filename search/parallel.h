// The one parallel loop of coapt.
#pragma once

#include <vector>

#include "search/threads.h"

namespace coapt {

/// Calls function(i) for each i in [0, count), on `threads` threads (0: all cores), in any order;
/// each call may write only what belongs to index i. An exception is held back until all calls have
/// ended; that of the smallest index is then thrown here.
#if defined(__wasm__)
/// Workers that run the same program side by side make those that nobody has begun, wait for the others', and make those, too, by
/// what they left.
template <class Function>
void for_each_index(int count, int /*threads*/, const Function& function) {
  const bool is_shared = coapt_loop_begin(count) != 0;
  std::vector<bool> made(count);
  for (int i = 0; is_shared && (i = coapt_loop_take()) >= 0; made[i] = true) function(i);
  for (int i = 0; i < count; ++i)
    if (!made[i]) function(i);
  if (is_shared) coapt_loop_end();
}
#else
template <class Function>
void for_each_index(int count, int threads, const Function& function) {
  std::vector<Thrown> thrown(count);
  const int team = threads > 0 ? threads : all_cores();
#pragma omp parallel for schedule(dynamic) num_threads(team)
  for (int i = 0; i < count; ++i) thrown[i].returns([&] { function(i); });
  for (const Thrown& one : thrown) one.rethrow();
}
#endif

}  // namespace coapt
