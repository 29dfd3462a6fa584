#include <algorithm>
#include <cmath>
#include <limits>

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

std::vector<const RankedPlan*> told_plans(const PlanReport& report) {
  std::vector<const RankedPlan*> plans;
  for (const RankedPlan& plan : report.result.plans)
    if (is_told(report, plan)) plans.push_back(&plan);
  return plans;
}

/// What a rule says of some plans alike: all that pass or are not assessed, or those with one finding.
struct SharedVerdict {
  const Gate* gate = nullptr;  ///< of the first of them
  std::string ranks;
};

std::vector<SharedVerdict> shared_verdicts(const std::vector<const RankedPlan*>& plans,
                                           std::size_t rule) {
  std::vector<SharedVerdict> verdicts;
  for (const RankedPlan* plan : plans) {
    if (rule >= plan->gates.size()) continue;
    const Gate& gate = plan->gates[rule];
    const auto found =
        std::find_if(verdicts.begin(), verdicts.end(), [&](const SharedVerdict& other) {
          const bool is_telling =
              gate.severity == GateSeverity::Warn || gate.severity == GateSeverity::Reject;
          return other.gate->severity == gate.severity &&
                 (!is_telling || other.gate->finding == gate.finding);
        });
    if (found == verdicts.end())
      verdicts.push_back({&gate, std::to_string(plan->rank)});
    else
      found->ranks += ", " + std::to_string(plan->rank);
  }
  return verdicts;
}

/// Each rule once, with what it says of which plans.
std::string gates_table(const std::vector<const RankedPlan*>& plans) {
  std::size_t rules = 0;
  for (const RankedPlan* plan : plans) rules = std::max(rules, plan->gates.size());
  if (rules == 0) return "";
  const auto cell = [](const std::string& words) {
    return "<td class=\"text\">" + escape_html(words) + "</td>";
  };
  std::string html =
      "<h3>Rules of practice</h3>\n<div class=\"scroll\"><table class=\"rules\"><thead><tr>"
      "<th scope=\"col\" class=\"text\">Rule</th><th scope=\"col\" class=\"text\">Verdict</th>"
      "<th scope=\"col\" class=\"text\">Plans</th><th scope=\"col\" class=\"text\">Finding, of "
      "the first of them</th><th scope=\"col\" class=\"text\">Source</th></tr></thead><tbody>\n";
  for (std::size_t rule = 0; rule < rules; ++rule) {
    bool is_first = true;
    for (const auto& [gate, ranks] : shared_verdicts(plans, rule)) {
      html += "<tr>" + cell(is_first ? in_words(gate->rule) : "") +
              "<td class=\"text\"><span class=\"verdict-of " + to_string(gate->severity) + "\">" +
              words_of(gate->severity) + "</span></td>" + cell(ranks) + cell(gate->finding) +
              cell(is_first ? gate->source : "") + "</tr>\n";
      is_first = false;
    }
  }
  return html + "</tbody></table></div>\n";
}

std::vector<std::string> measures_row(const std::string& name, const ValveMeasure& measure,
                                      const LeakStatistics& independent) {
  return {name,
          with_error(measure.leak.area_mm2, measure.leak_error_mm2),
          fixed(measure.coaptation.height_mean_mm, 1),
          fixed(measure.coaptation.height_min_mm, 1),
          fixed(measure.tenting_height_mm, 1),
          fixed(measure.tension_max_n, 2),
          fixed(measure.tension_sum_n, 1),
          fixed(independent.mean, 1),
          fixed(independent.p95, 1),
          fixed(independent.worst, 1)};
}

std::string before_and_after(const ValveMeasure& before,
                             const std::vector<const RankedPlan*>& plans) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<std::string>> cells = {
      {"Valve", "Leak, mm²", "Coaptation, mean, mm", "minimum, mm", "Tenting, mm",
       "Chordal tension, peak, N", "sum, N", "Leak with independent errors, mean, mm²",
       "95th percentile, mm²", "worst, mm²"},
      measures_row("Before", before, {.mean = kUnknown, .p95 = kUnknown, .worst = kUnknown})};
  for (const RankedPlan* plan : plans)
    cells.push_back(measures_row("Plan " + std::to_string(plan->rank), plan->measure,
                                 plan->region.independent_leak_mm2));
  return "<h3>Before and after, as planned</h3>\n" + table_html(cells) +
         "<p class=\"small\">Independent errors: of each muscle; a ring displaced by up to 1.5 mm "
         "and "
         "rotated by up to 5 degrees, with one suture torn out in a quarter of the cases; "
         "neochordae "
         "up to 1 mm too short or too long. The map of both muscles applies the same error to "
         "both.</p>\n";
}

std::string region_words(const RegionReport& region) {
  std::string words = grouped(region.closures) + ' ' + noun_of(region.closures, "closure") +
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

/// What the panels show.
std::string figure_words() {
  return "Heat maps: leak with sutures (or, without one, distances from tip to trigone) up to 1 mm "
         "too short (bottom) or too long (top) and tips up to 5 degrees inwards (left) or outwards "
         "(right); the frame marks the plan. Remodelling: leak when the tips move further away "
         "after the repair while a taut suture holds; above the dashed line the repair is no "
         "longer "
         "acceptable. Bars: fraction of the leak variance explained by each error. Coaptation: "
         "height of leaflet contact from commissure to commissure. Error of a step: leak when this "
         "step alone is off; lengths above 0 are too long, anchors are displaced anticlockwise "
         "(seen "
         "from the atrium), stitches towards the posteromedial commissure or the free edge.";
}

/// The plan in front in full: its pictures stand on the first page.
std::string details(const PlanReport& report, std::size_t index) {
  const RankedPlan& plan = report.result.plans[index];
  const ValveMeasure& before = report.result.before.measure;
  const std::string rank = std::to_string(plan.rank);
  const bool in_front = index == plan_in_front(report);
  std::string html = "<div class=\"plan-evidence\">";
  html += in_front ? "<details open>" : "<details>";
  html += "<summary id=\"plan-" + rank + "\"><h3>Rank " + rank +
          (plan.name.empty() ? "" : " (" + escape_html(plan.name) + ")") + "</h3> <small>" +
          escape_html(joined_steps(plan) + ". " + region_words(plan.region)) +
          ".</small></summary>\n" +
          (in_front ? chart_html(evidence_svg(plan, before), figure_words())
                    : chart_html(brief_evidence_svg(plan, before)));
  if (!in_front && index < report.after.size() && index < kPictures)
    html += picture_html(picture_of(report, {ReportPicture::View::After, index}),
                         "Atrial view and long-axis section after the repair",
                         "Rank " + rank + ", closed under systolic pressure.");
  return html + "</details></div>\n";
}

}  // namespace

std::string evidence_section(const PlanReport& report) {
  const std::vector<const RankedPlan*> plans = told_plans(report);
  std::string html = "<section id=\"evidence\"><h2>Evidence, plan by plan</h2>\n";
  for (std::size_t i = 0; i < report.result.plans.size(); ++i)
    if (is_told(report, report.result.plans[i])) html += details(report, i);
  return html + before_and_after(report.result.before.measure, plans) + gates_table(plans) +
         "</section>\n";
}

}  // namespace coapt
