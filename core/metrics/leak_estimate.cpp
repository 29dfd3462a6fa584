#include "core/metrics/leak_estimate.h"

#include <algorithm>
#include <limits>

#include "core/metrics/gap.h"
#include "core/metrics/orifice.h"

namespace coapt {
namespace {

constexpr ImageSize kSize{200, 150};

}  // namespace

double estimate_leak_mm2(const Valve& valve, const Points& closed_mm) {
  if (!closed_mm.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  const double orifice = orifice_mm2(valve, closed_mm, 0.5 * valve.tissue.thickness_mm, kSize);
  return is_mitral(valve) ? std::max(orifice, gap_mm2(valve, closed_mm)) : orifice;
}

}  // namespace coapt
