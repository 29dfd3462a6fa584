#include "io/picture/chart_frame.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kCharacter = 6.6;         // mean advance of the 12.5 px text
constexpr double kCharactersPerPx = 0.15;  // of a wrapped note

// Inline figures of one page share their style sheets: every figure has this same one.
constexpr const char* kStyle =
    "<style>\n"
    ".coapt-panels{color:#26313d;font:12.5px system-ui,\"Segoe UI\",\"DejaVu Sans\",sans-serif}\n"
    ".coapt-panels text{fill:currentColor}\n"
    ".coapt-panels .title{font-size:17px;font-weight:600}.coapt-panels .note{opacity:.78}\n"
    ".coapt-panels .head{font-size:13.5px;font-weight:600}\n"
    ".coapt-panels .tick{opacity:.78;font-size:11px}.coapt-panels .small{font-size:10.5px}\n"
    ".coapt-panels .grid{stroke:currentColor;opacity:.14}\n"
    ".coapt-panels .axis{stroke:currentColor;opacity:.5}\n"
    ".coapt-panels .line{fill:none;stroke:currentColor;stroke-width:2.1;stroke-linejoin:round;"
    "stroke-linecap:round}\n"
    ".coapt-panels .dashed{stroke-dasharray:6 4;stroke-width:1.6;stroke-linecap:butt}\n"
    ".coapt-panels .long{stroke-dasharray:12 4;stroke-linecap:butt}\n"
    ".coapt-panels .dotted{stroke-dasharray:.1 5}\n"
    ".coapt-panels .dashdot{stroke-dasharray:9 4 1 4;stroke-linecap:butt}\n"
    ".coapt-panels .thin{stroke-width:1.1;opacity:.7}\n"
    ".coapt-panels .solid{fill:currentColor}\n"
    ".coapt-panels .hollow{fill:none;stroke:currentColor;stroke-width:1.8}\n"
    ".coapt-panels .area{fill:currentColor;fill-opacity:.26}\n"
    ".coapt-panels .face{fill:currentColor;fill-opacity:.34;stroke:currentColor;"
    "stroke-width:.9;stroke-linejoin:round}\n"
    ".coapt-panels .c-blue{color:#0072b2}.coapt-panels .c-vermillion{color:#d55e00}\n"
    ".coapt-panels .c-green{color:#009e73}.coapt-panels .c-purple{color:#c2619a}\n"
    ".coapt-panels .c-sky{color:#3fa5e0}.coapt-panels .c-orange{color:#d28f00}\n"
    ".coapt-panels .h0{color:#86d549}.coapt-panels .h1{color:#44bf70}\n"
    ".coapt-panels .h2{color:#20a386}.coapt-panels .h3{color:#23808a}\n"
    ".coapt-panels .h4{color:#2f6b8e}.coapt-panels .h5{color:#3d4d8a}\n"
    ".coapt-panels .h6{color:#482979}.coapt-panels .h7{color:#440154}\n"
    ".coapt-panels .on0,.coapt-panels .on1,.coapt-panels .on2{color:#0b1016}\n"
    ".coapt-panels .on3,.coapt-panels .on4,.coapt-panels .on5,.coapt-panels .on6,"
    ".coapt-panels .on7{color:#fff}\n"
    "@media screen and (prefers-color-scheme:dark){\n"
    ".coapt-panels{color:#d8dee6}\n"
    ".coapt-panels .c-blue{color:#4c9be8}.coapt-panels .c-vermillion{color:#f0803c}\n"
    ".coapt-panels .c-green{color:#2cc295}.coapt-panels .c-purple{color:#dd92bd}\n"
    ".coapt-panels .c-sky{color:#8fd3ff}.coapt-panels .c-orange{color:#e9b23c}\n"
    ".coapt-panels .h0{color:#465f9f}.coapt-panels .h1{color:#33709a}\n"
    ".coapt-panels .h2{color:#23808a}.coapt-panels .h3{color:#1f9f88}\n"
    ".coapt-panels .h4{color:#3bbb75}.coapt-panels .h5{color:#77d153}\n"
    ".coapt-panels .h6{color:#bddf26}.coapt-panels .h7{color:#fde725}\n"
    ".coapt-panels .on0,.coapt-panels .on1,.coapt-panels .on2{color:#fff}\n"
    ".coapt-panels .on3,.coapt-panels .on4,.coapt-panels .on5,.coapt-panels .on6,"
    ".coapt-panels .on7{color:#0b1016}\n"
    "}\n</style>\n";

