// Counts closures, tells when to stop and reports progress. Shared by the threads of a search.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <mutex>

#include "search/search.h"

namespace coapt {

class Watch {
 public:
  using Clock = std::chrono::steady_clock;

  Watch(double seconds, const std::atomic<bool>* cancelled,
        const std::function<void(const SearchProgress&)>& progress)
      : seconds_(seconds), cancelled_(cancelled), progress_(progress) {}

  void plan(int closures) { planned_ = closures; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  /// Whether to go no further. Once true, always true.
  bool stopped() { return cancelled() || past(1.0); }
  /// Whether to try no more plans: the rest of the time is for ranking those there are.
  bool search_stopped() { return cancelled() || past(1.0 - kRankingShare); }
  /// Why the search ends: EvaluationLimit unless one of them has ever been true.
  SearchStop stop() const { return stop_; }
  /// How many more closures the time allows, at the pace so far.
  double affordable() const {
    if (seconds_ <= 0.0) return std::numeric_limits<double>::infinity();
    return std::max(0.0, seconds_ / seconds() - 1.0) * closures_;
  }

  /// @param is_plan of an undisturbed plan, whose leak may be the best.
  void closed(const Evaluation& evaluation, bool is_plan) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++closures_;
    if (evaluation.status != ClosureStatus::Converged) ++not_converged_;
    if (evaluation.crossing) ++crossed_;
    const double leak = leak_mm2(evaluation.measure);
    if (is_plan && trusted(evaluation) && (!any_ || leak < best_leak_mm2_)) {
      best_leak_mm2_ = leak;
      any_ = true;
    }
    if (progress_) progress_({closures_, planned_, best_leak_mm2_});
  }

  int closures() const { return closures_; }
  int not_converged() const { return not_converged_; }
  int crossed() const { return crossed_; }

 private:
  static constexpr double kRankingShare = 0.4;  // of the time: the default search spends a quarter

  bool cancelled() {
    if (cancelled_ == nullptr || !cancelled_->load()) return false;
    stop_ = SearchStop::Cancelled;
    return true;
  }
  bool past(double share) {
    if (seconds_ <= 0.0 || seconds() < share * seconds_) return false;
    SearchStop none = SearchStop::EvaluationLimit;
    stop_.compare_exchange_strong(none, SearchStop::TimeLimit);
    return true;
  }

  Clock::time_point started_ = Clock::now();
  double seconds_;
  const std::atomic<bool>* cancelled_;
  const std::function<void(const SearchProgress&)>& progress_;
  std::atomic<SearchStop> stop_ = SearchStop::EvaluationLimit;
  std::mutex mutex_;
  int planned_ = 0, closures_ = 0, not_converged_ = 0, crossed_ = 0;
  double best_leak_mm2_ = 0.0;
  bool any_ = false;
};

}  // namespace coapt
