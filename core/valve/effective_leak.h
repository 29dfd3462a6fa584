// The regurgitant area that flow shows, smaller than the opening itself: a jet contracts behind it.
#pragma once

#include <string>

#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "core/valve/valve.h"

namespace coapt {

/// Effective orifice area (flow convergence, volumetric Doppler), with one standard deviation. The discharge coefficient is effective over
/// anatomic area; its default is assumed.
struct EffectiveLeak {
  double value_mm2 = 0.0, sd_mm2 = 0.0;
  double discharge = 0.8, discharge_sd = 0.06;
  std::string source{};  ///< may be empty
};

/// Accepted; what they give is within kObservedRows.
inline constexpr Range kEffectiveLeaks_mm2 = {0.0, 500.0}, kEffectiveLeakSds_mm2 = {0.01, 250.0},
                       kDischarges = {0.5, 1.0}, kDischargeSds = {0.0, 0.3};

/// The anatomic area, both errors to first order; its source says what was seen.
inline Observation anatomic_leak(const EffectiveLeak& seen) {
  const double area_mm2 = seen.value_mm2 / seen.discharge;
  const Vec2 sd_mm2(seen.sd_mm2 / seen.discharge, area_mm2 * seen.discharge_sd / seen.discharge);
  const std::string kind = "effective orifice area " + shown(seen.value_mm2) + " ± " +
                           shown(seen.sd_mm2) + " mm2, discharge coefficient " +
                           shown(seen.discharge) + " ± " + shown(seen.discharge_sd);
  return {ObservedFigure::Leak, area_mm2, sd_mm2.norm(),
          kind + (seen.source.empty() ? "" : "; " + seen.source)};
}

}  // namespace coapt
