// The plan report: what a surgeon asks first comes first (picture, plan, figures that matter), then
// the evidence, then the limits and how to get the same again. One file, no scripts, nothing
// fetched.
#include <algorithm>

#include "io/json/result_json.h"
#include "io/picture/picture.h"
#include "io/picture/report_style.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

std::string tag(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

std::string list_of(const std::vector<std::string>& lines, const std::string& opening = "<ul>") {
  std::string html = opening;
  for (const std::string& line : lines) html += "<li>" + escape_html(line) + "</li>";
  return html + "</ul>\n";
}

std::string figure(const std::string& png, const std::string& alternative,
                   const std::string& caption) {
  return "<figure><img alt=\"" + escape_html(alternative) + "\" src=\"data:image/png;base64," +
         base64(png) + "\"><figcaption>" + escape_html(caption) + "</figcaption></figure>\n";
}

std::vector<std::string> steps_of(const RankedPlan& plan) {
  return plan.description.empty() ? std::vector<std::string>{"no repair"} : plan.description;
}

std::string key_figure(const std::string& name, const std::string& value,
                       const std::string& remark) {
  return "<div><dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "<small>" +
         escape_html(remark) + "</small></dd></div>";
}

std::string key_figures(const ValveMeasure& before, const RankedPlan& best) {
  const OrificeStatistics& leak = best.leak_mm2;
  const ValveMeasure& after = best.measure;
  return "<dl>" +
         key_figure("Orifice", fixed(after.orifice.area_mm2, 1) + " mm²",
                    "before: " + fixed(before.orifice.area_mm2, 1) + " mm²") +
         key_figure("Leak when the repair varies",
                    fixed(leak.mean, 1) + " ± " + fixed(leak.sd, 1) + " mm²",
                    "mean and sd; worst " + fixed(leak.worst, 1) + " mm²") +
         key_figure("Coaptation height", fixed(after.coaptation.height_mean_mm, 1) + " mm",
                    "before: " + fixed(before.coaptation.height_mean_mm, 1) + " mm") +
         key_figure("Highest chordal tension", fixed(after.tension_max_n, 2) + " N",
                    "before: " + fixed(before.tension_max_n, 2) + " N") +
         "</dl>\n";
}

std::string best_plan(const ClosedValve& before, const ClosedValve* after, const RankedPlan& best) {
  std::string html = "<section><h2>The plan that came first</h2>\n";
  html += list_of(steps_of(best), "<ul class=\"plan\">");
  for (const std::string& warning : best.warnings)
    html += "<p class=\"warning\">" + escape_html(warning) + "</p>\n";
  html += key_figures(before.measure, best);
  if (after)
    html += figure(comparison_picture_png(before, *after),
                   "Atrial view and long-axis section before and after the first plan",
                   "Closed under systolic pressure, before and after. Blue: regurgitant orifice, "
                   "leaflets with their half thickness. Same scale.");
  return html + "</section>\n";
}

std::string table_row(const RankedPlan& plan) {
  const OrificeStatistics& leak = plan.leak_mm2;
  std::vector<std::string> remarks = plan.warnings;
  if (plan.status != ClosureStatus::Converged)
    remarks.push_back(std::string("closure: ") + to_string(plan.status));
  if (plan.crossing) remarks.push_back("leaflets pass through each other");
  const auto cell = [](const std::string& text) { return "<td>" + text + "</td>"; };
  return "<tr>" + cell(std::to_string(plan.rank)) + "<td class=\"words\">" +
         list_of(steps_of(plan)) + "</td>" + cell(fixed(plan.measure.orifice.area_mm2, 1)) +
         cell(fixed(plan.measure.coaptation.gap_area_mm2, 1)) + cell(fixed(leak.mean, 1)) +
         cell(fixed(leak.sd, 1)) + cell(fixed(leak.worst, 1)) +
         cell(fixed(plan.measure.coaptation.height_mean_mm, 1)) +
         cell(fixed(plan.measure.tension_max_n, 2)) + "<td class=\"words warning\">" +
         (remarks.empty() ? "" : list_of(remarks)) + "</td></tr>\n";
}

std::string ranked_table(const SearchResult& result) {
  std::string html =
      "<section><h2>All ranked plans</h2>\n<div class=\"scroll\"><table><thead><tr><th>Rank</th>"
      "<th class=\"words\">Steps</th><th>Orifice<br>mm²</th><th>Gap<br>mm²</th>"
      "<th>Leak, mean<br>mm²</th><th>sd<br>mm²</th><th>worst<br>mm²</th>"
      "<th>Coaptation<br>mm</th><th>Tension<br>N</th>"
      "<th class=\"words\">Warnings</th></tr></thead><tbody>\n";
  for (const RankedPlan& plan : result.plans) html += table_row(plan);
  return html +
         "</tbody></table></div>\n<p class=\"small\">Orifice: as planned, seen from the atrium. "
         "Gap: opening between the leaflets in three dimensions, which that view can hide. Leak: "
         "the larger of the two, over small deviations of suture length and papillary position "
         "around the plan. Coaptation: mean height over nine sections. Tension: highest in any "
         "chorda. The orifice is anatomic, not an effective regurgitant orifice "
         "area.</p></section>\n";
}

std::string other_pictures(const std::vector<ClosedValve>& after, const SearchResult& result) {
  const std::size_t count = std::min(after.size(), result.plans.size());
  if (count < 2) return "";
  std::string html = "<section><h2>The other plans, closed</h2>\n";
  for (std::size_t i = 1; i < count; ++i) {
    std::string words = "Rank " + std::to_string(result.plans[i].rank) + ": ";
    const std::vector<std::string> steps = steps_of(result.plans[i]);
    for (std::size_t s = 0; s < steps.size(); ++s) words += (s ? "; " : "") + steps[s];
    html += figure(closure_picture_png(after[i]), "Atrial view and long-axis section", words);
  }
  return html + "</section>\n";
}

std::string stop_words(SearchStop stop) {
  switch (stop) {
    case SearchStop::EvaluationLimit:
      return "It used all its evaluations.";
    case SearchStop::TimeLimit:
      return "It reached its time limit.";
    case SearchStop::Cancelled:
      return "It was cancelled; this is the best so far.";
  }
  return "";
}

std::string progress(const SearchResult& result) {
  Series best{"best plan so far", {}, result.best_cost_history};
  for (std::size_t i = 0; i < best.y.size(); ++i) best.x.push_back(static_cast<double>(i + 1));
  std::string html = "<section><h2>How the search went</h2>\n";
  if (!best.y.empty())
    html += "<div class=\"chart\">" +
            chart_svg({"Cost of the best plan so far",
                       "evaluations",
                       "cost (lower is better)",
                       {std::move(best)}}) +
            "</div>\n";
  return html + "<p class=\"small\">" + counted(result.closures, "closure") + " in " +
         fixed(result.seconds, 1) + " s, re-scoring included; " +
         std::to_string(result.closures_not_converged) + " did not converge, " +
         std::to_string(result.closures_crossed) + " crossed. " + stop_words(result.stop) +
         "</p></section>\n";
}

std::string limits() {
  return "<section><h2>What is not modelled</h2>\n" +
         list_of({"Blood flow: pressure is static, jets and gradients are not computed.",
                  "Diastole: a repair may narrow the open valve; filling is not assessed.",
                  "The ventricle: annulus and papillary tips do not move while the valve closes.",
                  "Tissue that differs from place to place, calcification, clefts that are not in "
                  "the valve file, sutures that tear, healing and growth.",
                  "Gaps that tissue hides when seen from the atrium; the coaptation heights and "
                  "distances are three-dimensional and show them."}) +
         "</section>\n";
}

}  // namespace

