// Small multiples of line charts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/picture/chart_frame.h"

namespace coapt {

struct PanelSeries {
  std::string label;         ///< in the legend, once per chart; none: not in it
  std::vector<double> x, y;  ///< a value that is not finite breaks the line
  Hue hue = Hue::Blue;
  Mark mark = Mark::Line;
  std::vector<double> low{}, high{};  ///< bars through the points; same size as y, or none
  double shift_px = 0.0;              ///< to the right, so that bars stand side by side
  std::vector<std::string> names{};   ///< beside the points; same size as y, or none
};

struct LinePanel {
  FrameWords words;
  std::vector<PanelSeries> series;
  std::optional<Axis> x_axis{};  ///< none: round, around the points
  Extent x_holds{}, y_holds{};   ///< values that an axis shows in any case
};

struct LineChart {
  std::string title, note;
  std::vector<LinePanel> panels;
  int columns = 3;
  double panel_height = 300.0;  ///< px, words included
  bool same_y = false;          ///< one y axis for all panels
  double width = kFigureWidth;  ///< px
};

std::string line_chart_svg(const LineChart& chart);
/// One panel, words included, in a box.
std::string draw_line_panel(const LinePanel& panel, const PlotBox& box);
/// The same without title, from `top` downwards, to stand in a figure with other things.
Drawn draw_line_panels(const LineChart& chart, double top);
std::vector<LegendEntry> legend_of(const LineChart& chart);

}  // namespace coapt
