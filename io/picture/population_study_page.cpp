#include "io/picture/population_study_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/valve/number_text.h"
#include "io/picture/heat_map.h"
#include "io/picture/line_chart.h"
#include "io/picture/study_page.h"
#include "io/picture/text.h"
#include "io/picture/tree_picture.h"
#include "search/training/binomial.h"

namespace coapt {
namespace {

using StudyTable = std::vector<std::vector<std::string>>;
constexpr std::size_t kMostFactors = 6;  // of a quantity, in the table
constexpr double kLowPrediction = 0.5;   // Q2 below which Sobol's shares say little

std::string title_of(const GroupFindings& group) {
  if (!group.aetiology) return "all";
  switch (*group.aetiology) {
    case Aetiology::Ischaemic:
      return "ischaemic";
    case Aetiology::Dilated:
      return "dilated";
    case Aetiology::P2Flail:
      return "P2 flail";
    case Aetiology::Barlow:
      return "Barlow";
  }
  return "";
}

/// "12 % (8 to 17)".
std::string share_words(int count, int of) {
  if (of == 0) return "n/a";
  const auto [low, high] = share_interval(count, of);
  return percent(static_cast<double>(count) / of) + " (" + fixed(100.0 * low, 0) + " to " +
         fixed(100.0 * high, 0) + ")";
}

/// "-0.4 (-0.9 to 0.1)".
std::string mean_words(const MeanInterval& interval, int decimals = 1) {
  if (interval.count == 0) return "n/a";
  return fixed(interval.mean, decimals) + " (" + fixed(interval.low, decimals) + " to " +
         fixed(interval.high, decimals) + ")";
}

const std::string& repair_name(int candidate) {
  return candidate_repairs()[static_cast<std::size_t>(candidate)].name;
}

std::string wins_svg(const PopulationStudy& study) {
  HeatMap map;
  map.title = "Share of valves, %";
  for (int f = kRepairFamilies - 1; f >= 0; --f)
    map.row_ticks.emplace_back(to_string(static_cast<RepairFamily>(f)));
  for (const GroupFindings& group : study.groups) map.column_ticks.push_back(title_of(group));
  map.blocks = {"cheapest", "as good as the cheapest"};
  for (const bool as_good : {false, true}) {
    std::vector<std::vector<double>> rows;
    for (std::size_t f = kRepairFamilies; f-- > 0;) {
      rows.emplace_back();
      for (const GroupFindings& group : study.groups) {
        const FamilyWins& family = group.families[f];
        rows.back().push_back(
            family.offered == 0 ? std::numeric_limits<double>::quiet_NaN()
                                : 100.0 * (as_good ? family.as_good : family.wins) / group.members);
      }
    }
    map.values.push_back(std::move(rows));
  }
  constexpr double kHeight = 330.0;
  return figure_svg("Best repair",
                    draw_heat_map(map, {0.0, 100.0, 0}, {190.0, 50.0, 980.0, kHeight - 30.0}),
                    {kHeight});
}

std::string undersizing_svg(const PopulationStudy& study) {
  LineChart chart{
      "Effect of undersizing", "Annulus reduced in steps of 2 mm; bars: 95 % intervals.", {}, 2};
  constexpr std::array kHues = {Hue::Ink, Hue::Blue, Hue::Vermillion, Hue::Green, Hue::Purple};
  LinePanel share{{"Share of valves that leak at most 5 mm²", "sizes below", "%"}, {}};
  LinePanel leak{{"Mean leak", "sizes below", "mm²"}, {}};
  share.y_holds = {0.0, 100.0};
  leak.y_holds = {0.0, 1.0};
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const GroupFindings& group = study.groups[g];
    PanelSeries competent{title_of(group), {}, {}, kHues[g % kHues.size()]}, mean = competent;
    mean.label.clear();
    competent.shift_px = mean.shift_px = 4.0 * (static_cast<double>(g) - 2.0);
    for (const Undersizing& sizes : group.undersizing) {
      if (sizes.closed == 0) continue;
      const auto [low, high] = share_interval(sizes.competent, sizes.closed);
      competent.x.push_back(sizes.sizes_below);
      competent.y.push_back(100.0 * sizes.competent / sizes.closed);
      competent.low.push_back(100.0 * low);
      competent.high.push_back(100.0 * high);
      mean.x.push_back(sizes.sizes_below);
      mean.y.push_back(sizes.leak_mm2.mean);
      mean.low.push_back(sizes.leak_mm2.low);
      mean.high.push_back(sizes.leak_mm2.high);
    }
    share.series.push_back(std::move(competent));
    leak.series.push_back(std::move(mean));
  }
  chart.panels = {std::move(share), std::move(leak)};
  return line_chart_svg(chart);
}

StudyTable candidates_table(const GroupFindings& group) {
  std::vector<CandidateMeans> order = group.candidates;
  std::stable_sort(
      order.begin(), order.end(),
      [](const CandidateMeans& a, const CandidateMeans& b) { return a.cost < b.cost; });
  StudyTable rows = {{"repair", "mean cost", "closed", "refused", "cheapest of",
                      "leak at most 5 mm²", "mean leak, mm²"}};
  for (const CandidateMeans& means : order)
    rows.push_back({repair_name(means.candidate), fixed(means.cost, 1),
                    std::to_string(means.closed), std::to_string(means.refused),
                    std::to_string(means.wins), share_words(means.competent, means.closed),
                    mean_words(means.leak_mm2)});
  return rows;
}

StudyTable anchors_table(const PopulationStudy& study) {
  StudyTable rows = {{"aetiology", "muscles", "movement, mm", "ring", "valves",
                      "trigone leaks less", "the same", "trigone less saddle peak, mm²"}};
  for (const GroupFindings& group : study.groups) {
    if (!group.aetiology) continue;
    for (const AnchorComparison& anchor : group.anchors)
      rows.push_back(
          {title_of(group), anchor.both_muscles ? "both" : "posteromedial",
           shown(anchor.movement_mm), anchor.ring ? "yes" : "no", std::to_string(anchor.members),
           share_words(anchor.trigone_better, anchor.members),
           share_words(anchor.same, anchor.members), mean_words(anchor.difference_mm2, 2)});
  }
  return rows;
}

StudyTable decided_table(const PopulationStudy& study) {
  StudyTable rows = {{"aetiology", "of", "Q2", "factor", "total share", "effect, mm²"}};
  for (const GroupFindings& group : study.groups)
    for (const DecidedBy& decided : group.decided_by) {
      const std::vector<double>& total = decided.indices.total;
      if (total.empty() || !std::isfinite(decided.indices.predicted_share)) continue;
      std::vector<std::size_t> order(total.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return total[a] > total[b]; });
      const bool low = decided.indices.predicted_share < kLowPrediction;
      for (std::size_t k = 0; k < std::min(kMostFactors, order.size()); ++k)
        rows.push_back({title_of(group), decided.quantity,
                        fixed(decided.indices.predicted_share, 2) + (low ? " (low)" : ""),
                        decided.factors[order[k]], fixed(total[order[k]], 2),
                        fixed(decided.indices.effect[order[k]], 1)});
    }
  return rows;
}

