#include "io/picture/ablation_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kTableWidth = 1000.0, kTableTop = 108.0, kRow = 21.0, kGroupGap = 11.0,
                 kBar = 11.0;
constexpr double kLabels = 270.0;  // right end of the row labels
constexpr double kFoot = 58.0;
constexpr const char* kScaleGroup = "to compare";  // rows that the others are read against

/// A column of bars, its values as figures on the right. Logarithmic: bars begin at `base`.
struct Panel {
  const char* title;
  const char* unit;
  double left, right;      // of the bars
  double low, base, high;  // of the axis; log if low > 0
  std::vector<double> ticks;
  const char* colour;  // Okabe and Ito's, told apart by colour-blind readers
  double AblationSummary::*median;
  double AblationSummary::*largest;
  int decimals;
};

std::vector<Panel> panels() {
  return {{"Orifice",
           "|change|, mm2",
           280.0,
           460.0,
           0.01,
           0.01,
           300.0,
           {0.01, 0.1, 1.0, 10.0, 100.0},
           "#0072b2",
           &AblationSummary::median_orifice_mm2,
           &AblationSummary::largest_orifice_mm2,
           2},
          {"Shape",
           "rms change, mm",
           555.0,
           665.0,
           0.0,
           0.0,
           2.5,
           {0.0, 1.0, 2.0},
           "#009e73",
           &AblationSummary::median_rms_mm,
           &AblationSummary::largest_rms_mm,
           2},
          {"Time",
           "x full model",
           755.0,
           870.0,
           0.25,
           1.0,
           40.0,
           {0.3, 1.0, 3.0, 10.0, 30.0},
           "#d55e00",
           &AblationSummary::median_time_ratio,
           &AblationSummary::largest_time_ratio,
           1}};
}

double at(const Panel& panel, double value) {
  const bool log = panel.low > 0.0;
  const auto scaled = [log](double v) { return log ? std::log(v) : v; };
  const double share = (scaled(std::max(value, panel.low)) - scaled(panel.low)) /
                       (scaled(panel.high) - scaled(panel.low));
  return panel.left + std::min(share, 1.0) * (panel.right - panel.left);
}

/// "0.012", "1.2", "12": two figures, never more than `decimals` + 1 decimals.
std::string figure(double value, int decimals) {
  return fixed(value, value >= 10.0 ? 0 : value >= 1.0 ? 1 : decimals);
}

std::string draw_bar(const Panel& panel, const AblationSummary& summary, double y) {
  const double median = summary.*panel.median, largest = summary.*panel.largest;
  const double base = at(panel, panel.base), tip = at(panel, median), end = at(panel, largest);
  const std::string opacity = summary.group == kScaleGroup ? ".5" : "1";
  std::string svg =
      "<rect x=\"" + fixed(std::min(base, tip), 1) + "\" y=\"" + fixed(y - 0.5 * kBar, 1) +
      "\" width=\"" + fixed(std::max(1.5, std::abs(tip - base)), 1) + "\" height=\"" +
      fixed(kBar, 1) + "\" fill=\"" + panel.colour + "\" opacity=\"" + opacity + "\"/>\n";
  svg += line_at("whisker", std::max(tip, base), y, end, y);
  svg += line_at("whisker", end, y - 4.0, end, y + 4.0);
  svg += text_at(panel.right + 46.0, y + 4.5, "text-anchor=\"end\" class=\"figure\"",
                 figure(median, panel.decimals));
  svg += text_at(panel.right + 82.0, y + 4.5, "text-anchor=\"end\" class=\"tick\"",
                 figure(largest, 1));
  return svg;
}

/// How many closures failed or else were tried again; empty if none.
std::string trouble(const AblationSummary& summary) {
  const int failed = std::max(summary.crossed, summary.unconverged);
  if (failed > 0) return std::to_string(failed) + " fail";
  return summary.retried > 0 ? std::to_string(summary.retried) : "";
}

std::string draw_axis(const Panel& panel, double bottom) {
  std::string svg = text_at(panel.left, kTableTop - 40.0, "class=\"head\"", panel.title);
  svg += text_at(panel.left, kTableTop - 24.0, "class=\"tick\"", panel.unit);
  svg +=
      text_at(panel.right + 46.0, kTableTop - 24.0, "text-anchor=\"end\" class=\"tick\"", "median");
  svg +=
      text_at(panel.right + 82.0, kTableTop - 24.0, "text-anchor=\"end\" class=\"tick\"", "most");
  for (const double tick : panel.ticks) {
    const double x = at(panel, tick);
    svg += line_at(tick == panel.base ? "axis" : "grid", x, kTableTop - 8.0, x, bottom);
    std::ostringstream label;
    label << tick;
    svg += text_at(x, bottom + 16.0, "text-anchor=\"middle\" class=\"tick\"", label.str());
  }
  return svg;
}

