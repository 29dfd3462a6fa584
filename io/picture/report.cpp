// What a surgeon asks first comes first (picture, plan, figures that matter), then the evidence, then
// the limits and how to get the same again.
#include "io/picture/report.h"

#include <algorithm>
#include <cassert>

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/json/result_json.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

std::string key_figure(const std::string& name, const std::string& value,
                       const std::string& remark) {
  return "<div><dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "<small>" +
         escape_html(remark) + "</small></dd></div>";
}

std::string operation_words(const Effort& effort) {
  return "ring " + fixed(effort.sizes_below, 1) + " sizes below; muscles moved by " +
         fixed(effort.anterolateral_movement_mm, 1) + " and " +
         fixed(effort.posteromedial_movement_mm, 1) + " mm";
}

std::string key_figures(const ValveMeasure& before, const RankedPlan& best) {
  const OrificeStatistics& leak = best.region.leak_mm2;
  const LeakMargin& margin = best.region.margin_to_leak;
  const ValveMeasure& after = best.measure;
  return "<dl>" +
         key_figure("Orifice", fixed(after.orifice.area_mm2, 1) + " mm²",
                    "before: " + fixed(before.orifice.area_mm2, 1) + " mm²") +
         key_figure("Leak when the repair varies", mean_and_sd(leak) + " mm²",
                    "mean and sd; worst " + fixed(leak.worst, 1) + " mm²") +
         key_figure("Good repair, below 5 mm²", percent(leak.below_5),
                    "of deviations; 95 % below " + fixed(leak.p95, 1) + " mm²") +
         key_figure("Margin to leak", suture_margin(margin) + " mm, " + angle_margin(margin) + "°",
                    "of suture, of angle: the first that leaks") +
         key_figure("Coaptation height", fixed(after.coaptation.height_mean_mm, 1) + " mm",
                    "before: " + fixed(before.coaptation.height_mean_mm, 1) + " mm") +
         key_figure("Highest chordal tension", fixed(after.tension_max_n, 2) + " N",
                    "before: " + fixed(before.tension_max_n, 2) + " N") +
         key_figure("Operation", counted(best.effort.steps, "step"), operation_words(best.effort)) +
         key_figure("Ahead of the next plan", percent(best.probability_outranks_next),
                    ties_with_next(best) ? "likely; the two tie" : "likely") +
         "</dl>\n";
}

std::string verdict(const SearchResult& result) {
  if (!result.any_competent)
    return "<p class=\"least-bad\">No plan closes this valve robustly; ranked least bad.</p>\n";
  std::string ranks;
  for (const RankedPlan& plan : result.plans)
    if (closes_robustly(plan)) ranks += (ranks.empty() ? "" : ", ") + std::to_string(plan.rank);
  return "<p class=\"robust\">Closes this valve robustly: rank " + ranks +
         ". Over the region of interest every closure converged, and mean + sd of the leak stay "
         "below 1 mm².</p>\n";
}

std::string best_plan(const PlanReport& report) {
  const RankedPlan& best = report.result.plans.front();
  std::string html = verdict(report.result) + "<section><h2>The plan that came first</h2>\n" +
                     list_html(steps_of(best), "<ul class=\"plan\">");
  if (!best.warnings.empty()) html += list_html(best.warnings, "<ul class=\"warning\">");
  html += key_figures(report.before.measure, best);
  if (!report.after.empty())
    html += picture_html(comparison_picture_png(report.before, report.after.front()),
                         "Atrial view and long-axis section before and after the first plan",
                         "Closed under systolic pressure, before and after. Blue: regurgitant "
                         "orifice, leaflets with their half thickness. Same scale.");
  return html + "</section>\n";
}

std::string reproduction(const PlanReport& report) {
  const SearchRequest& request = report.request;
  const auto row = [](const std::string& name, const std::string& value) {
    return "<tr><th>" + name + "</th><td class=\"mono\">" + escape_html(value) + "</td></tr>\n";
  };
  std::string html =
      "<section><h2>How to reproduce</h2>\n<div class=\"scroll\"><table "
      "class=\"facts\"><tbody>\n";
  if (!request.command.empty()) html += row("Command", request.command);
  html += row("Seed", std::to_string(request.options.seed)) +
          row("Version of coapt", std::string(version())) +
          row("Valve and closure", request.valve_hash) + "</tbody></table></div>\n" +
          "<p class=\"small\">The same on any number of threads, unless a time limit or a person "
          "stopped it.</p>\n";
  if (!report.before.valve.provenance.empty())
    html += "<p>Where the valve comes from:</p>" + list_html(report.before.valve.provenance);
  return html + "</section>\n";
}

std::string lead(const PlanReport& report) {
  const ValveMeasure& before = report.before.measure;
  return counted(static_cast<long>(report.result.plans.size()), "plan") +
         " ranked, best first. Before repair: orifice " + fixed(before.orifice.area_mm2, 1) +
         " mm² seen from the atrium, gap between the leaflets " +
         fixed(before.coaptation.gap_area_mm2, 1) + " mm².";
}

}  // namespace

std::string plan_report_html(const PlanReport& report) {
  std::string html;
  if (report.result.plans.empty())
    html += "<section><h2>No plan</h2><p>The search ended before any plan was scored.</p>" +
            picture_html(closure_picture_png(report.before), "The valve before repair",
                         "Before repair") +
            "</section>\n";
  else
    html += best_plan(report) + ranked_section(report.result) + evidence_section(report);
  html += search_section(report.result);
  html += "<section><h2>What is not modelled</h2>\n" + list_html(not_modelled()) + "</section>\n";
  html += reproduction(report);
  return html_page({"Repair plans for " + report.before.valve.name, lead(report), ""}, html);
}

PlanPictures close_for_report(const Valve& valve, const SearchResult& result,
                              const ClosureOptions& closure) {
  const auto close = [&](const Valve& one) {
    const ClosureResult closed = close_valve(one, closure);
    return ClosedValve{one, closed, measure(one, closed)};
  };
  PlanPictures pictures{close(valve), {}};
  for (const RankedPlan& ranked : result.plans) {
    const Expected<Valve> repaired = apply_plan(valve, ranked.plan, ring_catalogue());
    assert(repaired && "the search only ranks plans that can be applied");
    pictures.after.push_back(close(*repaired));
  }
  return pictures;
}

}  // namespace coapt
