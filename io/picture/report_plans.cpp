#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/closure/standing.h"
#include "io/picture/html.h"
#include "io/picture/line_chart.h"
#include "io/picture/report_parts.h"
#include "io/picture/report_words.h"
#include "io/picture/text.h"
#include "search/plans/plan_key.h"

namespace coapt {
namespace {

std::string cell(const std::string& words, const std::string& attributes = "") {
  return "<td" + attributes + ">" + escape_html(words) + "</td>";
}

std::string rank_cell(const RankedPlan& plan) {
  return "<th scope=\"row\">" + std::to_string(plan.rank) +
         (plan.is_acceptable ? " <span class=\"badge\">acceptable</span>" : "") +
         (plan.pareto ? " <span class=\"badge plain\">Pareto</span>" : "") + "</th>";
}

std::string failed_draws(const RankedPlan& plan) {
  const int failures = plan.model->failures;
  return failures == 0 ? "" : " (" + std::to_string(failures) + " failed and are excluded)";
}

/// "0.1 to 3.5 mm² (5 to 95 %)".
std::string tissue_words(const Estimate& leak) {
  return leak.tissue ? interval_words(*leak.tissue) + " mm² (5 to 95 %)" : "unknown";
}

std::vector<std::string> doubts_about(const RankedPlan& plan) {
  std::vector<std::string> doubts = plan.warnings;
  if (const std::string doubt = doubt_about(plan.status, plan.crossing); !doubt.empty())
    doubts.push_back(doubt);
  return doubts;
}

/// Of the leak on the finer mesh and in variants of the model.
std::string checked_words(const RankedPlan& plan) {
  std::string words;
  if (plan.fine)
    words +=
        "Leak on the finer mesh " +
        with_error(plan.fine->leak_mm2, plan.fine_leak_error_mm2, "mm²") +
        (plan.own_mesh_rank == plan.rank || plan.own_mesh_rank == 0
             ? ""
             : "; on the valve's own mesh the plan ranks " + std::to_string(plan.own_mesh_rank)) +
        ". ";
  if (plan.model)
    words += "Leak in " + counted(plan.model->draws, "variant") +
             " of tissue and chordae: " + tissue_words(plan.estimates.leak_mm2) +
             failed_draws(plan) + ".";
  return words.empty() ? "" : "<p class=\"small\">" + escape_html(words) + "</p>";
}

std::string rows_of(const RankedPlan& plan) {
  const LeakStatistics& leak = plan.region.leak_mm2;
  const LeakMargin& to_leak = plan.region.margin_to_leak;
  const std::vector<std::string> doubts = doubts_about(plan);
  const std::string checked = checked_words(plan);
  const bool more = !doubts.empty() || !checked.empty();
  std::string html = more ? "<tr class=\"has-more\">" : "<tr>";
  html += rank_cell(plan) + "<td class=\"words\">";
  if (!plan.name.empty()) html += "<strong>" + escape_html(plan.name) + "</strong><br>";
  html += escape_html(short_words(plan)) + "</td>";
  for (const std::string& figure :
       {words_of(plan.estimates.leak_mm2).value, execution_words(plan), fixed(leak.worst, 1),
        percent(leak.below_5), suture_margin(to_leak), angle_margin(to_leak),
        fixed(plan.measure.coaptation.height_mean_mm, 1), fixed(plan.measure.tension_max_n, 2)})
    html += cell(figure);
  html += "</tr>\n";
  if (more)
    html += "<tr class=\"more\"><td></td><td class=\"words\" colspan=\"9\">" +
            (doubts.empty() ? "" : list_html(doubts, "<ul class=\"warning\">")) + checked +
            "</td></tr>\n";
  return html;
}

/// What a plan trades; NaN where it is not known.
struct Traded {
  std::string name;  ///< its rank; empty: it is not ranked
  bool pareto = false;
  double steps = 0.0, leak_mm2 = 0.0, gradient_mmhg = 0.0, not_lasted_mm = 0.0;
};

Traded traded(const RankedPlan& plan) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const bool opened = plan.opening && trusted(*plan.opening);
  return {std::to_string(plan.rank),
          plan.pareto,
          static_cast<double>(plan.effort.steps),
          plan.region.leak_mm2.mean + plan.region.leak_mm2.sd,
          opened ? plan.opening->measure.gradient_mmhg : kUnknown,
          plan.durability ? kFurthestCourse_mm - plan.durability->expected_mm : kUnknown};
}

Traded traded(const ParetoPlan& plan, double flow_ml_s) {
  return {"",
          true,
          static_cast<double>(plan.steps),
          plan.mean_mm2 + plan.sd_mm2,
          mean_gradient_mmhg(plan.opening_mm2, flow_ml_s),
          kFurthestCourse_mm - plan.durability_mm};
}

/// The ranked plans that can be drawn, then those of the front that are not among them.
std::vector<Traded> traded_plans(const SearchResult& result) {
  std::vector<Traded> plans;
  std::set<std::string> ranked;
  const double flow_ml_s = result.opening_before ? result.opening_before->measure.flow_ml_s
                                                 : std::numeric_limits<double>::quiet_NaN();
  for (const RankedPlan& plan : result.plans) {
    ranked.insert(plan_key(plan.plan));
    plans.push_back(traded(plan));
  }
  for (const ParetoPlan& plan : result.pareto_front)
    if (!ranked.contains(plan_key(plan.plan))) plans.push_back(traded(plan, flow_ml_s));
  std::erase_if(plans, [](const Traded& plan) { return !std::isfinite(plan.leak_mm2); });
  return plans;
}

/// A point per plan with its rank beside it.
LinePanel trade(const std::vector<Traded>& plans, const char* label, double Traded::*x) {
  LinePanel panel{{"", label, "leak, mean + sd, mm²"}, {}};
  PanelSeries front{"ranked, Pareto-optimal", {}, {}, Hue::Blue, Mark::Dot};
  PanelSeries others{"ranked, not Pareto-optimal", {}, {}, Hue::Ink, Mark::Hollow};
  PanelSeries found{"Pareto-optimal, not ranked", {}, {}, Hue::Orange, Mark::Hollow};
  for (const Traded& plan : plans) {
    if (!std::isfinite(plan.*x)) continue;
    PanelSeries& series = plan.name.empty() ? found : plan.pareto ? front : others;
    series.x.push_back(plan.*x);
    series.y.push_back(plan.leak_mm2);
    series.names.push_back(plan.name);
  }
  panel.x_holds = {0.0, 1.0};
  panel.y_holds = {0.0, 1.0};
  panel.series = {std::move(front), std::move(others), std::move(found)};
  return panel;
}

std::string trade_offs(const SearchResult& result) {
  const std::vector<Traded> plans = traded_plans(result);
  if (plans.size() < 2) return "";
  const bool all =
      std::all_of(result.plans.begin(), result.plans.end(),
                  [](const RankedPlan& plan) { return std::isfinite(plan.region.leak_mm2.mean); });
  const LineChart chart{"Trade-offs between closure and other objectives",
                        std::string("Numbers are ranks; lower and further left is better.") +
                            (all ? "" : " Plans without closures over the region are omitted."),
                        {trade(plans, "steps of the operation", &Traded::steps),
                         trade(plans, "mean gradient in diastole, mmHg", &Traded::gradient_mmhg),
                         trade(plans, "shortfall of the reserve against progression from 12 mm, mm",
                               &Traded::not_lasted_mm)}};
  return chart_html(line_chart_svg(chart),
                    "Each point is a plan. A plan is Pareto-optimal if no other plan is at least "
                    "as good in leak (mean + sd), opening and reserve against progression and "
                    "better in one of them. Unranked plans are shown where all three values exist; "
                    "they were closed at fewer points of the region.");
}

}  // namespace

