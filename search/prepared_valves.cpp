#include "search/prepared_valves.h"

#include <algorithm>

namespace coapt {
namespace {

constexpr std::size_t kKept = 8;  // a million bytes each at 650 triangles

}  // namespace

std::shared_ptr<const PreparedValve> PreparedValves::of(const Valve& valve,
                                                        const ClosureOptions& options) {
  {
    const Lock lock(mutex_);
    const auto found = std::find_if(newest_.begin(), newest_.end(), [&](const auto& prepared) {
      return prepared->serves(valve, options);
    });
    if (found != newest_.end()) {
      std::rotate(found, found + 1, newest_.end());
      return newest_.back();
    }
  }
  auto prepared = std::make_shared<const PreparedValve>(valve, options);
  const Lock lock(mutex_);
  if (newest_.size() == kKept) newest_.erase(newest_.begin());
  newest_.push_back(prepared);
  return prepared;
}

}  // namespace coapt
