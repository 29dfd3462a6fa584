#include "core/closed/accurate_closure.h"

#include <optional>
#include <string>
#include <utility>

#include "core/closed/close_refined.h"
#include "core/metrics/area_error.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kStoppingShare = 0.7;  // the other parts of the error have as much, squared

Error too_small(double error_mm2, double least_mm2, const std::string& limit) {
  return {ErrorCode::OutOfRange, "/accuracy",
          "is " + shown(error_mm2) + ", must be at least " + significant(least_mm2, 2) + " mm2, " +
              limit};
}

/// Of the leak of `closed` on the finest mesh with at most `most_vertices`, which refining quadruples.
double finest_error_mm2(const ClosedValve& closed, int most_vertices) {
  AreaPrecision precision = precision_of(closed.valve, closed.closure);
  for (Index vertices = 4 * closed.valve.rest_mm.rows(); vertices <= most_vertices; vertices *= 4)
    precision.triangles *= 4;
  return area_error_mm2(closed.measure.leak.area_mm2, precision);
}

}  // namespace

Expected<AccurateClosure> close_within(const Valve& valve, double error_mm2,
                                       const ClosureOptions& options, int most_vertices) {
  const Expected<AccuracyTier> tier = choose_tier(kStoppingShare * error_mm2, options.membrane);
  if (!tier)
    return too_small(error_mm2,
                     error_of(accuracy_tiers().back(), options.membrane).p99_mm2 / kStoppingShare,
                     "the accuracy that the tightest tolerances allow");
  const ClosureOptions tolerances = at_tier(options, *tier);
  AccurateClosure accurate{close_and_measure(valve, tolerances), *tier, 0};
  ClosedValve& closed = accurate.closed;
  while (closed.measure.leak_error_mm2 > error_mm2) {
    const double least_mm2 = finest_error_mm2(closed, most_vertices);
    std::optional<ClosedValve> finer;
    if (least_mm2 <= error_mm2) finer = close_refined(closed, tolerances, most_vertices);
    if (!finer)
      return too_small(
          error_mm2, least_mm2,
          "the error of this leak of " + with_decimals(closed.measure.leak.area_mm2, 1) +
              " mm2 on the finest mesh of at most " + std::to_string(most_vertices) + " vertices");
    closed = *std::move(finer);
    ++accurate.refinements;
  }
  return accurate;
}

}  // namespace coapt
