// Tells a search when to stop, and its caller how far it is. Shared by the threads of a search.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "search/plans/search_progress.h"
#include "search/threads.h"

namespace coapt {

/// Called from several threads at once.
using SearchClock = std::function<std::chrono::steady_clock::time_point()>;

class SearchMonitor {
 public:
  using Clock = std::chrono::steady_clock;
  using Report = std::function<void(const SearchProgress&)>;

  /// @param seconds 0: no limit. @param cancelled may be null. @param now empty: the steady clock.
  SearchMonitor(double seconds, const std::atomic<bool>* cancelled, Report report = {},
                SearchClock now = {})
      : now_(now ? std::move(now) : SearchClock(&Clock::now)),
        seconds_(seconds),
        cancelled_(cancelled),
        report_(std::move(report)) {}

  double seconds() const { return std::chrono::duration<double>(now_() - started_).count(); }
  /// Whether to go no further.
  bool stopped() const { return cancelled() || out_of_time(1.0); }
  /// Whether to try no more plans: the rest of the time is for ranking those there are.
  bool search_stopped() const { return cancelled() || out_of_time(1.0 - kRankingShare); }
  bool cancelled() const { return cancelled_ != nullptr && cancelled_->load(); }
  /// Of the time that is left for ranking.
  double seconds_left() const { return seconds_ <= 0.0 ? 1e9 : seconds_ - seconds(); }

  void plan(int closures, const std::string& stage) {
    const Lock lock(mutex_);
    progress_.closures_planned = closures;
    progress_.stage = stage;
  }
  void plan_more(int closures) {
    const Lock lock(mutex_);
    progress_.closures_planned += closures;
  }
  void found(double cost) {
    const Lock lock(mutex_);
    progress_.best_cost = cost;
  }
  void leads(LeadingPlan plan) {
    auto shared = std::make_shared<const LeadingPlan>(std::move(plan));
    const Lock lock(mutex_);
    progress_.leading = std::move(shared);
  }
  /// @param costs expected of random search after 1, 2, ... closures
  void expect_of_random(std::vector<double> costs) {
    const Lock lock(mutex_);
    random_costs_ = std::move(costs);
  }
  /// @param leak_mm2 of this plan as planned, infinite if it is none.
  void closed(double leak_mm2) {
    const Lock lock(mutex_);
    ++progress_.closures;
    if (leak_mm2 < progress_.best_leak_mm2) progress_.best_leak_mm2 = leak_mm2;
    if (!random_costs_.empty()) {
      const int known = std::min(progress_.closures, static_cast<int>(random_costs_.size()));
      progress_.random_cost = random_costs_[known - 1];
    }
    if (report_) report_(progress_);
  }

 private:
  static constexpr double kRankingShare = 0.4;  // of the time: the default search spends half on it

  bool out_of_time(double share) const { return seconds_ > 0.0 && seconds() >= share * seconds_; }

  SearchClock now_;
  Clock::time_point started_ = now_();
  double seconds_;
  const std::atomic<bool>* cancelled_;
  Report report_;
  Mutex mutex_;
  SearchProgress progress_;
  std::vector<double> random_costs_;
};

}  // namespace coapt