StudyTable rules_table(const PopulationTree& tree) {
  StudyTable rows = {{"rule", "regret in cost", "regret in leak, mm²"}};
  rows.push_back({"the tree", mean_words(tree.of_tree.cost), mean_words(tree.of_tree.leak_mm2)});
  rows.push_back({"the best repair of each aetiology", mean_words(tree.of_aetiology.cost),
                  mean_words(tree.of_aetiology.leak_mm2)});
  rows.push_back({"one for all: " + repair_name(tree.single), mean_words(tree.of_single.cost),
                  mean_words(tree.of_single.leak_mm2)});
  return rows;
}

StudyTable searched_table(const PopulationStudy& study) {
  StudyTable rows = {{"valve", "search: plan", "cost", "leak, mm²", "tree: cost", "leak, mm²",
                      "best candidate: cost", "leak, mm²"}};
  for (const SearchedMember& member : study.searched)
    rows.push_back({std::to_string(member.index), member.plan, fixed(member.searched.cost, 1),
                    fixed(member.searched.mean_mm2, 1), fixed(capped_cost(member.chosen), 1),
                    fixed(member.chosen.mean_mm2, 1), fixed(capped_cost(member.best), 1),
                    fixed(member.best.mean_mm2, 1)});
  return rows;
}

}  // namespace

