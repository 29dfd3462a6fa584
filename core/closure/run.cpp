#include "core/closure/run.h"

namespace coapt {
namespace {

constexpr double kFarthest_mm = 1000.0;  // a node beyond it has left the scene

}  // namespace

bool has_diverged(const Points& x_mm) {
  return !x_mm.allFinite() || x_mm.cwiseAbs().maxCoeff() > kFarthest_mm;
}

}  // namespace coapt
