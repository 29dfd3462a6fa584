#include "core/valve/observed.h"

#include <algorithm>

namespace coapt {

void observe(std::vector<Observation>& observed, const Observation& seen) {
  std::erase_if(observed, [&](const Observation& before) { return before.figure == seen.figure; });
  observed.push_back(seen);
}

}  // namespace coapt