std::vector<std::string> wrapped(const std::string& text, std::size_t characters) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (lines.empty() || lines.back().size() + 1 + word.size() > characters)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  return lines;
}

std::string draw_key(const LegendEntry& entry, double x, double y) {
  const std::string middle = fixed(x + 11.0, 1), height = fixed(y, 1);
  switch (entry.mark) {
    case Mark::Line:
    case Mark::Dashed:
    case Mark::LongDashed:
    case Mark::Dotted:
    case Mark::DashDotted:
      return line_at((line_class(entry.mark) + " " + entry.colour).c_str(), x, y, x + 22.0, y);
    case Mark::Dot:
    case Mark::Hollow:
      return "<circle class=\"" +
             std::string(entry.mark == Mark::Dot ? "solid key " : "hollow key ") + entry.colour +
             "\" cx=\"" + middle + "\" cy=\"" + height + "\" r=\"4\"/>\n";
    case Mark::Area:
      return "<rect class=\"face " + entry.colour + "\" x=\"" + fixed(x + 3.0, 1) + "\" y=\"" +
             fixed(y - 6.0, 1) + "\" width=\"18\" height=\"12\"/>\n";
  }
  return "";
}

std::string tick_text(const Axis& axis, double tick) {
  if (axis.log) return fixed(std::pow(10.0, tick), std::max(0, -static_cast<int>(tick)));
  return fixed(tick, axis.decimals);
}

}  // namespace

std::string line_class(Mark mark) {
  switch (mark) {
    case Mark::Line:
      return "line";
    case Mark::Dashed:
      return "line dashed";
    case Mark::LongDashed:
      return "line long";
    case Mark::Dotted:
      return "line dotted";
    case Mark::DashDotted:
      return "line dashdot";
    case Mark::Dot:
    case Mark::Hollow:
    case Mark::Area:
      return "";
  }
  return "";
}

const char* css_class(Hue hue) {
  switch (hue) {
    case Hue::Ink:
      return "c-ink";
    case Hue::Blue:
      return "c-blue";
    case Hue::Vermillion:
      return "c-vermillion";
    case Hue::Green:
      return "c-green";
    case Hue::Purple:
      return "c-purple";
    case Hue::Sky:
      return "c-sky";
    case Hue::Orange:
      return "c-orange";
  }
  return "";
}

std::string shade_class(double share) {
  const double clamped = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  return "h" + std::to_string(std::min(kShades - 1, static_cast<int>(clamped * kShades)));
}

Extent including(Extent range, double value) {
  if (!std::isfinite(value)) return range;
  return {std::min(range.low, value), std::max(range.high, value)};
}

Axis round_axis(Extent range, int ticks) {
  if (!(range.low <= range.high)) return {};
  if (range.low >= 0.0 && range.low < 0.5 * range.high) range.low = 0.0;
  if (range.high - range.low < 1e-9 * std::max(1.0, std::abs(range.high))) {
    const double half = std::max(0.5, 1e-6 * std::abs(range.high));
    range.low == 0.0 ? range.high = 1.0 : (range.low -= half, range.high += half);
  }
  const double rough = (range.high - range.low) / ticks;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  Axis axis;
  axis.step = (share <= 1.0001   ? 1.0
               : share <= 2.0001 ? 2.0
               : share <= 5.0001 ? 5.0
                                 : 10.0) *
              power;
  axis.low = std::floor(range.low / axis.step + 1e-9) * axis.step;
  axis.high = std::ceil(range.high / axis.step - 1e-9) * axis.step;
  axis.decimals = std::clamp(static_cast<int>(-std::floor(std::log10(axis.step) + 1e-9)), 0, 12);
  return axis;
}

Axis decade_axis(Extent range) {
  if (!(range.low <= range.high)) return {0.0, 1.0, 1.0, 0, true};
  const double low = std::floor(range.low);
  return {low, std::max(std::ceil(range.high), low + 1.0), 1.0, 0, true};
}