std::string plan_report_html(const ClosedValve& before, const std::vector<ClosedValve>& after,
                             const SearchResult& result, const std::string& command) {
  const std::string title = "Repair plans for " + before.valve.name;
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data:; style-src 'unsafe-inline'\">\n";
  html += tag("title", escape_html(title)) + tag("style", std::string(kReportStyle));
  html += "</head>\n<body>\n<main>\n" + tag("h1", escape_html(title));
  html += "<p class=\"lead\">" + counted(static_cast<long>(result.plans.size()), "plan") +
          " ranked, best first. Before repair: orifice " +
          fixed(before.measure.orifice.area_mm2, 1) +
          " mm² seen from the atrium, gap between the leaflets " +
          fixed(before.measure.coaptation.gap_area_mm2, 1) + " mm².</p>\n";
  html += "<p class=\"notice\">" + escape_html(kResearchNotice) + "</p>\n";
  if (result.plans.empty())
    html += "<section><h2>No plan</h2><p>The search ended before any plan was scored.</p>" +
            figure(closure_picture_png(before), "The valve before repair", "Before repair") +
            "</section>\n";
  else
    html += best_plan(before, after.empty() ? nullptr : &after.front(), result.plans.front()) +
            ranked_table(result) + other_pictures(after, result);
  html += progress(result) + limits();
  html += "<section><h2>How to reproduce</h2>\n<pre>" + escape_html(command) + "</pre>\n";
  if (!before.valve.provenance.empty())
    html += "<p>Where the valve comes from:</p>" + list_of(before.valve.provenance);
  return html + "</section>\n</main>\n</body>\n</html>\n";
}

}  // namespace coapt
