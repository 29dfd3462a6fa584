#include "io/picture/evidence_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <variant>

#include "core/closed/diagnosis.h"
#include "core/repair/plan.h"
#include "core/valve/valve.h"
#include "io/picture/heat_map.h"
#include "io/picture/line_chart.h"
#include "io/picture/svg.h"
#include "io/picture/text.h"
#include "search/plans/disturbance.h"
#include "search/plans/objective.h"

namespace coapt {
namespace {

constexpr double kScaleHeight = 46.0;  // px

/// Maps whose cells hold numbers that can be read on paper stand in two columns.
struct Layout {
  double map_height, line_height;  ///< px
  int map_columns;
  bool cell_values;
};
constexpr Layout kFull = {300.0, 235.0, 2, true}, kBrief = {225.0, 225.0, 3, false};
constexpr int kLineColumns = 3;
// The same for all plans and on the page (clients/web/src/search/evidence.ts): none or trace below
// 1, mild below 5.
constexpr std::array<double, kShades - 1> kLeakLimits_mm2 = {0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0};
constexpr double kLengthStep_mm = 0.25;

using Panel = std::function<std::string(const PlotBox&)>;

bool any_finite(const std::vector<std::vector<double>>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const std::vector<double>& row) {
    return std::any_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
  });
}

std::string title_of(const LeakMap& map) {
  return map.muscle == "both" ? "Leak, mm²: both muscles, same error"
                              : "Leak, mm²: " + map.muscle + " alone";
}

HeatScale scale_of(const LeakMap& map, const Layout& layout) {
  if (!layout.cell_values) return {0.0, kLeakLimits_mm2.back(), -1, kLeakLimits_mm2};
  double most = 0.0;
  for (const std::vector<double>& row : map.leak_mm2)
    for (const double value : row) most = std::max(most, std::isfinite(value) ? value : 0.0);
  return {0.0, kLeakLimits_mm2.back(), most < 99.5 ? 1 : 0, kLeakLimits_mm2};
}

bool has_suture(const RepairPlan& plan, Side side) {
  return std::any_of(plan.steps.begin(), plan.steps.end(), [side](const RepairStep& step) {
    const auto* suture = std::get_if<PapillaryApproximation>(&step);
    return suture != nullptr && suture->side == side;
  });
}

/// What errors of length are of: a suture, or without one the distance that holds the muscle.
/// @param muscle as in LeakMap
std::string length_words(const RepairPlan& plan, const std::string& muscle) {
  const bool al = has_suture(plan, Side::Anterolateral);
  const bool pm = has_suture(plan, Side::Posteromedial);
  const bool both = muscle == "both";
  const bool one = muscle == to_string(Side::Anterolateral) ? al : pm;
  if (both ? al && pm : one) return "suture";
  return both && (al || pm) ? "suture or tip to trigone" : "tip to trigone";
}

Panel map_panel(const LeakMap& map, const RepairPlan& plan, const Layout& layout) {
  return [&map, &plan, &layout](const PlotBox& box) {
    HeatMap heat{title_of(map), "", {}, {}, {""}, {map.leak_mm2}};
    for (int l = 0; l < kRegionLengths; ++l)
      heat.row_ticks.push_back(l % 2 == 0 ? fixed(kLengthStep_mm * (l - kRegionLengths / 2), 1)
                                          : "");
    for (int a = 0; a < kRegionAngles; ++a)
      heat.column_ticks.push_back(std::to_string(a - kRegionAngles / 2));
    heat.framed = {kRegionLengths / 2, kRegionAngles / 2};
    const PlotBox within{box.left + 26.0, box.top, box.right - 16.0, box.bottom - 30.0};
    const std::string x = fixed(box.left + 20.0, 1), y = fixed(0.5 * (box.top + box.bottom), 1);
    return draw_heat_map(heat, scale_of(map, layout), within) +
           text_at(0.5 * (within.left + 34.0 + within.right), box.bottom - 16.0,
                   "text-anchor=\"middle\"", "angle outwards, degrees") +
           text_at(box.left + 20.0, 0.5 * (box.top + box.bottom),
                   "text-anchor=\"middle\" transform=\"rotate(-90 " + x + " " + y + ")\"",
                   length_words(plan, map.muscle) + " longer by, mm");
  };
}

std::string draw_with_keys(const LinePanel& panel, const PlotBox& box) {
  std::vector<LegendEntry> keys;
  for (const PanelSeries& series : panel.series)
    if (!series.label.empty()) keys.push_back({series.label, css_class(series.hue), series.mark});
  return draw_line_panel(panel, box) + draw_keys(keys, box.left + 70.0, box.top + 46.0);
}

