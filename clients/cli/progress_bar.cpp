#include "clients/cli/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr int kWidth = 30;
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_) std::cerr << kClearLine << std::flush;
}

void ProgressBar::show(const SearchProgress& progress) const {
  const std::string best =
      std::isinf(progress.best_leak_mm2)
          ? ""
          : ", lowest leak as planned " + fixed(progress.best_leak_mm2, 1) + " mm2";
  show(progress.closures, progress.closures_planned, "closures, " + progress.stage + best);
}

void ProgressBar::show(int done, int planned, const std::string& what) const {
  if (!terminal_) return;
  const int filled = std::min(kWidth, kWidth * done / std::max(planned, 1));
  std::cerr << kClearLine << '[' << std::string(static_cast<std::size_t>(filled), '#')
            << std::string(static_cast<std::size_t>(kWidth - filled), '.') << "] " << done << " of "
            << std::max(planned, 1) << ' ' << what << std::flush;
}

}  // namespace coapt
