// What measures of the leak are worth: many valves closed (or opened), each measure compared with the reference.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/closed/closed_valve.h"
#include "core/opened/opened_valve.h"
#include "lab/leak/reference_leak.h"

namespace coapt {

/// What a measure says of one valve.
struct MeasuredArea {
  std::string measure;
  double area_mm2 = 0.0;
  double error_mm2 = 0.0;  ///< as printed; NaN: none is
};

/// Every measure that the product has, each a line.
std::vector<MeasuredArea> measured_areas(const ClosedValve& closed);
std::vector<MeasuredArea> measured_areas(const OpenedValve& opened);

struct LeakStudyOptions {
  int count = 200;  ///< valves (drawn_valves.h)
  std::uint64_t seed = 1;
  double finest_mm = 0.25;  ///< of the reference
  bool opened = false;      ///< valves in diastole instead of closed ones
  int threads = 0;          ///< 0: all cores
};

struct LeakCase {
  int number = 0;  ///< odd: held out
  std::string valve, repair;
  bool is_trusted = false;  ///< else it came to no rest, and there are no areas
  LeakSurface surface;
  std::vector<MeasuredArea> areas;
  ReferenceLeak reference;
  double reference_seconds = 0.0;
};

/// By number; the same for any number of threads. `progress`: valves done and planned.
std::vector<LeakCase> study_leaks(const LeakStudyOptions& options,
                                  const std::function<void(int, int)>& progress = {});

/// How one measure agrees with the reference over some of the cases.
struct LeakAgreement {
  std::string measure;
  std::string valves;  ///< "seen", "held out"
  /// Of references above 5 mm2: their number, and the measure's errors over the reference, per cent; all but bias and sd absolute.
  int large = 0;
  double bias_percent = 0.0, sd_percent = 0.0, median_percent = 0.0, p90_percent = 0.0,
         worst_percent = 0.0;
  /// Of the others: absolute errors.
  int small = 0;
  double small_mean_mm2 = 0.0, small_worst_mm2 = 0.0;
  int flips = 0;                    ///< on the other side of 1 mm2 than the reference
  int unsafe = 0;                   ///< of them those that call a leaking valve competent
  int outside = 0, with_error = 0;  ///< the reference is outside of the printed error; of how many
};

/// Measure by measure, trusted cases of even number before those of odd number.
std::vector<LeakAgreement> leak_agreements(const std::vector<LeakCase>& cases);

}  // namespace coapt
