// How the farm stands that the service hands its jobs to.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>

#include "farm/ask/farm.h"
#include "io/json/json.h"

namespace coapt {

class FarmWatch {
 public:
  /// None: the service works by itself.
  explicit FarmWatch(std::optional<Farm> farm) : farm_(std::move(farm)) {}

  bool has_farm() const { return farm_.has_value(); }

  /// {"runs": [...], "workers": [...]}, at most a second old: what users of the service may know, neither machines nor accounts. From
  /// any thread; some 30 ms. Errors: the farm does not answer. @pre has_farm()
  Expected<Json> status();

 private:
  std::optional<Farm> farm_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point asked_;
  std::optional<Expected<Json>> last_;
};

}  // namespace coapt