std::string ranked_section(const PlanReport& report) {
  const SearchResult& result = report.result;
  std::string html =
      "<section id=\"ranked\"><h2>All ranked plans</h2>\n<div class=\"scroll\"><table "
      "class=\"dense\"><thead>"
      "<tr><td class=\"group\" colspan=\"2\"></td><th scope=\"colgroup\" class=\"group\">As "
      "planned</th>"
      "<th scope=\"colgroup\" class=\"group\" colspan=\"3\">Leak with errors of execution</th>"
      "<th scope=\"colgroup\" class=\"group\" colspan=\"2\">Margin to leak</th>"
      "<td class=\"group\" colspan=\"2\"></td></tr>"
      "<tr><th scope=\"col\">Rank</th><th scope=\"col\" class=\"words\">Steps</th><th "
      "scope=\"col\">Leak<br>mm²</th>"
      "<th scope=\"col\">5 to 95 %<br>mm²</th><th scope=\"col\">worst<br>mm²</th>"
      "<th scope=\"col\">below<br>5 "
      "mm²</th><th scope=\"col\">length<br>mm</th><th scope=\"col\">angle<br>°</th><th "
      "scope=\"col\">Coap-<br>tation<br>mm</th>"
      "<th scope=\"col\">Tension<br>N</th></tr></thead><tbody>\n";
  for (const RankedPlan& plan : result.plans) html += rows_of(plan);
  return html +
         "</tbody></table></div>\n<p class=\"small\">Leak: the smallest area through which blood "
         "can flow back, as planned (± numerical error, where no other error is larger), then "
         "with small errors of suture length and papillary position around the plan; worst, and "
         "below 5 mm² (the fraction of these errors with a lower leak), are estimated. Margin: the "
         "smallest error with a leak above 1 mm² (0 if the plan "
         "itself leaks more); length: of a suture, or without one of the distance from tip to "
         "trigone. Coaptation: mean height over nine sections. Tension: highest in any chorda. "
         "Acceptable: leaks less "
         "than 5 mm² with a probability of at least 95 %, given the errors of execution, tissue "
         "and mesh, and complies with all rules of practice. Pareto: Pareto-optimal among the "
         "ranked plans in leak (mean + sd), opening and reserve. The leak is anatomic, not an "
         "effective "
         "regurgitant orifice area.</p>\n" +
         trade_offs(result) + "</section>\n";
}

}  // namespace coapt
