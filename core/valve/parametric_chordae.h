#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// The structured skirt that chordae are attached to: vertex (row, station) = row * stations +
/// station.
struct SkirtGrid {
  int stations = 0, rows = 0;
  std::vector<double> around;  ///< per station, ascending from 0
};

/// Adds heads and chordae to a skirt. Tips: m x 3 in the valve's frame, x < 0 belongs to the
/// anterolateral muscle; one tip a side becomes three heads 2.5 mm apart, more than one are taken
/// as they are.
void add_parametric_chordae(const SkirtGrid& grid, const Points& tips_mm, Valve& valve);

}  // namespace coapt
