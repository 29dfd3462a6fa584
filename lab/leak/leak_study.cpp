#include "lab/leak/leak_study.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/metrics/leak_estimate.h"
#include "core/metrics/quantile.h"
#include "lab/leak/drawn_valves.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();
constexpr double kLarge_mm2 = 5.0;      // above, errors are shares
constexpr double kCompetent_mm2 = 1.0;  // below, the verdict is "competent"

void close(const Valve& valve, LeakCase& of) {
  const ClosedValve closed = close_and_measure(valve);
  of.is_trusted = trusted(closed.closure);
  of.surface = leak_surface(closed.valve, closed.closure.closed_mm);
  if (of.is_trusted) of.areas = measured_areas(closed);
}

void open(const Valve& valve, LeakCase& of) {
  const Expected<OpenedValve> opened = open_valve(valve);
  if (!opened) return;
  of.is_trusted = trusted(opened->closure);
  of.surface = leak_surface(opened->valve, opened->closure.closed_mm);
  if (of.is_trusted) of.areas = measured_areas(*opened);
}

LeakCase study_leak(int number, const LeakStudyOptions& options) {
  const DrawnValve drawn = drawn_valve(number, options.seed);
  LeakCase one;
  one.number = number;
  one.valve = drawn.name;
  one.repair = drawn.repair;
  (options.opened ? open : close)(drawn.valve, one);
  if (!one.is_trusted) return one;
  const auto start = std::chrono::steady_clock::now();
  one.reference = reference_leak(one.surface, {.finest_mm = options.finest_mm});
  one.reference_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return one;
}

/// @param of whose measure number `measure` is judged; not empty
LeakAgreement agreement(const std::vector<const LeakCase*>& of, std::size_t measure) {
  LeakAgreement agreement;
  std::vector<double> percent, apart_mm2;
  for (const LeakCase* one : of) {
    const MeasuredArea& area = one->areas[measure];
    const double reference_mm2 = one->reference.area_mm2;
    const double error_mm2 = area.area_mm2 - reference_mm2;
    if (reference_mm2 > kLarge_mm2)
      percent.push_back(100.0 * error_mm2 / reference_mm2);
    else
      apart_mm2.push_back(std::abs(error_mm2));
    const bool competent = area.area_mm2 < kCompetent_mm2;
    agreement.flips += competent != (reference_mm2 < kCompetent_mm2);
    agreement.unsafe += competent && reference_mm2 >= kCompetent_mm2;
    agreement.with_error += !std::isnan(area.error_mm2);
    agreement.outside += std::abs(error_mm2) > area.error_mm2;
  }
  agreement.measure = of.front()->areas[measure].measure;
  agreement.large = static_cast<int>(percent.size());
  agreement.small = static_cast<int>(apart_mm2.size());
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
  };
  agreement.bias_percent = mean(percent);
  std::vector<double> squares, sizes;
  for (const double value : percent) {
    squares.push_back((value - agreement.bias_percent) * (value - agreement.bias_percent));
    sizes.push_back(std::abs(value));
  }
  agreement.sd_percent = std::sqrt(mean(squares));
  agreement.median_percent = quantile(sizes, 0.5);
  agreement.p90_percent = quantile(sizes, 0.9);
  agreement.worst_percent = quantile(sizes, 1.0);
  agreement.small_mean_mm2 = mean(apart_mm2);
  agreement.small_worst_mm2 = quantile(apart_mm2, 1.0);
  return agreement;
}

}  // namespace

std::vector<MeasuredArea> measured_areas(const ClosedValve& closed) {
  const ValveMeasure& m = closed.measure;
  return {{"estimate", estimate_leak_mm2(closed.valve, closed.closure.closed_mm), kNoError},
          {"leak", m.leak.area_mm2, m.leak_error_mm2}};
}

std::vector<MeasuredArea> measured_areas(const OpenedValve& opened) {
  const OpeningMeasure& m = opened.measure;
  return {{"projected", m.projected_area_mm2, kNoError}, {"leak", m.opening_area_mm2, kNoError}};
}

std::vector<LeakCase> study_leaks(const LeakStudyOptions& options,
                                  const std::function<void(int, int)>& progress) {
  std::vector<LeakCase> cases(static_cast<std::size_t>(options.count));
  std::mutex mutex;
  int done = 0;
  for_each_index(options.count, options.threads, [&](int number) {
    cases[static_cast<std::size_t>(number)] = study_leak(number, options);
    const std::scoped_lock lock(mutex);
    if (progress) progress(++done, options.count);
  });
  return cases;
}

std::vector<LeakAgreement> leak_agreements(const std::vector<LeakCase>& cases) {
  std::array<std::vector<const LeakCase*>, 2> halves;
  for (const LeakCase& one : cases)
    if (one.is_trusted) halves[static_cast<std::size_t>(one.number % 2)].push_back(&one);
  const std::size_t measures = halves[0].empty() ? 0 : halves[0].front()->areas.size();
  std::vector<LeakAgreement> agreements;
  for (std::size_t measure = 0; measure < measures; ++measure)
    for (const std::size_t half : {0U, 1U}) {
      if (halves[half].empty()) continue;
      agreements.push_back(agreement(halves[half], measure));
      agreements.back().valves = half == 0 ? "seen" : "held out";
    }
  return agreements;
}

}  // namespace coapt
