#pragma once

#include "search/search.h"

namespace coapt {

/// One line on standard error that shows how far a search is; nothing if that is not a terminal.
/// The line is gone when the bar is destroyed.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(const SearchProgress& progress) const;

 private:
  bool terminal_;
};

}  // namespace coapt
