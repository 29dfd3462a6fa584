// The problems found in one input, bounded so that a hostile one cannot fill the memory with
// messages.
#pragma once

#include <string>
#include <utility>

#include "core/valve/number_text.h"
#include "core/valve/types.h"

namespace coapt {

class ProblemList {
 public:
  static constexpr std::size_t kMaxListed = 200;
  static constexpr std::size_t kMaxCounted = 10000;

  void add(ErrorCode code, std::string path, std::string message) {
    if (listed_.size() < kMaxListed) {
      listed_.push_back({code, std::move(path), std::move(message)});
    } else {
      ++unlisted_;
      last_code_ = code;
    }
  }

  /// Problems found elsewhere and not listed there.
  void add_unlisted(std::size_t count) { unlisted_ += count; }

  bool empty() const { return listed_.empty(); }
  const Errors& listed() const { return listed_; }
  std::size_t unlisted() const { return unlisted_; }
  /// So many that it is no use to look for more.
  bool crowded() const { return unlisted_ >= kMaxCounted; }

  /// The problems in the order found; a last one says how many more there are, if there are.
  Errors take() && {
    if (unlisted_ > 0) {
      const std::string count =
          crowded() ? "at least " + std::to_string(kMaxCounted) : std::to_string(unlisted_);
      listed_.push_back({last_code_, "", count + " more problems, not listed"});
    }
    return std::move(listed_);
  }

 private:
  Errors listed_;
  std::size_t unlisted_ = 0;
  ErrorCode last_code_ = ErrorCode::OutOfRange;
};

/// Inclusive.
struct Range {
  double min = 0.0;
  double max = 0.0;
};

/// OutOfRange unless `number` is inside; NaN never is. `unit` with its leading blank (" mm") or
/// empty.
inline bool check_range(ProblemList& problems, const std::string& path, double number, Range range,
                        const char* unit = "") {
  if (number >= range.min && number <= range.max) return true;
  problems.add(ErrorCode::OutOfRange, path,
               "is " + shown(number) + ", must be from " + shown(range.min) + " to " +
                   shown(range.max) + unit);
  return false;
}

}  // namespace coapt