Panel remodelling_panel(const std::vector<RemodellingCurve>& curves) {
  return [&curves](const PlotBox& box) {
    constexpr std::array kHues = {Hue::Blue, Hue::Green, Hue::Orange, Hue::Vermillion};
    constexpr std::array kMarks = {Mark::Line, Mark::LongDashed, Mark::Dotted, Mark::DashDotted};
    LinePanel panel{{"With further remodelling", "further tip displacement, mm", "leak, mm²"}, {}};
    double farthest = 0.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      PanelSeries series{curves[i].direction,
                         {},
                         curves[i].leak_mm2,
                         kHues[i % kHues.size()],
                         kMarks[i % kMarks.size()]};
      for (std::size_t mm = 0; mm < series.y.size(); ++mm)
        series.x.push_back(static_cast<double>(mm));
      farthest = std::max(farthest, static_cast<double>(series.y.size()) - 1.0);
      panel.series.push_back(std::move(series));
    }
    panel.series.push_back({"limit of an acceptable repair",
                            {0.0, farthest},
                            {kMildLeak_mm2, kMildLeak_mm2},
                            Hue::Ink,
                            Mark::Dashed});
    panel.y_holds = {0.0, 2.0 * kMildLeak_mm2};
    return draw_with_keys(panel, box);
  };
}

PanelSeries profile(const std::string& label, const ValveMeasure& measure, Hue hue, Mark mark) {
  PanelSeries series{label, {}, {}, hue, mark};
  for (const CoaptationSection& section : measure.coaptation.sections) {
    series.x.push_back(section.along);
    series.y.push_back(section.height_mm);
  }
  return series;
}

Panel coaptation_panel(const ValveMeasure& before, const ValveMeasure& after) {
  return [&before, &after](const PlotBox& box) {
    LinePanel panel{
        {"Coaptation in nine sections", "anterolateral to posteromedial commissure", "height, mm"},
        {profile("after", after, Hue::Blue, Mark::Line),
         profile("before", before, Hue::Ink, Mark::Dashed)}};
    panel.x_axis = Axis{0.0, 1.0, 0.25, 2};
    Extent heights{0.0, 1.0};
    for (const PanelSeries& series : panel.series)
      for (const double height : series.y) heights = including(heights, height);
    panel.y_holds = {0.0, 1.35 * heights.high};  // room for the keys
    return draw_with_keys(panel, box);
  };
}

std::string bar(const char* style, double x, double y, double width, double height) {
  return "<rect class=\"" + std::string(style) + " c-blue\" x=\"" + fixed(x, 1) + "\" y=\"" +
         fixed(y, 1) + "\" width=\"" + fixed(std::max(0.0, width), 1) + "\" height=\"" +
         fixed(height, 1) + "\"/>\n";
}

Panel indices_panel(const RegionIndices& indices, const RepairPlan& plan) {
  return [&indices, &plan](const PlotBox& box) {
    const std::array<std::string, 3> axes = {"length: " + length_words(plan, "both"),
                                             "angle outwards", "angle backwards"};
    constexpr double kRow = 62.0, kThick = 16.0;
    const double left = box.left + 20.0, width = box.right - 30.0 - left;
    std::string svg =
        text_at(left, box.top + 18.0, "class=\"head\"", "Sensitivity to errors of execution");
    double y = box.top + 52.0;
    for (std::size_t i = 0; i < axes.size(); ++i, y += kRow) {
      const double alone = std::clamp(indices.first[i], 0.0, 1.0);
      const double total = std::clamp(indices.total[i], 0.0, 1.0);
      svg += text_at(left, y, "", axes[i]);
      svg += text_at(left + width, y, "class=\"tick\" text-anchor=\"end\"",
                     fixed(100.0 * indices.first[i], 0) + " % first order, " +
                         fixed(100.0 * indices.total[i], 0) + " % total");
      svg += line_at("grid", left, y + 8.0 + 0.5 * kThick, left + width, y + 8.0 + 0.5 * kThick);
      svg += bar("area", left, y + 8.0, total * width, kThick);
      svg += bar("solid", left, y + 8.0, alone * width, kThick);
    }
    for (const char* line : {"Sobol indices of the leak over the region:",
                             "dark: first order; light: total, including interactions."})
      svg += text_at(left, (y += 16.0) - 12.0, "class=\"tick\"", line);
    return svg;
  };
}

