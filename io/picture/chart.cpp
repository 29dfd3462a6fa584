// One line panel, narrower than a figure of several; its x axis may be of decades.
#include "io/picture/chart.h"

#include <array>
#include <cmath>

#include "io/picture/line_chart.h"

namespace coapt {
namespace {

constexpr double kChartWidth = 760.0, kChartHeight = 330.0;
constexpr std::array kSeriesHues = {Hue::Blue,   Hue::Vermillion, Hue::Green,
                                    Hue::Purple, Hue::Orange,     Hue::Ink};

Mark mark_of(const Series& series) {
  if (!series.line) return Mark::Dot;
  return series.dashed ? Mark::Dashed : Mark::Line;
}

LinePanel panel_of(const Chart& chart) {
  LinePanel panel;
  panel.words = {"", chart.x_label, chart.y_label};
  Extent decades;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    PanelSeries& drawn = panel.series.emplace_back();
    if (chart.series.size() > 1) drawn.label = series.label;
    drawn.x = series.x;
    drawn.y = series.y;
    drawn.hue = kSeriesHues[i % kSeriesHues.size()];
    drawn.mark = mark_of(series);
    if (!chart.log_x) continue;
    for (double& x : drawn.x) decades = including(decades, x = std::log10(x));
  }
  if (chart.log_x) panel.x_axis = decade_axis(decades);
  return panel;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  LineChart figure;
  figure.title = chart.title;
  figure.panels = {panel_of(chart)};
  figure.columns = 1;
  figure.panel_height = kChartHeight;
  figure.width = kChartWidth;
  return line_chart_svg(figure);
}

}  // namespace coapt
