// Charts over displaced papillary muscles (study_charts.h).
#include "io/picture/displacement_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/picture/heat_map.h"
#include "io/picture/line_chart.h"
#include "io/picture/oblique_plot.h"
#include "io/picture/study_charts.h"
#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kLevelStep_mm = 2.0;     // between surfaces, and between arrows along each axis
constexpr double kLongestArrow_mm = 1.8;  // in the cube's scale; they do not touch the next node

bool complete(const DisplacementGrid& grid) {
  return grid.nodes > 0 &&
         grid.area_mm2.size() == static_cast<std::size_t>(grid.nodes * grid.nodes * grid.nodes);
}

/// Every how many nodes there is a level.
int stride(const DisplacementGrid& grid) {
  return std::max(1, static_cast<int>(std::lround(kLevelStep_mm / grid.step_mm)));
}

double most_mm(const DisplacementGrid& grid) { return grid.step_mm * (grid.nodes - 1); }

Axis displacement_axis(double high_mm) { return {0.0, std::max(1.0, high_mm), kLevelStep_mm, 0}; }

std::string level_words(const DisplacementGrid& grid, int apical) {
  return fixed(apical * grid.step_mm, 0) + " mm";
}

std::string level_class(const DisplacementGrid& grid, int apical) {
  return shade_class((apical + 0.5 * stride(grid)) / (grid.nodes - 1 + stride(grid)));
}

/// Table 4.1 in words.
std::string largest_words(const DisplacementGrid& grid) {
  const std::array<double, 7> largest = largest_orifices(grid);
  return "largest: transverse alone " + fixed(largest[0], 1) + ", posterior alone " +
         fixed(largest[1], 1) + ", apical alone " + fixed(largest[2], 1) + ", all " +
         fixed(largest[6], 1) + " mm²";
}

std::string draw_orifice(const DisplacementGrid& grid, const PlotBox& area) {
  Extent range{0.0, 0.0};
  for (const double value : grid.area_mm2) range = including(range, value);
  const ObliqueBox box{
      {displacement_axis(most_mm(grid)), displacement_axis(most_mm(grid)), round_axis(range)},
      1.15,
      area};
  std::vector<Surface> surfaces;
  for (int apical = 0; apical < grid.nodes; apical += stride(grid)) {
    Surface surface{level_class(grid, apical), {}, {}, {}};
    for (int i = 0; i < grid.nodes; ++i) {
      surface.x.push_back(i * grid.step_mm);
      surface.y.push_back(i * grid.step_mm);
      surface.z.emplace_back();
      for (int j = 0; j < grid.nodes; ++j) surface.z.back().push_back(grid.at(i, j, apical));
    }
    surfaces.push_back(surface);
  }
  return draw_box(box, {"transverse, mm", "posterior, mm", "orifice, mm²"}) +
         draw_surfaces(box, surfaces) +
         text_at(area.left - 28.0, area.bottom + 44.0, "class=\"note\"", largest_words(grid));
}

/// Rounded up.
double two_figures(double value) {
  if (!(value > 0.0)) return 1.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return unit * std::ceil(value / unit - 1e-9);
}

/// "mean slope: transverse 1.2, posterior 0.3, apical 6.5 mm² per mm"
std::string slope_words(const std::vector<Vec3>& gradient) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const Vec3& slope : gradient)
    if (slope.allFinite()) sum += slope, count += 1.0;
  if (count == 0.0) return "";
  sum /= count;
  return "mean slope: transverse " + fixed(sum.x(), 1) + ", posterior " + fixed(sum.y(), 1) +
         ", apical " + fixed(sum.z(), 1) + " mm² per mm";
}

std::string draw_gradient(const DisplacementGrid& grid, const PlotBox& area) {
  const std::vector<Vec3> gradient = gradients(grid);
  double most = 0.0;
  for (const Vec3& slope : gradient)
    if (slope.allFinite()) most = std::max(most, slope.norm());
  const double scale = two_figures(most);
  const Axis axis = displacement_axis(most_mm(grid) + kLongestArrow_mm);
  const ObliqueBox box{{axis, axis, axis}, 1.0, area};
  std::vector<Arrow> arrows;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const Vec3 from = grid.displacement_mm(i);
    const Vec3 level = from / (grid.step_mm * stride(grid));
    if (!(level - level.array().round().matrix()).isZero(1e-6) || !(most > 0.0)) continue;
    arrows.push_back({from, kLongestArrow_mm / most * gradient[i], gradient[i].norm() / scale});
  }
  return draw_box(box, {"transverse, mm", "posterior, mm", "apical, mm"}) +
         draw_arrows(box, arrows) +
         draw_scale({0.0, scale, 0}, "mm² per mm", area.left + 20.0, area.bottom + 52.0) +
         text_at(area.left + 20.0, area.bottom + 44.0, "class=\"note\"", slope_words(gradient));
}

/// Median of the finite ones with their range, in percent; NaN if there are none.
void add_ratios(PanelSeries& series, double x, std::vector<double> ratios) {
  std::erase_if(ratios, [](double ratio) { return !std::isfinite(ratio); });
  if (ratios.empty()) return;
  std::sort(ratios.begin(), ratios.end());
  series.x.push_back(x);
  series.y.push_back(50.0 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]));
  series.low.push_back(100.0 * ratios.front());
  series.high.push_back(100.0 * ratios.back());
}