const char* words_of(StepError error) {
  switch (error) {
    case StepError::RingSize:
      return "size";
    case StepError::SutureLength:
    case StepError::NeochordaLength:
      return "length";
    case StepError::SutureAnchor:
      return "anchor along the annulus";
    case StepError::StitchAlongLeaflet:
      return "stitch along the leaflet";
    case StepError::StitchTowardsEdge:
      return "stitch towards the edge";
  }
  return "";
}

std::string name_of(const RepairStep& step) {
  if (std::holds_alternative<Annuloplasty>(step)) return "ring";
  if (const auto* const suture = std::get_if<PapillaryApproximation>(&step))
    return std::string(to_string(suture->side)) + " suture";
  if (const auto* const neochorda = std::get_if<Neochorda>(&step))
    return "neochorda from " + neochorda->head;
  return "step";
}

/// The curves of one step.
Panel tolerance_panel(const RankedPlan& plan, int step) {
  return [&plan, step](const PlotBox& box) {
    constexpr std::array kHues = {Hue::Blue, Hue::Orange, Hue::Green};
    LinePanel panel{{"Error of the " + name_of(plan.plan.steps[static_cast<std::size_t>(step)]),
                     "error, mm", "leak, mm²"},
                    {}};
    Extent errors, leaks{0.0, 1.5 * kTraceLeak_mm2};
    for (const ToleranceCurve& curve : plan.tolerance) {
      if (curve.step != step) continue;
      panel.series.push_back({words_of(curve.error), curve.error_mm, curve.leak_mm2,
                              kHues[panel.series.size() % kHues.size()], Mark::Line});
      for (const double error : curve.error_mm) errors = including(errors, error);
      for (const double leak : curve.leak_mm2) leaks = including(leaks, leak);
    }
    panel.series.push_back({"none or trace below " + shown(kTraceLeak_mm2) + " mm²",
                            {errors.low, errors.high},
                            {kTraceLeak_mm2, kTraceLeak_mm2},
                            Hue::Ink,
                            Mark::Dashed});
    panel.y_holds = {0.0, 1.8 * leaks.high};  // room for the keys
    return draw_with_keys(panel, box);
  };
}

/// In rows of equal panels, from `top` downwards.
Drawn draw_panels(const std::vector<Panel>& panels, int columns, double top, double height) {
  const CellGrid grid{static_cast<int>(panels.size()), columns, top, height};
  Drawn drawn{"", bottom_of(grid)};
  for (int i = 0; i < grid.count; ++i)
    drawn.svg += panels[static_cast<std::size_t>(i)](cell(grid, i));
  return drawn;
}

std::string drawn_evidence(const RankedPlan& plan, const ValveMeasure& before,
                           const Layout& layout) {
  const RegionReport& region = plan.region;
  std::vector<Panel> maps, lines;
  for (const LeakMap& map : region.maps)
    if (any_finite(map.leak_mm2)) maps.push_back(map_panel(map, plan.plan, layout));
  if (!region.remodelling.empty()) lines.push_back(remodelling_panel(region.remodelling));
  if (std::isfinite(region.indices.total[0]))
    lines.push_back(indices_panel(region.indices, plan.plan));
  lines.push_back(coaptation_panel(before, plan.measure));
  for (int step = 0; step < std::ssize(plan.plan.steps); ++step)
    if (std::any_of(plan.tolerance.begin(), plan.tolerance.end(),
                    [step](const ToleranceCurve& curve) { return curve.step == step; }))
      lines.push_back(tolerance_panel(plan, step));
  Drawn drawn{"", 4.0};
  if (!maps.empty()) {
    drawn = {draw_scale({0.0, kLeakLimits_mm2.back(), 0, kLeakLimits_mm2},
                        "Leak, mm². Frame: the plan. Both muscles: mean over posterior angles.",
                        60.0, 12.0),
             kScaleHeight};
    if (layout.map_columns == kLineColumns) {
      maps.insert(maps.end(), lines.begin(), lines.end());
      std::swap(maps, lines);
    } else {
      const Drawn rows = draw_panels(maps, layout.map_columns, drawn.bottom, layout.map_height);
      drawn = {drawn.svg + rows.svg, rows.bottom};
    }
  }
  const Drawn rows = draw_panels(lines, kLineColumns, drawn.bottom, layout.line_height);
  return figure_svg("Evidence for rank " + std::to_string(plan.rank), drawn.svg + rows.svg,
                    {rows.bottom});
}

}  // namespace

std::string evidence_svg(const RankedPlan& plan, const ValveMeasure& before) {
  return drawn_evidence(plan, before, kFull);
}

std::string brief_evidence_svg(const RankedPlan& plan, const ValveMeasure& before) {
  return drawn_evidence(plan, before, kBrief);
}

}  // namespace coapt
