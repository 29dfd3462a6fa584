#include <algorithm>
#include <cmath>

#include "core/valve/counted.h"
#include "io/picture/chart.h"
#include "io/picture/html.h"
#include "io/picture/report_parts.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

// Costs above so many times the best are left out of the chart: they would flatten the rest.
constexpr double kShownTimes = 12.0, kShownAtLeast = 20.0;

std::string stop_sentence(SearchStop stop, bool any_possible) {
  switch (stop) {
    case SearchStop::EvaluationLimit:
      return "The search used all its closures.";
    case SearchStop::Exhausted:
      return any_possible ? "No plan was left to try; all others were ruled out by a bound on "
                            "their cost or by their expected cost."
                          : "Rules and diagnosis left no plan to try.";
    case SearchStop::NoImprovement:
      return "The search found no better plan within the given number of closures.";
    case SearchStop::TargetReached:
      return "A plan reached the target.";
    case SearchStop::TimeLimit:
      return "The search reached its time limit.";
    case SearchStop::Cancelled:
      return "The search was cancelled; this is the best plan so far.";
  }
  return "";
}

/// In steps: the best stays the best until there is a better one; up to `end` closures.
Series staircase(const std::vector<Progress>& progress, double most, int end) {
  Series series{"best plan so far", {}, {}};
  for (const Progress& at : progress) {
    if (!(at.cost <= most)) continue;
    if (!series.y.empty()) {
      series.x.push_back(at.closures);
      series.y.push_back(series.y.back());
    }
    series.x.push_back(at.closures);
    series.y.push_back(at.cost);
  }
  if (!series.y.empty() && end > series.x.back()) {
    series.x.push_back(end);
    series.y.push_back(series.y.back());
  }
  return series;
}

std::string progress_chart(const SearchResult& result) {
  if (result.progress.empty()) return "";
  const double most = std::max(kShownAtLeast, kShownTimes * result.progress.back().cost);
  const int end = std::max(result.evaluations, result.progress.back().closures);
  Chart chart{"Cost of the best plan so far",
              "closures of the search",
              "cost (lower is better)",
              {staircase(result.progress, most, end)},
              true};
  Series random{"random search, expected", {}, {}, true, true};
  for (const Progress& at : result.random_progress)
    if (at.cost <= most) {
      random.x.push_back(at.closures);
      random.y.push_back(at.cost);
    }
  if (!random.x.empty()) chart.series.push_back(std::move(random));
  return "<div class=\"narrow\">" +
         chart_html(chart_svg(chart), "Each plan is closed once; lower is better. Costs above " +
                                          fixed(most, 0) + " are not shown.") +
         "</div>\n";
}

/// Else plans that were given were scored.
bool is_search(const SearchResult& result) { return result.branches > 0 || result.plans.empty(); }

std::string counts(const SearchResult& result) {
  std::string words = grouped(result.closures) + ' ' + noun_of(result.closures, "closure") +
                      (std::isnan(result.seconds) ? "" : " in " + fixed(result.seconds, 1) + " s") +
                      ", including ranking; " + grouped(result.closures_not_converged) +
                      " did not converge, " + grouped(result.closures_crossed) + " crossed";
  if (result.closures_known > 0)
    words += ", " + grouped(result.closures_known) + " were reused from an earlier run";
  words += ". ";
  if (is_search(result))
    words += grouped(result.plans_tried) + ' ' + noun_of(result.plans_tried, "plan") +
             " tried of " + grouped(result.plans_possible) + " possible ones. ";
  words += is_search(result) ? stop_sentence(result.stop, result.plans_possible > 0)
                             : "The given plans were scored as a search scores its finalists.";
  return "<p>" + escape_html(words) + "</p>\n";
}

std::string cut_table(const std::vector<CutBranches>& cut) {
  if (cut.empty()) return "";
  std::vector<std::vector<std::string>> cells = {{"Not considered", "Why"}};
  for (const CutBranches& branches : cut) cells.push_back({branches.what, branches.why});
  return "<h3>Techniques not considered</h3>\n" + table_html(cells);
}

}  // namespace

std::string information_section(const SearchResult& result) {
  if (result.information.empty()) return "";
  std::vector<std::vector<std::string>> cells = {
      {"Measurement", "Variance removed", "Remaining sd, mm²"}};
  for (const InformationRow& row : result.information) {
    const bool known = std::isfinite(row.share_removed);
    cells.push_back({row.measurement, known ? percent(row.share_removed) : "n/a",
                     known ? fixed(row.remaining_mm2, 1) : "n/a"});
  }
  return "<section id=\"information\"><h2>What would say more</h2>\n<p>How much a measurement of "
         "the unrepaired valve, with the error stated, would reduce the tissue error of the leak "
         "that the first plan leaves, of " +
         counted(result.model_draws, "variant") + " of tissue and chordae.</p>\n" +
         table_html(cells) + "</section>\n";
}

std::string search_section(const SearchResult& result) {
  if (!is_search(result))
    return "<section id=\"search\"><h2>How the plans were scored</h2>\n" + counts(result) +
           "</section>\n";
  return "<section id=\"search\"><h2>How the search went</h2>\n" + counts(result) +
         progress_chart(result) + cut_table(result.cut) + "</section>\n";
}

}  // namespace coapt
