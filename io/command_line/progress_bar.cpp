#include "io/command_line/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace coapt {
namespace {

constexpr int kWidth = 30;
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (terminal_) std::cerr << kClearLine << std::flush;
}

void ProgressBar::show(std::int64_t done, std::int64_t planned, const std::string& what) const {
  if (!terminal_) return;
  planned = std::max<std::int64_t>(planned, 1);
  const std::int64_t filled = std::min<std::int64_t>(kWidth, kWidth * done / planned);
  std::cerr << kClearLine << '[' << std::string(static_cast<std::size_t>(filled), '#')
            << std::string(static_cast<std::size_t>(kWidth - filled), '.') << "] " << done << " of "
            << planned << ' ' << what << std::flush;
}

}  // namespace coapt
