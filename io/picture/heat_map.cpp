#include "io/picture/heat_map.h"

#include <algorithm>
#include <cmath>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kBlockGap = 5.0, kRowTicks = 34.0, kAbove = 40.0, kBelow = 22.0;

std::string shade_of(const HeatScale& scale, double value) {
  if (scale.limits.empty())
    return shade_class(scale.high > scale.low ? (value - scale.low) / (scale.high - scale.low)
                                              : 0.0);
  const auto above = std::upper_bound(scale.limits.begin(), scale.limits.end(), value);
  return shade_class((static_cast<double>(above - scale.limits.begin()) + 0.5) / kShades);
}

struct Place {
  double left, top, width, height;
};

std::string draw_cell(const Place& at, double value, const HeatScale& scale) {
  const std::string size = "\" x=\"" + fixed(at.left + 0.5, 1) + "\" y=\"" +
                           fixed(at.top + 0.5, 1) + "\" width=\"" + fixed(at.width - 1.0, 1) +
                           "\" height=\"" + fixed(at.height - 1.0, 1) + "\"/>\n";
  if (!std::isfinite(value)) return "<rect class=\"empty grid\" fill=\"none" + size;
  const std::string shade = shade_of(scale, value);
  const std::string cell = "<rect class=\"cell solid " + shade + size;
  if (scale.decimals < 0) return cell;
  return cell + text_at(at.left + 0.5 * at.width, at.top + 0.5 * at.height + 3.5,
                        "text-anchor=\"middle\" class=\"small on" + shade.substr(1) + "\"",
                        fixed(value, scale.decimals));
}

}  // namespace

std::string draw_heat_map(const HeatMap& map, const HeatScale& scale, const PlotBox& box) {
  const auto blocks = static_cast<double>(std::max<std::size_t>(1, map.blocks.size()));
  const auto columns = static_cast<double>(std::max<std::size_t>(1, map.column_ticks.size()));
  const auto rows = static_cast<double>(std::max<std::size_t>(1, map.row_ticks.size()));
  const double left = box.left + kRowTicks, top = box.top + kAbove;
  const double width = (box.right - left - kBlockGap * (blocks - 1.0)) / (blocks * columns);
  const double height = (box.bottom - kBelow - top) / rows;
  std::string svg = text_at(left, box.top + 14.0, "class=\"head\"", map.title);
  const auto row_top = [&](std::size_t row) {
    return top + (rows - 1.0 - static_cast<double>(row)) * height;
  };
  for (std::size_t row = 0; row < map.row_ticks.size(); ++row)
    svg += text_at(left - 6.0, row_top(row) + 0.5 * height + 4.0,
                   "text-anchor=\"end\" class=\"tick\"", map.row_ticks[row]);
  const double label_x = left - 24.0, label_y = 0.5 * (top + box.bottom - kBelow);
  svg += text_at(label_x, label_y,
                 "text-anchor=\"middle\" class=\"small\" transform=\"rotate(-90 " +
                     fixed(label_x, 1) + " " + fixed(label_y, 1) + ")\"",
                 map.row_label);
  for (std::size_t block = 0; block < map.values.size() && block < map.blocks.size(); ++block) {
    const double start = left + static_cast<double>(block) * (columns * width + kBlockGap);
    svg += text_at(start + 0.5 * columns * width, top - 6.0,
                   "text-anchor=\"middle\" class=\"small\"", map.blocks[block]);
    for (std::size_t c = 0; c < map.column_ticks.size(); ++c)
      svg += text_at(start + (static_cast<double>(c) + 0.5) * width, box.bottom - kBelow + 14.0,
                     "text-anchor=\"middle\" class=\"tick\"", map.column_ticks[c]);
    for (std::size_t row = 0; row < map.values[block].size(); ++row)
      for (std::size_t c = 0; c < map.values[block][row].size(); ++c)
        svg += draw_cell({start + static_cast<double>(c) * width, row_top(row), width, height},
                         map.values[block][row][c], scale);
    if (map.framed) {
      const auto& [row, c] = *map.framed;
      svg += "<rect class=\"hollow\" x=\"" + fixed(start + static_cast<double>(c) * width, 1) +
             "\" y=\"" + fixed(row_top(row), 1) + "\" width=\"" + fixed(width, 1) + "\" height=\"" +
             fixed(height, 1) + "\"/>\n";
    }
  }
  return svg;
}

std::string draw_scale(const HeatScale& scale, const std::string& label, double x, double y) {
  constexpr double kStep = 22.0, kThick = 10.0;
  std::string svg;
  for (int i = 0; i < kShades; ++i)
    svg += "<rect class=\"solid h" + std::to_string(i) + "\" x=\"" + fixed(x + i * kStep, 1) +
           "\" y=\"" + fixed(y, 1) + "\" width=\"" + fixed(kStep, 1) + "\" height=\"" +
           fixed(kThick, 1) + "\"/>\n";
  const auto tick = [&](double border, double value) {
    const bool round = std::abs(value - std::round(value)) < 1e-9;
    return text_at(x + border * kStep, y + kThick + 13.0, "text-anchor=\"middle\" class=\"tick\"",
                   fixed(value, round ? 0 : 1));
  };
  for (std::size_t i = 0; i < scale.limits.size(); ++i)
    svg += tick(static_cast<double>(i + 1), scale.limits[i]);
  if (scale.limits.empty())
    for (int i = 0; i <= kShades; i += kShades / 2)
      svg += tick(i, scale.low + (scale.high - scale.low) * i / kShades);
  return svg + text_at(x + kShades * kStep + 14.0, y + kThick, "class=\"note\"", label);
}

}  // namespace coapt