std::vector<std::string> study_sentences(const PopulationStudy& study) {
  std::vector<std::string> all;
  for (const GroupFindings& group : study.groups) {
    if (!group.aetiology) continue;
    const auto best =
        std::max_element(group.families.begin(), group.families.end(),
                         [](const FamilyWins& a, const FamilyWins& b) { return a.wins < b.wins; });
    all.push_back(title_of(group) + " (" + counted(group.members, "valve") +
                  "): cheapest most often: " + to_string(best->family) + ", " +
                  share_words(best->wins, group.members) + ".");
  }
  if (study.tree) {
    all.push_back("The tree costs " + mean_words(study.tree->of_tree.cost) +
                  " more than the best candidate of each held-out valve; the best repair of each "
                  "aetiology " +
                  mean_words(study.tree->of_aetiology.cost) + ", the best single one " +
                  mean_words(study.tree->of_single.cost) + ".");
  }
  if (!study.searched.empty()) {
    const SearchRegret regret = search_regret(study.searched);
    all.push_back("Compared with the full search on " +
                  counted(std::ssize(study.searched), "held-out valve") + ": the tree costs " +
                  mean_words(regret.tree_cost) + " more and leaves " +
                  mean_words(regret.tree_leak_mm2) + " mm² more.");
  }
  return all;
}

std::string population_study_page(const PopulationStudy& study, const std::string& lead) {
  std::string sentences;
  for (const std::string& sentence : study_sentences(study)) sentences += sentence + "\n\n";
  std::vector<PageSection> sections = {
      {"In short", sentences, "", {}},
      {"Best repair",
       "Repair with the lowest cost of the search (leak, its spread, effort), over " +
           counted(study.nodes, "closure") +
           " of each repair. As good: its cost is less than 1 mm² higher, the weight of "
           "one step.",
       wins_svg(study),
       {}},
      {"Effect of undersizing", "", undersizing_svg(study), {}},
      {"Trigone or saddle peak",
       "Leaks that differ by up to 0.25 mm² count as equal, because closures from different "
       "starting states differ by as much. Negative: the trigone leaks less.",
       "", anchors_table(study)}};
  if (study.tree) {
    sections.push_back(
        {"Decision tree",
         "Regret: cost of a rule in excess of the best candidate for each held-out valve; means "
         "with 95 % intervals. A repair that is not possible costs 1,000.",
         tree_svg(*study.tree), rules_table(*study.tree)});
  }
  if (!study.searched.empty())
    sections.push_back({"Comparison with the full search", "", "", searched_table(study)});
  StudyTable decided = decided_table(study);
  if (decided.size() == 1) decided = {{"too few valves"}};
  sections.push_back(
      {"Influential factors",
       "Total Sobol indices of the factors of the prior, each expressed by its quantile. "
       "Anatomical factors are correlated, and members are selected for being competent before and "
       "leaking after disease; the indices come from a polynomial fitted as if the factors were "
       "independent. Q2: fraction of variance predicted for held-out valves; below 0.5 (low) the "
       "indices are unreliable.",
       "", std::move(decided)});
  for (const GroupFindings& group : study.groups)
    if (group.aetiology)
      sections.push_back({"All repairs: " + title_of(group), "", "", candidates_table(group)});
  return study_page("Comparison of repairs across a population", lead, sections);
}

}  // namespace coapt
