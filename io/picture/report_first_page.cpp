// What a surgeon asks, in that order: does it close, what is done, how it looks, which figures and how sure,
// what to watch, what else there is.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/closed/diagnosis_sentence.h"
#include "core/repair/limits.h"
#include "core/valve/number_text.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/report_words.h"
#include "io/picture/text.h"
#include "search/plans/plan_row.h"
#include "search/plans/verdict.h"

namespace coapt {
namespace {

constexpr std::size_t kOthersShown = 5;  // rows that leave the page a page
constexpr std::size_t kWarningsShown = 5;
constexpr double kCounted = 0.99;  // resamples say no more

std::string key_figure(const std::string& name, const std::string& value,
                       const std::string& remark) {
  return "<div><dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "<small>" +
         escape_html(remark) + "</small></dd></div>\n";
}

bool varied(const RankedPlan& plan) { return std::isfinite(plan.region.leak_mm2.mean); }

/// Why the plan stands where it does.
std::string place_words(const std::vector<RankedPlan>& plans, std::size_t index) {
  const RankedPlan& plan = plans[index];
  const auto alike = std::count_if(plans.begin(), plans.end(), [&](const RankedPlan& other) {
    return other.of_class == plan.of_class;
  });
  if (alike > 1)
    return (plan.simplest_of_class ? "It is the simplest of " : "It is one of ") +
           std::to_string(alike) + " equivalent plans.";
  const double ahead = plan.probability_outranks_next;
  if (index + 1 == plans.size() || !std::isfinite(ahead)) return "";
  return "It is better than plan " + std::to_string(plans[index + 1].rank) +
         " with a probability of " + (ahead > kCounted ? "more than 99 %" : percent(ahead)) + ".";
}

std::string stop_words(SearchStop stop) {
  switch (stop) {
    case SearchStop::Cancelled:
      return "The search was cancelled; this is the best plan so far.";
    case SearchStop::TimeLimit:
      return "The search reached its time limit; this is the best plan so far.";
    case SearchStop::EvaluationLimit:
    case SearchStop::Exhausted:
    case SearchStop::NoImprovement:
    case SearchStop::TargetReached:
      return "";
  }
  return "";
}

/// What may be believed of the closing, first.
std::string verdict(const PlanReport& report, const RankedPlan& plan) {
  const RegionReport& region = plan.region;
  std::string words;
  const bool failed = plan.status != ClosureStatus::Converged || plan.crossing;
  const bool acceptable = plan.is_acceptable && !failed && varied(plan);
  if (failed)
    words = "The closure of this plan failed; its results are unreliable.";
  else if (!varied(plan))
    words =
        "It is unknown whether this plan is acceptable, because it was not closed with errors of "
        "execution.";
  else if (acceptable && plan.plan.steps.empty())
    words = "The valve is competent; no repair is indicated.";
  else if (acceptable)
    words = "The repaired valve leaks less than 5 mm² with a probability of " +
            probability_words(plan.acceptable_probability) + ", given " + known_errors(plan) +
            " (" + grouped(region.closures) + " of execution).";
  else
    words = "This plan is not acceptable, because " + why_not_acceptable(plan) + ".";
  std::string html =
      acceptable ? "<p class=\"robust\"><strong>" : "<p class=\"least-bad\"><strong>";
  html += escape_html(words) + "</strong>";
  if (!report.result.any_acceptable)
    html += " No plan is acceptable; plans are listed from the least to the most unfavourable.";
  for (const std::string& more :
       {place_words(report.result.plans, plan_in_front(report)), stop_words(report.result.stop)})
    if (!more.empty()) html += " " + escape_html(more);
  return html + "</p>\n";
}

std::string diagnosis(const PlanReport& report) {
  const SearchResult& result = report.result;
  return result.diagnosis
             ? tag("p",
                   escape_html(sentence_of(*result.diagnosis, result.before_estimates.leak_mm2)))
             : "";
}

std::string operation(const PlanReport& report, const RankedPlan& plan) {
  const std::size_t count = report.result.plans.size();
  const std::string heading =
      report.about != 0 ? "Plan " + std::to_string(plan.rank) + " of " + std::to_string(count)
      : count == 1      ? "The plan"
                        : "The first-ranked plan";
  std::string html = "<div class=\"operation\">" + tag("h2", escape_html(heading));
  if (!plan.name.empty()) html += "<p class=\"small\">" + escape_html(plan.name) + "</p>\n";
  html += "<ol class=\"plan\">\n";
  for (const StepWords& words : surgical_words(report.before, plan))
    html += "<li><strong>" + escape_html(words.step) + "</strong>" +
            (words.detail.empty() ? "" : "<br><span>" + escape_html(words.detail) + "</span>") +
            "</li>\n";
  return html + "</ol></div>\n";
}

std::string pictures(const PlanReport& report, std::size_t index) {
  if (index >= report.after.size()) return "";
  const ClosedValve& after = report.after[index];
  const ValveMeasure &was = report.before.measure, &is = after.measure;
  const std::string change = "leak " + with_unit(was.leak.area_mm2, 1, "mm²") + " before, " +
                             with_unit(is.leak.area_mm2, 1, "mm²") + " after";
  return "<div class=\"atrial\">" +
         picture_html(
             picture_of(report, {ReportPicture::View::AtrialPair, index}),
             "The closed valve seen from the atrium, anterior up, anterolateral left: " + change +
                 ". Implants are drawn over the leaflets.",
             "Closed under systolic pressure, same scale; anterior up, anterolateral left. "
             "Sutures and neochordae lie behind the leaflets.") +
         "</div>\n<div class=\"cut\">" +
         picture_html(picture_of(report, {ReportPicture::View::SectionChange, index}),
                      "Long-axis section through the middle of both leaflets after the repair, "
                      "leaflets before it in grey",
                      "Long axis; papillary tips and sutures are projected.") +
         "</div>\n";
}

std::string undersizing(const RankedPlan& plan) {
  return has_step<Annuloplasty>(plan.plan) ? fixed(plan.effort.sizes_below, 1) + " sizes"
                                           : "no ring";
}

std::string opening_figure(const RankedPlan& plan) {
  if (!plan.opening) return "";
  if (!trusted(*plan.opening))
    return key_figure("Opening in diastole", "unknown",
                      plan.opening->two_orifices ? "two orifices" : "no equilibrium was reached");
  return key_figure("Opening in diastole", known_tenths(plan.estimates.opening_mm2, 0.01) + " cm²",
                    "mean gradient " + known_tenths(plan.estimates.gradient_mmhg) +
                        " mmHg at rest; below 2.0 cm² is narrow");
}

std::string durability_figure(const RankedPlan& plan) {
  if (!plan.durability) return "";
  return key_figure("Reserve against progression", row_of(plan).reserve,
                    "of papillary displacement by progressing disease until the leak exceeds " +
                        shown(kMildLeak_mm2) + " mm²; in " + percent(plan.durability->outlasting) +
                        " of the simulated courses it does not within " +
                        shown(kFurthestCourse_mm) + " mm");
}

std::string leak_figure(const Estimate& before, const Estimate& after) {
  const EstimateWords was = words_of(before), is = words_of(after);
  const auto figure = [](const EstimateWords& words) {
    return words.value + (words.interval.empty() ? "" : " (" + words.interval + ")");
  };
  return key_figure("Leak as planned", figure(is) + " mm²",
                    is.cause + (is.cause.empty() ? "" : "; ") + "before " + figure(was) + " mm²" +
                        (was.cause.empty() || was.cause == is.cause ? "" : ", " + was.cause));
}

std::string tension_figure(double before_n, const RankedPlan& plan) {
  const std::string before = "before " + with_unit(before_n, 2, "N");
  constexpr const char* kName = "Highest chordal tension";
  if (!std::isfinite(plan.estimates.tension_max_n.value))
    return key_figure(kName, with_unit(plan.measure.tension_max_n, 2, "N"), before);
  const auto [value, interval, cause] = words_of(plan.estimates.tension_max_n);
  return key_figure(kName, value + " N",
                    (interval.empty() ? "" : interval + " N " + cause + "; ") + before);
}

std::string figures(const SearchResult& result, const RankedPlan& plan) {
  const ValveMeasure& before = result.before.measure;
  const bool has_interval = plan.estimates.leak_mm2.execution.has_value();
  const LeakMargin& margin = plan.region.margin_to_leak;
  const std::string why = why_margin_unknown(plan.region);
  const ValveMeasure& after = plan.measure;
  const std::string of_variations = varied(plan)
                                        ? "of " + grouped(plan.region.closures) + " closures"
                                        : "not closed with errors of execution";
  const std::string moved = fixed(plan.effort.anterolateral_movement_mm, 1) + " / " +
                            fixed(plan.effort.posteromedial_movement_mm, 1) + " mm";
  return "<dl>\n" + leak_figure(result.before_estimates.leak_mm2, plan.estimates.leak_mm2) +
         key_figure("Leak with errors of execution",
                    execution_words(plan) + (has_interval ? " mm²" : ""),
                    has_interval ? "5 to 95 %" : "unknown from fewer than five closures") +
         key_figure("Closures with errors of execution that leak less than " +
                        shown(kMildLeak_mm2) + " mm²",
                    percent(plan.region.leak_mm2.below_5), of_variations) +
         key_figure("Margin to leak",
                    suture_margin(margin) + (std::isfinite(margin.suture_length_mm) ? " mm" : "") +
                        " · " + angle_margin(margin) + (std::isfinite(margin.angle_deg) ? "°" : ""),
                    why.empty() ? "smallest error with a leak of " + shown(kTraceLeak_mm2) + " mm²"
                                : why) +
         key_figure("Coaptation height, mean", with_unit(after.coaptation.height_mean_mm, 1, "mm"),
                    "minimum " + fixed(after.coaptation.height_min_mm, 1) + "; before " +
                        fixed(before.coaptation.height_mean_mm, 1) + ", minimum " +
                        fixed(before.coaptation.height_min_mm, 1)) +
         tension_figure(before.tension_max_n, plan) +
         key_figure("Ring undersizing", undersizing(plan),
                    shown(kUsualSizesBelow) +
                        " sizes are usual for tethered leaflets, none for others; more than " +
                        shown(kUsualSizesBelow.max) + " are not accepted") +
         opening_figure(plan) + durability_figure(plan) +
         key_figure("Papillary relocation, AL / PM", moved,
                    "more than " + shown(kUsualMovement_mm) + " mm is unusual") +
         "</dl>\n";
}

std::string how_sure(const RankedPlan& plan) {
  std::string words;
  if (varied(plan)) {
    words =
        "Leak: the smallest area through which blood can flow back. Errors of execution: suture "
        "length (without a suture, the distance from tip to trigone) by up to 1 mm and direction "
        "of the tips by up to 5°, in " +
        grouped(plan.region.closures) + ' ' + noun_of(plan.region.closures, "closure");
    if (plan.region.failures > 0)
      words += ", " + std::to_string(plan.region.failures) + " of which failed and are excluded";
    words += ". ";
  } else {
    words =
        "This plan was not closed with errors of execution, so its tolerance to them is unknown. ";
  }
  if (plan.model)
    words +=
        "Tissue error: tissue and chordae vary within the ranges of their sources, in the same "
        "variants for all plans. ";
  return "<p class=\"small\">" + escape_html(words) + "Other errors (imaging, " +
         (plan.model ? "" : "tissue, ") +
         "ring placement) are not included; see <a "
         "href=\"#limits\">limits</a>.</p>\n";
}

std::string care(const RankedPlan& plan) {
  std::string html = "<div class=\"care\"><h3>Warnings</h3>\n";
  std::vector<std::string> shown(
      plan.warnings.begin(),
      plan.warnings.begin() + std::min<std::ptrdiff_t>(std::ssize(plan.warnings), kWarningsShown));
  if (shown.size() < plan.warnings.size())
    shown.push_back(std::to_string(plan.warnings.size() - shown.size()) +
                    " more in the rules of practice");
  html += shown.empty()
              ? "<p>The plan complies with all rules of practice that coapt can check.</p>\n"
              : list_html(shown, "<ul class=\"warning\">");
  std::string unseen;
  for (const Gate& gate : plan.gates)
    if (gate.severity == GateSeverity::NotAssessed) {
      std::string rule = gate.rule;
      std::replace(rule.begin(), rule.end(), '_', ' ');
      unseen += (unseen.empty() ? "" : ", ") + rule;
    }
  if (!unseen.empty())
    html += "<p class=\"small\">Not assessed: " + escape_html(unseen) + ".</p>\n";
  return html + "</div>\n";
}

std::string head_of(const PlanColumn& column) {
  std::string head = column.name;
  head[0] = static_cast<char>(std::toupper(head[0]));
  return "<th scope=\"col\">" + escape_html(head) + "</th>";
}

std::string other_row(const PlanReport& report, std::size_t index, bool in_front,
                      const PlanRow& row, const PlanRow& shared) {
  const RankedPlan& plan = report.result.plans[index];
  const std::string rank = std::to_string(plan.rank);
  std::string html = in_front ? "<tr class=\"this\">" : "<tr>";
  html += "<th scope=\"row\">" +
          (is_told(report, plan) ? "<a href=\"#plan-" + rank + "\">" + rank + "</a>" : rank) +
          (plan.is_acceptable ? " <span class=\"badge\">acceptable</span>" : "") +
          "</th><td class=\"words\">" + escape_html(short_words(plan)) + "</td>";
  for (const auto& [name, cell] : kPlanColumns)
    if ((shared.*cell).empty()) html += "<td>" + escape_html(row.*cell) + "</td>";
  return html + "<td>" + std::to_string(plan.warnings.size()) + "</td></tr>\n";
}

std::string others(const PlanReport& report, std::size_t front) {
  const std::vector<RankedPlan>& plans = report.result.plans;
  if (plans.size() < 2) return "";
  std::vector<PlanRow> rows;
  for (const RankedPlan& plan : plans) rows.push_back(row_of(plan));
  const PlanRow shared = take_shared(rows);
  const std::string same = words_of(shared);
  std::string html =
      "<div class=\"others\"><h3>Comparison with the other plans</h3>\n" +
      (same.empty() ? "" : "<p class=\"small\">All plans: " + escape_html(same) + ".</p>\n") +
      "<div class=\"scroll\"><table class=\"dense\"><thead><tr><th scope=\"col\">Rank</th><th "
      "scope=\"col\" class=\"words\">Operation</th>";
  for (const PlanColumn& column : kPlanColumns)
    if ((shared.*column.cell).empty()) html += head_of(column);
  html += "<th scope=\"col\">Warnings</th></tr></thead><tbody>\n";
  const std::size_t first = front < kOthersShown ? kOthersShown : kOthersShown - 1;
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (i < first || i == front) html += other_row(report, i, i == front, rows[i], shared);
  html += "</tbody></table></div>\n";
  if (plans.size() > kOthersShown)
    html += "<p class=\"small\">" + std::to_string(plans.size() - kOthersShown) +
            " more in <a href=\"#ranked\">all ranked plans</a>.</p>\n";
  return html + "</div>\n";
}

}  // namespace

std::string first_page(const PlanReport& report) {
  const std::size_t front = plan_in_front(report);
  const RankedPlan& plan = report.result.plans[front];
  return diagnosis(report) + "<section class=\"first\">\n" + verdict(report, plan) +
         operation(report, plan) + pictures(report, front) +
         "<div class=\"key\"><h3>Key figures and their uncertainty</h3>\n" +
         figures(report.result, plan) + how_sure(plan) + "</div>\n" + care(plan) +
         others(report, front) + "</section>\n";
}

}  // namespace coapt
