// Tells a search when to stop, and its caller how far it is. Shared by the threads of a search.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace coapt {

/// Why a search ended.
enum class SearchStop {
  EvaluationLimit,
  Exhausted,      ///< no plan is left that bounds and expectations do not rule out
  NoImprovement,  ///< for as many closures as asked for
  TargetReached,
  TimeLimit,
  Cancelled
};

struct SearchProgress {
  int closures = 0, closures_planned = 0;
  double best_leak_mm2 = 0.0;  ///< of plans as planned, so far; infinite before the first
  std::string stage;           ///< "searching", "ranking", ...
  /// Best so far of one closure a plan, and what random search is expected to have after as many closures; infinite while
  /// they are not known.
  double best_cost = kUnknown, random_cost = kUnknown;

  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
};

class Watch {
 public:
  using Clock = std::chrono::steady_clock;
  using Report = std::function<void(const SearchProgress&)>;

  /// @param seconds 0: no limit. @param cancelled may be null.
  Watch(double seconds, const std::atomic<bool>* cancelled, Report report = {})
      : seconds_(seconds), cancelled_(cancelled), report_(std::move(report)) {}

  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  /// Whether to go no further.
  bool stopped() const { return cancelled() || out_of_time(1.0); }
  /// Whether to try no more plans: the rest of the time is for ranking those there are.
  bool search_stopped() const { return cancelled() || out_of_time(1.0 - kRankingShare); }
  bool cancelled() const { return cancelled_ != nullptr && cancelled_->load(); }
  /// Of the time that is left for ranking.
  double seconds_left() const { return seconds_ <= 0.0 ? 1e9 : seconds_ - seconds(); }

  void plan(int closures, const std::string& stage) {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.closures_planned = closures;
    progress_.stage = stage;
  }
  void found(double cost) {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.best_cost = cost;
  }
  /// @param costs expected of random search after 1, 2, ... closures
  void expect_of_random(std::vector<double> costs) {
    const std::lock_guard<std::mutex> lock(mutex_);
    random_costs_ = std::move(costs);
  }
  /// @param best_leak_mm2 of this plan as planned, infinite if it is none.
  void closed(double leak_mm2) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++progress_.closures;
    if (leak_mm2 < progress_.best_leak_mm2) progress_.best_leak_mm2 = leak_mm2;
    if (!random_costs_.empty())
      progress_.random_cost = random_costs_[std::min(static_cast<std::size_t>(progress_.closures),
                                                     random_costs_.size()) -
                                            1];
    if (report_) report_(progress_);
  }

 private:
  static constexpr double kRankingShare = 0.4;  // of the time: the default search spends half on it

  bool out_of_time(double share) const { return seconds_ > 0.0 && seconds() >= share * seconds_; }

  Clock::time_point started_ = Clock::now();
  double seconds_;
  const std::atomic<bool>* cancelled_;
  Report report_;
  std::mutex mutex_;
  SearchProgress progress_{0, 0, SearchProgress::kUnknown, ""};
  std::vector<double> random_costs_;
};

}  // namespace coapt