std::vector<double> ticks_of(const Axis& axis) {
  std::vector<double> ticks;
  const double first = std::ceil(axis.low / axis.step - 1e-6);
  const double last = std::floor(axis.high / axis.step + 1e-6);
  for (double i = first; i <= last; i += 1.0) ticks.push_back(i * axis.step);
  return ticks;
}

double x_at(const Frame& frame, double value) {
  return frame.plot.left + (value - frame.x.low) / (frame.x.high - frame.x.low) *
                               (frame.plot.right - frame.plot.left);
}

double y_at(const Frame& frame, double value) {
  return frame.plot.bottom - (value - frame.y.low) / (frame.y.high - frame.y.low) *
                                 (frame.plot.bottom - frame.plot.top);
}

std::string draw_frame(const Frame& frame, const FrameWords& words) {
  const PlotBox& plot = frame.plot;
  std::string svg = text_at(plot.left, plot.top - 12.0, "class=\"head\"", words.title);
  for (const double tick : ticks_of(frame.y)) {
    const double y = y_at(frame, tick);
    svg += line_at("grid", plot.left, y, plot.right, y);
    svg += text_at(plot.left - 7.0, y + 4.0, "class=\"tick\" text-anchor=\"end\"",
                   tick_text(frame.y, tick));
  }
  for (const double tick : ticks_of(frame.x)) {
    const double x = x_at(frame, tick);
    svg += line_at("axis", x, plot.bottom, x, plot.bottom + 4.0);
    svg += text_at(x, plot.bottom + 17.0, "class=\"tick\" text-anchor=\"middle\"",
                   tick_text(frame.x, tick));
  }
  svg += line_at("axis", plot.left, plot.bottom, plot.right, plot.bottom);
  svg += text_at(0.5 * (plot.left + plot.right), plot.bottom + 35.0, "text-anchor=\"middle\"",
                 words.x_label);
  const double x = plot.left - 40.0, y = 0.5 * (plot.top + plot.bottom);
  return svg + text_at(x, y,
                       "text-anchor=\"middle\" transform=\"rotate(-90 " + fixed(x, 1) + " " +
                           fixed(y, 1) + ")\"",
                       words.y_label);
}

std::string draw_keys(const std::vector<LegendEntry>& entries, double x, double y) {
  std::string svg;
  for (const LegendEntry& entry : entries) {
    svg += draw_key(entry, x, y - 4.0) + text_at(x + 28.0, y, "class=\"legend\"", entry.label);
    y += 17.0;
  }
  return svg;
}

Drawn draw_heading(const Heading& heading) {
  Drawn drawn{text_at(12.0, 26.0, "class=\"title\"", heading.title), 30.0};
  for (const std::string& line :
       wrapped(heading.note, static_cast<std::size_t>(kCharactersPerPx * heading.width)))
    drawn.svg += text_at(12.0, drawn.bottom += 17.0, "class=\"note\"", line);
  if (heading.legend.empty()) return {drawn.svg, drawn.bottom + 10.0};
  double x = 12.0, y = drawn.bottom + 22.0;
  for (const LegendEntry& entry : heading.legend) {
    const double width = 28.0 + kCharacter * static_cast<double>(entry.label.size());
    if (x > 12.0 && x + width > heading.width) x = 12.0, y += 19.0;
    drawn.svg += draw_key(entry, x, y - 4.0);
    drawn.svg += text_at(x + 28.0, y, "class=\"legend\"", entry.label);
    x += width + 20.0;
  }
  return {drawn.svg, y + 12.0};
}

PlotBox cell(const CellGrid& grid, int index) {
  const double width = grid.width / grid.columns;
  const double left = index % grid.columns * width;
  const double top = grid.top + index / grid.columns * grid.height;
  return {left, top, left + width, top + grid.height};
}

double bottom_of(const CellGrid& grid) {
  return grid.top + (grid.count + grid.columns - 1) / grid.columns * grid.height;
}

std::string figure_svg(const std::string& title, const std::string& content, FigureSize size) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"coapt-panels\" viewBox=\"0 0 " +
         fixed(size.width, 0) + " " + fixed(size.height, 0) + "\" role=\"img\" aria-label=\"" +
         escape_html(title) + "\">\n" + kStyle + content + "</svg>\n";
}

}  // namespace coapt
