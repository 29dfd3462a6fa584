// What images show of a valve's closed state besides its shape: figures by which draws of the model are weighed (search/conditioning.h).
#pragma once

#include <array>
#include <string>
#include <vector>

namespace coapt {

enum class ObservedFigure {
  Leak,         ///< anatomic area of the regurgitant opening
  TentingArea,  ///< of the mid-valve section; < 0 where leaflets billow
  WidestGap     ///< of the ball that passes between the leaflets
};
inline constexpr int kObservedFigures = 3;

/// What one figure may be.
struct ObservedRow {
  const char* name;  ///< in JSON, with its unit
  const char* unit;
  double least, most;        ///< of the value
  double least_sd, most_sd;  ///< of how well it is known
};

/// In the order of ObservedFigure.
inline constexpr std::array<ObservedRow, kObservedFigures> kObservedRows = {
    {{"leak_mm2", "mm2", 0.0, 2000.0, 0.01, 1000.0},
     {"tenting_area_mm2", "mm2", -1000.0, 2000.0, 0.01, 1000.0},
     {"widest_gap_mm", "mm", 0.0, 50.0, 0.01, 50.0}}};

inline const ObservedRow& row_of(ObservedFigure figure) {
  return kObservedRows[static_cast<std::size_t>(figure)];
}

/// One standard deviation to either side, errors normal.
struct Observation {
  ObservedFigure figure = ObservedFigure::Leak;
  double value = 0.0, sd = 0.0;
  std::string source;  ///< who or what saw it; may be empty

  bool operator==(const Observation&) const = default;
};

/// Adds what was seen; a figure that was given before is replaced.
void observe(std::vector<Observation>& observed, const Observation& seen);

}  // namespace coapt
