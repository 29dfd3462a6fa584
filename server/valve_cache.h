// Valves that requests name, read once: presets and stored ones, which never change.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/valve/valve.h"

namespace coapt {

class ValveCache {
 public:
  /// Null if it is not there.
  std::shared_ptr<const Valve> find(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = valves_.find(name);
    return found == valves_.end() ? nullptr : found->second;
  }

  /// In the place of the oldest, if there are kMost.
  void add(const std::string& name, Valve valve) {
    auto kept = std::make_shared<const Valve>(std::move(valve));
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!valves_.emplace(name, std::move(kept)).second) return;
    names_.push_back(name);
    if (names_.size() <= kMost) return;
    valves_.erase(names_.front());
    names_.pop_front();
  }

  void remove(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (valves_.erase(name) > 0) std::erase(names_, name);
  }

 private:
  static constexpr std::size_t kMost = 32;

  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Valve>> valves_;
  std::deque<std::string> names_;  // oldest first
};

}  // namespace coapt