LinePanel ratio_panel(const RingStudy& study, Displaced displaced) {
  constexpr std::array<Hue, 3> kHues = {Hue::Sky, Hue::Blue, Hue::Purple};
  const std::size_t k = static_cast<std::size_t>(displaced);
  LinePanel panel{{class_title(displaced), "apical displacement, mm", "share of the orifice, %"},
                  {}};
  panel.x_axis = Axis{-0.5, most_mm(study.grids[k][0]) + 0.5, kLevelStep_mm, 0};
  for (int sizes = 1; sizes <= 3; ++sizes) {
    const DisplacementGrid& grid = study.grids[k][static_cast<std::size_t>(sizes)];
    PanelSeries series{
        "U" + std::to_string(sizes), {}, {}, kHues[static_cast<std::size_t>(sizes - 1)]};
    series.shift_px = 5.0 * (sizes - 2);
    if (complete(grid) && complete(study.grids[k][0])) {
      const std::vector<double> ratios = ring_ratios(study, displaced, sizes);
      for (int apical = 0; apical < grid.nodes; ++apical) {
        std::vector<double> level;
        for (std::size_t i = static_cast<std::size_t>(apical); i < ratios.size();
             i += static_cast<std::size_t>(grid.nodes))
          level.push_back(ratios[i]);
        add_ratios(series, apical * grid.step_mm, level);
      }
    }
    panel.series.push_back(series);
  }
  return panel;
}

HeatMap ratio_map(const RingStudy& study, Displaced displaced, int sizes) {
  const std::size_t k = static_cast<std::size_t>(displaced);
  const DisplacementGrid& grid = study.grids[k][static_cast<std::size_t>(sizes)];
  HeatMap map{std::string(to_string(displaced)) + ", U" + std::to_string(sizes),
              "posterior, mm",
              {},
              {},
              {},
              {}};
  if (!complete(grid) || !complete(study.grids[k][0])) return map;
  const double largest = largest_ring_ratio(study, displaced, sizes);
  if (std::isfinite(largest)) map.title += ": largest " + fixed(100.0 * largest, 0) + " %";
  const std::vector<double> ratios = ring_ratios(study, displaced, sizes);
  const auto nodes = static_cast<std::size_t>(grid.nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::string words = fixed(static_cast<double>(i) * grid.step_mm, 0);
    map.row_ticks.push_back(words);
    map.column_ticks.push_back(words);
    map.blocks.push_back((i == 0 ? "apical " : "") + words + " mm");
    map.values.emplace_back(nodes, std::vector<double>(nodes));
  }
  for (std::size_t i = 0; i < ratios.size(); ++i)
    map.values[i % nodes][i / nodes % nodes][i / (nodes * nodes)] = 100.0 * ratios[i];
  return map;
}

}  // namespace

std::string papillary_svg(const PapillaryStudy& study) {
  constexpr double kRow = 460.0;
  Heading heading{
      "Orifice when papillary muscles are displaced",
      "Thesis, figures 4.6 to 4.8. Left: orifice over transverse (outwards) and posterior "
      "displacement, a surface for each apical displacement; the scales differ. Right: gradient of "
      "the orifice.",
      {}};
  const DisplacementGrid& first = study.grids.front();
  for (int apical = 0; apical < first.nodes && complete(first); apical += stride(first))
    heading.legend.push_back(
        {"apical " + level_words(first, apical), level_class(first, apical), Mark::Area});
  Drawn drawn = draw_heading(heading);
  const CellGrid cells{6, 2, drawn.bottom, kRow};
  for (std::size_t k = 0; k < study.grids.size(); ++k) {
    const PlotBox left = cell(cells, 2 * static_cast<int>(k));
    const PlotBox right = cell(cells, 2 * static_cast<int>(k) + 1);
    drawn.svg +=
        text_at(left.left + 12.0, left.top + 20.0, "class=\"head\"", class_title(kDisplaced[k]));
    if (!complete(study.grids[k])) continue;
    const auto plot = [](const PlotBox& box) {
      return PlotBox{box.left + 40.0, box.top + 50.0, box.right - 30.0, box.bottom - 84.0};
    };
    drawn.svg += draw_orifice(study.grids[k], plot(left));
    drawn.svg += draw_gradient(study.grids[k], plot(right));
  }
  return figure_svg(heading.title, drawn.svg, {bottom_of(cells)});
}

std::string ring_svg(const RingStudy& study) {
  LineChart lines;
  lines.title = "Effect of an undersized ring on the orifice";
  lines.note =
      "Thesis, figure 4.9. Orifice under a ring one to three sizes below the annulus, in percent "
      "of "
      "that under the properly sized one at the same displacement, where that is 1 mm² or more. "
      "Above: median and range over transverse and posterior displacements. Below: each "
      "displacement, in a block transverse ones to the right and posterior ones upwards.";
  lines.same_y = true;
  Extent range{0.0, 100.0};
  for (const Displaced displaced : kDisplaced) {
    lines.panels.push_back(ratio_panel(study, displaced));
    for (const PanelSeries& series : lines.panels.back().series)
      for (const double value : series.high) range = including(range, value);
  }
  Drawn drawn = draw_heading({lines.title, lines.note, legend_of(lines)});
  const Drawn panels = draw_line_panels(lines, drawn.bottom);
  const HeatScale scale{0.0, std::ceil(range.high / 20.0) * 20.0, 0};
  drawn.svg += panels.svg + draw_scale(scale, "% of the orifice under the properly sized annulus",
                                       34.0, panels.bottom + 4.0);
  const CellGrid cells{9, 3, panels.bottom + 44.0, 150.0};
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    for (int sizes = 1; sizes <= 3; ++sizes) {
      const PlotBox box = cell(cells, 3 * static_cast<int>(k) + sizes - 1);
      drawn.svg += draw_heat_map(ratio_map(study, kDisplaced[k], sizes), scale,
                                 {box.left + 2.0, box.top, box.right - 8.0, box.bottom - 8.0});
    }
  return figure_svg(lines.title, drawn.svg, {bottom_of(cells)});
}

}  // namespace coapt
