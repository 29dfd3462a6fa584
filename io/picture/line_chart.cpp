#include "io/picture/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kDotsUpTo = 16;  // points of a line; more would run together

using Values = std::vector<double> PanelSeries::*;
constexpr std::array<Values, 1> kAllX = {&PanelSeries::x};
constexpr std::array<Values, 3> kAllY = {&PanelSeries::y, &PanelSeries::low, &PanelSeries::high};

Extent range_of(const LinePanel& panel, std::span<const Values> which, const Extent& start) {
  Extent range = start;
  for (const PanelSeries& series : panel.series)
    for (const Values values : which)
      for (const double value : series.*values) range = including(range, value);
  return range;
}

std::string circle(const PanelSeries& series, double x, double y) {
  const bool hollow = series.mark == Mark::Hollow;
  return "<circle class=\"" + std::string(hollow ? "hollow " : "solid ") + css_class(series.hue) +
         "\" cx=\"" + fixed(x, 1) + "\" cy=\"" + fixed(y, 1) + "\" r=\"" +
         (hollow                     ? "5"
          : series.mark == Mark::Dot ? "4.5"
                                     : "3") +
         "\"/>\n";
}

std::string draw_series(const Frame& frame, const PanelSeries& series) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  const bool line = !line_class(series.mark).empty();
  const bool dots = !line || (series.mark == Mark::Line && count <= kDotsUpTo);
  const std::string hue = css_class(series.hue);
  std::string path, marks;
  bool pen_down = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      pen_down = false;
      continue;
    }
    const double x = x_at(frame, series.x[i]) + series.shift_px;
    const double y = y_at(frame, series.y[i]);
    path += (pen_down ? "L" : "M") + fixed(x, 1) + " " + fixed(y, 1);
    pen_down = true;
    if (dots) marks += circle(series, x, y);
    if (i < std::min(series.low.size(), series.high.size()) && std::isfinite(series.low[i]) &&
        std::isfinite(series.high[i]))
      marks += line_at(("line thin " + hue).c_str(), x, y_at(frame, series.low[i]), x,
                       y_at(frame, series.high[i]));
    if (i < series.names.size())
      marks += text_at(x + 9.0, y + 4.0, "class=\"" + hue + "\"", series.names[i]);
  }
  if (!line || path.empty()) return marks;
  return "<path class=\"" + line_class(series.mark) + " " + hue + "\" d=\"" + path + "\"/>\n" +
         marks;
}

}  // namespace

std::vector<LegendEntry> legend_of(const LineChart& chart) {
  std::vector<LegendEntry> legend;
  for (const LinePanel& panel : chart.panels)
    for (const PanelSeries& series : panel.series)
      if (!series.label.empty() &&
          std::none_of(legend.begin(), legend.end(),
                       [&](const LegendEntry& entry) { return entry.label == series.label; }))
        legend.push_back({series.label, css_class(series.hue), series.mark});
  return legend;
}

std::string draw_line_panel(const LinePanel& panel, const PlotBox& box) {
  const bool decades = panel.x_axis && panel.x_axis->log;
  const double margin = decades ? 26.0 : 16.0;  // half of "1000000", the last tick
  const Frame frame{
      {box.left + 60.0, box.top + 30.0, box.right - margin, box.bottom - 46.0},
      panel.x_axis ? *panel.x_axis : round_axis(range_of(panel, kAllX, panel.x_holds)),
      round_axis(range_of(panel, kAllY, panel.y_holds))};
  std::string svg = draw_frame(frame, panel.words);
  for (const PanelSeries& series : panel.series) svg += draw_series(frame, series);
  return svg;
}

Drawn draw_line_panels(const LineChart& chart, double top) {
  const CellGrid grid{static_cast<int>(chart.panels.size()), chart.columns, top, chart.panel_height,
                      chart.width};
  Extent common;
  for (const LinePanel& panel : chart.panels) {
    const Extent range = range_of(panel, kAllY, panel.y_holds);
    common = including(including(common, range.low), range.high);
  }
  Drawn drawn{"", bottom_of(grid)};
  for (int i = 0; i < grid.count; ++i) {
    LinePanel panel = chart.panels[static_cast<std::size_t>(i)];
    if (chart.same_y) panel.y_holds = common;
    drawn.svg += draw_line_panel(panel, cell(grid, i));
  }
  return drawn;
}

std::string line_chart_svg(const LineChart& chart) {
  const Drawn heading = draw_heading({chart.title, chart.note, legend_of(chart), chart.width});
  const Drawn panels = draw_line_panels(chart, heading.bottom);
  return figure_svg(chart.title, heading.svg + panels.svg, {panels.bottom, chart.width});
}

}  // namespace coapt
