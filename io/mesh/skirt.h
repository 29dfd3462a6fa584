// Leaflet sheets resampled to a structured skirt, closed at the commissures.
#pragma once

#include "io/mesh/import_frame.h"

namespace coapt {

/// Stations at equal arcs of the annulus, counter-clockwise from the posteromedial commissure; each
/// holds rows + 1 points from the annulus to the free edge at equal lengths.
struct Skirt {
  int stations = 0;  ///< even
  int rows = 0;
  int lateral_commissure = 0;         ///< station
  Points vertices_mm;                 ///< (rows + 1) * stations x 3: row * stations + station
  std::vector<bool> interpolated;     ///< stations without sheet
  double widest_bridge_mm = 0.0;      ///< over holes and bites of the sheets
  double annulus_gap_mm = 0.0;        ///< mean distance from the annulus to where the sheets begin
  double spacing_mm = 0.0;            ///< of the stations along the annulus
  double hat_mm = 0.0;                ///< half the width of the smoothing along the annulus
  bool commissures_measured = false;  ///< where the two sheets meet; else by share of the annulus
  bool commissures_given = false;     ///< both
  double commissures_off_mm =
      0.0;  ///< of those given from where the sheets meet, along the annulus, the larger of both
  /// Of leaflets imaged closed, at their middles: exposed lengths.
  double anterior_exposed_mm = 0.0, posterior_exposed_mm = 0.0;
};

/// What the sheets show: leaflets that hang open, or closed ones, of which `hidden_mm` lie unseen in coaptation
/// (hanging_profile.h).
struct ImagedLeaflets {
  bool closed = false;
  double hidden_mm = 0.0;
};

struct SkirtSize {
  int stations = 0, rows = 0;
  int vertices() const { return (rows + 1) * stations; }
};

/// For about `triangles` triangles, 2 * stations * rows, with ten times as many stations as rows.
SkirtSize skirt_size(int triangles);

/// Errors: sheets that leave more than a third of the annulus bare, or that do not meet twice; any if the budget is cancelled.
Expected<Skirt> resample_skirt(const FramedSource& source, const SkirtSize& size,
                               const ImagedLeaflets& imaged = {}, const ClosureBudget& budget = {});

}  // namespace coapt