/// Dashed down the panel: how much the model's answer moves for a reason that is no ingredient.
std::string draw_floor(const Panel& panel, const std::vector<AblationSummary>& summaries,
                       double bottom) {
  for (const AblationSummary& summary : summaries)
    if (summary.group == kScaleGroup) {
      const double x = at(panel, summary.*panel.median);
      return line_at("floor", x, kTableTop - 8.0, x, bottom);
    }
  return "";
}

std::string style() {
  return "<style>\n"
         ".coapt-chart{color:#26313d;font:13px system-ui,\"Segoe UI\",\"DejaVu Sans\",sans-serif}\n"
         "@media (prefers-color-scheme:dark){.coapt-chart{color:#d8dee6}}\n"
         ".coapt-chart text{fill:currentColor}.coapt-chart .title{font-size:17px;font-weight:600}\n"
         ".coapt-chart .head{font-size:14px;font-weight:600}\n"
         ".coapt-chart .group{font-weight:600;font-size:12px}\n"
         ".coapt-chart .tick{opacity:.75;font-size:11.5px}.coapt-chart .figure{font-size:12.5px}\n"
         ".coapt-chart .grid{stroke:currentColor;opacity:.14}\n"
         ".coapt-chart .axis{stroke:currentColor;opacity:.55}\n"
         ".coapt-chart .whisker{stroke:currentColor;opacity:.6;stroke-width:1.2}\n"
         ".coapt-chart .floor{stroke:currentColor;opacity:.65;stroke-dasharray:4 3}\n"
         "</style>\n";
}

}  // namespace

std::string ablation_csv(const std::vector<AblationOutcome>& outcomes) {
  std::ostringstream csv;
  csv << "group,change,scene,status,crossing,attempts,compared,full_orifice_mm2,orifice_change_mm2,"
         "leak_change_mm2,rms_mm,seconds,time_ratio\n";
  for (const AblationOutcome& o : outcomes)
    csv << o.group << ',' << o.change << ',' << o.scene << ',' << to_string(o.status) << ','
        << (o.crossing ? "true" : "false") << ',' << o.attempts << ','
        << (o.compared ? "true" : "false") << ',' << o.full_orifice_mm2 << ','
        << o.orifice_change_mm2 << ',' << o.leak_change_mm2 << ',' << o.rms_mm << ',' << o.seconds
        << ',' << o.time_ratio << '\n';
  return csv.str();
}

std::string ablation_svg(const std::vector<AblationOutcome>& outcomes) {
  const std::vector<AblationSummary> summaries = summarise(outcomes);
  std::string rows, last_group;
  double y = kTableTop - kGroupGap;
  for (const AblationSummary& summary : summaries) {
    if (summary.group != last_group) {
      y += kGroupGap;
      rows += text_at(8.0, y + 4.5, "class=\"group\"", summary.group);
    }
    last_group = summary.group;
    rows += text_at(kLabels, y + 4.5, "text-anchor=\"end\"", summary.change);
    for (const Panel& panel : panels()) rows += draw_bar(panel, summary, y);
    rows +=
        text_at(kTableWidth - 8.0, y + 4.5, "text-anchor=\"end\" class=\"tick\"", trouble(summary));
    y += kRow;
  }
  const double bottom = y - 0.4 * kRow;
  const std::string scenes = std::to_string(summaries.empty() ? 0 : summaries.front().scenes);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"coapt-chart\" viewBox=\"0 0 " +
      fixed(kTableWidth, 0) + " " + fixed(bottom + kFoot, 0) +
      "\" role=\"img\" aria-label=\"What each ingredient buys and costs\">\n" + style();
  svg += text_at(8.0, 24.0, "class=\"title\"",
                 "What each ingredient of a closure buys, and what it costs");
  svg +=
      text_at(8.0, 44.0, "class=\"tick\"",
              "Against the full model over " + scenes +
                  " scenes: bar median, tick largest. Beyond the dashed line: more than the same "
                  "model differs when closed at half the speed.");
  for (const Panel& panel : panels()) {
    svg += draw_axis(panel, bottom);
    if (panel.base < 1.0) svg += draw_floor(panel, summaries, bottom);
  }
  if (std::any_of(summaries.begin(), summaries.end(),
                  [](const AblationSummary& s) { return !trouble(s).empty(); })) {
    svg +=
        text_at(kTableWidth - 8.0, kTableTop - 40.0, "text-anchor=\"end\" class=\"tick\"", "tried");
    svg +=
        text_at(kTableWidth - 8.0, kTableTop - 24.0, "text-anchor=\"end\" class=\"tick\"", "again");
  }
  svg +=
      text_at(8.0, bottom + 44.0, "class=\"tick\"",
              "Rows tell what replaces the full model's ingredient. Contact thickness also counts "
              "in the orifice, which leaflets of that thickness leave open.");
  return svg + rows + "</svg>\n";
}

}  // namespace coapt
