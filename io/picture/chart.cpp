// A line chart as hand-written SVG: no library, the same bytes everywhere, and colours that follow
// the page's light or dark scheme.
#include <algorithm>
#include <array>
#include <cmath>

#include "io/picture/chart_frame.h"
#include "io/picture/picture.h"
#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kChartWidth = 760.0, kChartHeight = 400.0;
constexpr double kLeft = 72.0, kRight = 20.0, kChartTop = 74.0, kBottom = 60.0;
constexpr std::size_t kMarkersUpTo = 40;  // points of a series; more would run together
constexpr std::array<const char*, 6> kColours = {"#3b78d8", "#d9622b", "#17977a",
                                                 "#9060d8", "#b98a1d", "#7a8794"};

Axis axis_of(const Chart& chart, std::vector<double> Series::*values) {
  Extent range;
  for (const Series& series : chart.series)
    for (const double value : series.*values) range = including(range, value);
  return round_axis(range);
}

/// Whole decades that hold every finite value, which are logarithms already.
Axis decades_of(const Chart& chart) {
  const Axis tight = axis_of(chart, &Series::x);
  return {std::floor(tight.low), std::max(std::ceil(tight.high), std::floor(tight.low) + 1.0), 1.0,
          0};
}

double to_x(const Axis& axis, double value) {
  return kLeft + (value - axis.low) / (axis.high - axis.low) * (kChartWidth - kLeft - kRight);
}

double to_y(const Axis& axis, double value) {
  return kChartHeight - kBottom -
         (value - axis.low) / (axis.high - axis.low) * (kChartHeight - kChartTop - kBottom);
}

std::string draw_axes(const Chart& chart, const Axis& x_axis, const Axis& y_axis) {
  const double bottom = kChartHeight - kBottom, right = kChartWidth - kRight;
  std::string svg;
  const auto ticks = [](const Axis& axis) {
    return static_cast<int>(std::lround((axis.high - axis.low) / axis.step));
  };
  for (int i = 0; i <= ticks(y_axis); ++i) {
    const double value = y_axis.low + i * y_axis.step, y = to_y(y_axis, value);
    svg += line_at("grid", kLeft, y, right, y);
    svg += text_at(kLeft - 10.0, y + 4.0, "class=\"tick\" text-anchor=\"end\"",
                   fixed(value, y_axis.decimals));
  }
  for (int i = 0; i <= ticks(x_axis); ++i) {
    const double value = x_axis.low + i * x_axis.step, x = to_x(x_axis, value);
    svg += line_at("axis", x, bottom, x, bottom + 5.0);
    const std::string label =
        chart.log_x ? fixed(std::pow(10.0, value), std::max(0, -static_cast<int>(value)))
                    : fixed(value, x_axis.decimals);
    svg += text_at(x, bottom + 20.0, "class=\"tick\" text-anchor=\"middle\"", label);
  }
  svg += line_at("axis", kLeft, bottom, right, bottom);
  svg +=
      text_at(0.5 * (kLeft + right), kChartHeight - 14.0, "text-anchor=\"middle\"", chart.x_label);
  const double middle = 0.5 * (kChartTop + bottom);
  svg += text_at(18.0, middle,
                 "text-anchor=\"middle\" transform=\"rotate(-90 18 " + fixed(middle, 1) + ")\"",
                 chart.y_label);
  return svg;
}

Mark mark_of(const Series& series) { return series.dashed ? Mark::Dashed : Mark::Line; }

std::string draw_series(const Series& series, const std::string& colour, const Axis& x_axis,
                        const Axis& y_axis) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  std::string path, markers;
  bool pen_down = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      pen_down = false;
      continue;
    }
    const std::string x = fixed(to_x(x_axis, series.x[i]), 2);
    const std::string y = fixed(to_y(y_axis, series.y[i]), 2);
    path += (pen_down ? "L" : "M") + x + " " + y;
    pen_down = true;
    if (count <= kMarkersUpTo || !series.line)
      markers += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3.2\" fill=\"" + colour + "\"/>\n";
  }
  if (!series.line) return markers;
  return "<path class=\"" + line_class(mark_of(series)) + "\" stroke=\"" + colour + "\" d=\"" +
         path + "\"/>\n" + markers;
}

/// Below the title, from the left; each entry takes the room of its text.
std::string draw_legend(const Chart& chart) {
  constexpr double kLegendCharacter = 7.0;  // mean advance of the 13 px text
  constexpr double kLegendLine = 18.0;
  std::string svg;
  double x = kLeft, y = 40.0;
  for (std::size_t i = 0; i < chart.series.size() && chart.series.size() > 1; ++i) {
    const std::string& label = chart.series[i].label;
    const double width = 26.0 + kLegendCharacter * static_cast<double>(label.size());
    if (x > kLeft && x + width > kChartWidth - kRight) x = kLeft, y += kLegendLine;
    svg += "<line class=\"" + line_class(mark_of(chart.series[i])) + "\" stroke=\"" +
           std::string(kColours[i % kColours.size()]) + "\" x1=\"" + fixed(x, 1) + "\" y1=\"" +
           fixed(y, 1) + "\" x2=\"" + fixed(x + 20.0, 1) + "\" y2=\"" + fixed(y, 1) + "\"/>\n";
    svg += text_at(x + 26.0, y + 4.0, "class=\"tick\"", label);
    x += width + 24.0;
  }
  return svg;
}

}  // namespace

std::string chart_svg(const Chart& given) {
  Chart chart = given;
  if (chart.log_x)
    for (Series& series : chart.series)
      for (double& x : series.x) x = std::log10(x);
  const Axis x_axis = chart.log_x ? decades_of(chart) : axis_of(chart, &Series::x);
  const Axis y_axis = axis_of(chart, &Series::y);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"coapt-chart\" viewBox=\"0 0 " +
      fixed(kChartWidth, 0) + " " + fixed(kChartHeight, 0) + "\" role=\"img\" aria-label=\"" +
      escape_html(chart.title) + "\">\n";
  svg +=
      "<style>\n"
      ".coapt-chart{color:#26313d;font:13px system-ui,\"Segoe UI\",\"DejaVu Sans\",sans-serif}\n"
      "@media screen and (prefers-color-scheme:dark){.coapt-chart{color:#d8dee6}}\n"
      ".coapt-chart text{fill:currentColor}.coapt-chart .title{font-size:16px;font-weight:600}\n"
      ".coapt-chart .tick{opacity:.75}.coapt-chart .grid{stroke:currentColor;opacity:.14}\n"
      ".coapt-chart .axis{stroke:currentColor;opacity:.55}\n"
      ".coapt-chart .line{fill:none;stroke-width:2.2;stroke-linejoin:round;stroke-linecap:round}\n"
      ".coapt-chart .dashed{stroke-dasharray:7 5;stroke-linecap:butt}\n"
      "</style>\n";
  svg += text_at(kLeft, 22.0, "class=\"title\"", chart.title);
  svg += draw_legend(chart);
  svg += draw_axes(chart, x_axis, y_axis);
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    svg += draw_series(chart.series[i], kColours[i % kColours.size()], x_axis, y_axis);
  return svg + "</svg>\n";
}

}  // namespace coapt
