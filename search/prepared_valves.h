// The valves that were prepared last, for closures that ask for one after the other.
#pragma once

#include <memory>
#include <vector>

#include "core/closure/prepared_valve.h"
#include "search/threads.h"

namespace coapt {

/// From any thread.
class PreparedValves {
 public:
  /// One that serves that valve, made if there is none.
  std::shared_ptr<const PreparedValve> of(const Valve& valve, const ClosureOptions& options);

 private:
  Mutex mutex_;
  std::vector<std::shared_ptr<const PreparedValve>> newest_;  // last
};

}  // namespace coapt
