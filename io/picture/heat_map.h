// A matrix of values as coloured cells, each with its value; in blocks side by side if need be.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/picture/chart_frame.h"

namespace coapt {

struct HeatMap {
  std::string title;
  std::string row_label;                                 ///< beside the rows, upwards
  std::vector<std::string> row_ticks;                    ///< from the lowest row upwards
  std::vector<std::string> column_ticks;                 ///< of one block
  std::vector<std::string> blocks;                       ///< above each block; at least one
  std::vector<std::vector<std::vector<double>>> values;  ///< [block][row][column]; NaN: left empty
  std::optional<std::array<std::size_t, 2>> framed{};    ///< row, column of a cell to stand out
};

/// `low` to `high`: the colour scale's ends, which values beyond take, too.
struct HeatScale {
  double low = 0.0, high = 1.0;
  int decimals = 0;  ///< of the values written in the cells; below 0: none are
  /// Where the shades change, ascending, kShades - 1 of them; empty: evenly from low to high.
  std::span<const double> limits{};
};

std::string draw_heat_map(const HeatMap& map, const HeatScale& scale, const PlotBox& box);

/// Bar with the limits of its shades, or with round values; `x`, `y`: its upper left corner.
std::string draw_scale(const HeatScale& scale, const std::string& label, double x, double y);

}  // namespace coapt
