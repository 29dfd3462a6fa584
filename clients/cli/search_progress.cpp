#include "clients/cli/search_progress.h"

#include <cmath>

#include "io/picture/text.h"

namespace coapt {

void show(const ProgressBar& bar, const SearchProgress& progress) {
  const std::string best =
      std::isfinite(progress.best_leak_mm2)
          ? ", lowest planned leak " + fixed(progress.best_leak_mm2, 1) + " mm2"
          : "";
  bar.show(progress.closures, progress.closures_planned, "closures, " + progress.stage + best);
}

}  // namespace coapt
