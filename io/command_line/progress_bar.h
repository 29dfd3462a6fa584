#pragma once

#include <cstdint>
#include <string>

namespace coapt {

/// One line on standard error that shows how far something is; nothing if that is not a terminal.
/// The line is gone when the bar is destroyed.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `what` follows the numbers: "3 of 10 closures".
  void show(std::int64_t done, std::int64_t planned, const std::string& what) const;

 private:
  bool terminal_;
};

}  // namespace coapt
