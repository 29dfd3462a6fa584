#include <algorithm>
#include <cmath>

#include "io/picture/evidence_figure.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/report_words.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kPictures = 10;  // a third of a megabyte each

const char* words_of(GateSeverity severity) {
  switch (severity) {
    case GateSeverity::Pass:
      return "✓ pass";
    case GateSeverity::Warn:
      return "! warn";
    case GateSeverity::Reject:
      return "✗ reject";
    case GateSeverity::NotAssessed:
      return "– not assessed";
  }
  return "";
}

std::string in_words(std::string rule) {
  std::replace(rule.begin(), rule.end(), '_', ' ');
  return rule;
}

std::string gates_table(const std::vector<Gate>& gates) {
  if (gates.empty()) return "";
  std::string html =
      "<h4>Rules of practice</h4>\n<div class=\"scroll\"><table class=\"whole\"><thead><tr>"
      "<th scope=\"col\" class=\"text\">Rule</th><th scope=\"col\" class=\"text\">Verdict</th><th "
      "scope=\"col\" class=\"text\">Finding</th>"
      "<th scope=\"col\" class=\"text\">Source</th></tr></thead><tbody>\n";
  for (const Gate& gate : gates)
    html += "<tr><td class=\"text\">" + escape_html(in_words(gate.rule)) +
            "</td><td class=\"text\"><span class=\"verdict-of " + to_string(gate.severity) + "\">" +
            words_of(gate.severity) + "</span></td><td class=\"text\">" +
            escape_html(gate.finding) + "</td><td class=\"text\">" + escape_html(gate.source) +
            "</td></tr>\n";
  return html + "</tbody></table></div>\n";
}

std::vector<std::string> measures_row(const std::string& name, const ValveMeasure& measure) {
  return {name,
          with_error(measure.leak.area_mm2, measure.leak_error_mm2),
          fixed(measure.coaptation.height_mean_mm, 1),
          fixed(measure.coaptation.height_min_mm, 1),
          fixed(measure.tenting_height_mm, 1),
          fixed(measure.tension_max_n, 2),
          fixed(measure.tension_sum_n, 1)};
}

std::string before_and_after(const ValveMeasure& before, const ValveMeasure& after) {
  return "<h4>Before and after, as planned</h4>\n" +
         table_html({{"Valve", "Leak, mm²", "Coaptation, mean, mm", "minimum, mm", "Tenting, mm",
                      "Chordal tension, peak, N", "sum, N"},
                     measures_row("Before", before),
                     measures_row("After", after)});
}

std::string independent_words(const LeakStatistics& leak) {
  if (!std::isfinite(leak.mean)) return "";
  return "<p class=\"small\">The map of both muscles applies the same error to both. With "
         "independent errors (each muscle; a ring displaced by up to 1.5 mm and rotated by up to 5 "
         "degrees, with one suture torn out in a quarter of the cases; neochordae up to 1 mm too "
         "short or too long), the leak is " +
         mean_and_sd(leak) + " mm², at worst " + fixed(leak.worst, 1) + " mm².</p>\n";
}

std::string region_words(const RegionReport& region) {
  std::string words = grouped(region.closures) + (region.closures == 1 ? " closure" : " closures") +
                      " over the region of interest";
  if (region.failures > 0)
    words += ", " + grouped(region.failures) + " of which failed and are excluded";
  return words;
}

std::string joined_steps(const RankedPlan& plan) {
  std::string words;
  for (const std::string& step : steps_of(plan)) words += (words.empty() ? "" : "; ") + step;
  return words;
}

/// What the panels show, those that are there.
std::string figure_words(const RegionReport& region) {
  std::string words;
  if (!region.maps.empty())
    words +=
        "Heat maps: leak with sutures (or, without one, distances from tip to trigone) up to 1 mm "
        "too short (bottom) or too long (top) and tips up to 5 degrees inwards (left) or outwards "
        "(right); the frame marks the plan. ";
  if (!region.remodelling.empty())
    words +=
        "Remodelling: leak when the tips move further away after the repair while a taut suture "
        "holds; above the dashed line the repair is no longer acceptable. ";
  if (std::isfinite(region.indices.total[0]))
    words += "Bars: fraction of the leak variance explained by each error. ";
  return words + "Coaptation: height of leaflet contact from commissure to commissure.";
}

std::string details(const PlanReport& report, std::size_t index) {
  const RankedPlan& plan = report.result.plans[index];
  const ValveMeasure& before = report.result.before.measure;
  const std::string rank = std::to_string(plan.rank);
  std::string html = "<div class=\"plan-evidence\">";
  html += index == plan_in_front(report) ? "<details open>" : "<details>";
  html += "<summary id=\"plan-" + rank + "\"><h3>Rank " + rank +
          (plan.name.empty() ? "" : " (" + escape_html(plan.name) + ")") + "</h3> <small>" +
          escape_html(joined_steps(plan) + ". " + region_words(plan.region)) +
          ".</small></summary>\n" +
          chart_html(evidence_svg(plan, before), figure_words(plan.region)) +
          independent_words(plan.region.independent_leak_mm2) +
          before_and_after(before, plan.measure) + gates_table(plan.gates);
  if (index < report.after.size() && index < kPictures)
    html += picture_html(picture_of(report, {ReportPicture::View::After, index}),
                         "Atrial view and long-axis section",
                         "Rank " + rank + ", closed under systolic pressure.");
  return html + "</details></div>\n";
}

}  // namespace

std::string evidence_section(const PlanReport& report) {
  std::string html = "<section id=\"evidence\"><h2>Evidence, plan by plan</h2>\n";
  for (std::size_t i = 0; i < report.result.plans.size(); ++i)
    if (is_told(report, report.result.plans[i])) html += details(report, i);
  return html + "</section>\n";
}

}  // namespace coapt
