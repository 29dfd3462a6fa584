#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "clients/cli/print.h"
#include "io/json/plans_json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kColumns = 100;
constexpr double kFarthest_mm = 1.0, kFarthest_deg = 5.0;  // borders of the region: see LeakMargin

const char* crossing_words(bool crossing) { return crossing ? "leaflets cross" : "no crossing"; }

std::string known(double value, int decimals = 1) {
  return std::isfinite(value) ? fixed(value, decimals) : "-";
}

std::string margin(double value, double farthest, int decimals) {
  return (value >= farthest ? ">" : "") + known(value, decimals);
}

/// `mark` stands before the first line; later ones stand below its text.
void print_words(std::ostream& out, const std::string& mark, const std::string& text) {
  std::istringstream words(printable(text));
  std::string line = mark;
  bool empty = true;
  for (std::string word; words >> word;) {
    if (!empty && line.size() + 1 + word.size() > kColumns) {
      out << line << '\n';
      line = std::string(mark.size(), ' ');
      empty = true;
    }
    line += (empty ? "" : " ") + word;
    empty = false;
  }
  out << line << '\n';
}

void print_header(std::ostream& out) {
  out << "                          leak over the region, mm2         margin to leak\n"
      << "rank  orifice    gap    mean    sd   p95  worst  <5 mm2      mm   deg"
      << "  coaptation  tension\n"
      << "          mm2    mm2" << std::string(49, ' ') << "          mm        N\n";
}

void print_row(std::ostream& out, const RankedPlan& plan) {
  const OrificeStatistics& leak = plan.region.leak_mm2;
  const LeakMargin& to_leak = plan.region.margin_to_leak;
  const double below = leak.below_5;
  out << std::setw(4) << plan.rank << std::setw(9) << known(plan.measure.orifice.area_mm2)
      << std::setw(7) << known(plan.measure.coaptation.gap_area_mm2) << std::setw(8)
      << known(leak.mean) << std::setw(6) << known(leak.sd) << std::setw(6) << known(leak.p95)
      << std::setw(7) << known(leak.worst) << std::setw(8)
      << (std::isfinite(below) ? percent(below) : "-") << std::setw(8)
      << margin(to_leak.suture_length_mm, kFarthest_mm, 2) << std::setw(6)
      << margin(to_leak.angle_deg, kFarthest_deg, 1) << std::setw(12)
      << known(plan.measure.coaptation.height_mean_mm) << std::setw(9)
      << known(plan.measure.tension_max_n, 2) << (plan.pareto ? "  *\n" : "\n");
}

void print_plan(std::ostream& out, const RankedPlan& plan) {
  print_row(out, plan);
  if (!plan.name.empty()) print_words(out, "      ", plan.name + ":");
  for (const std::string& step : plan.description) print_words(out, "      ", step);
  if (plan.plan.steps.empty()) out << "      no repair\n";
  if (plan.status != ClosureStatus::Converged || plan.crossing)
    out << "      ! " << to_string(plan.status) << ", " << crossing_words(plan.crossing) << '\n';
  for (const Gate& gate : plan.gates)
    if (gate.severity == GateSeverity::Warn || gate.severity == GateSeverity::Reject)
      print_words(out, "      ! ",
                  (gate.severity == GateSeverity::Reject ? "rejected: " : "") + gate.finding);
  const std::vector<std::string> said = warnings_of(plan.gates);
  for (const std::string& warning : plan.warnings)
    if (std::find(said.begin(), said.end(), warning) == said.end())
      print_words(out, "      ! ", warning);
  if (ties_with_next(plan))
    out << "      ties with the next: " << percent(plan.probability_outranks_next)
        << " likely ahead\n";
}

std::string ladder_words(const std::vector<LadderStep>& ladder) {
  std::string words;
  for (const LadderStep& step : ladder) {
    words += (words.empty() ? "" : "; ") + (step.from == 0 ? "geometry" : grouped(step.from)) +
             " to " + grouped(step.to) + ": ";
    words += std::isfinite(step.spearman)
                 ? fixed(step.spearman, 2) + " over " + counted(step.plans, "plan")
                 : "not measured";
    if (step.skipped) words += ", not trusted";
  }
  return words;
}

void print_search(std::ostream& out, const SearchResult& result) {
  if (!result.ladder.empty())
    print_words(out, "Ladder: ",
                "Spearman's correlation of costs from few closures a plan with those from more: " +
                    ladder_words(result.ladder));
  if (result.branches > 0)
    out << "Branches: " << result.branches << ", with " << grouped(result.plans_possible)
        << " possible plans, of which " << grouped(result.plans_tried) << " tried\n";
  for (const CutBranches& cut : result.cut)
    print_words(out, "  left out: ", cut.what + ": " + cut.why);
}

}  // namespace

void print_ranked(std::ostream& out, const SearchResult& result) {
  const ValveMeasure& before = result.before.measure;
  print_words(out, "Before: ",
              "orifice " + fixed(before.orifice.area_mm2, 1) + " mm2, gap between the leaflets " +
                  fixed(before.coaptation.gap_area_mm2, 1) + " mm2, coaptation " +
                  fixed(before.coaptation.height_mean_mm, 1) + " mm, " +
                  to_string(result.before.status) + ", " + crossing_words(result.before.crossing));
  out << '\n';
  if (result.plans.empty()) {
    out << "no plan yet\n";
  } else {
    if (!result.any_competent) out << "No plan closes this valve robustly; ranked least bad.\n\n";
    print_header(out);
  }
  for (const RankedPlan& plan : result.plans) print_plan(out, plan);
  if (std::any_of(result.plans.begin(), result.plans.end(),
                  [](const RankedPlan& plan) { return plan.pareto; }))
    print_words(out, "* ",
                "no other ranked plan is as good in mean, sd, steps and undersizing, and better "
                "in one");
  out << '\n';
  print_search(out, result);
  out << result.closures << " closures (" << result.closures_not_converged << " not converged, "
      << result.closures_crossed << " crossed";
  if (result.closures_known > 0)
    out << ", " << result.closures_known << " known from an earlier run";
  out << ") in " << fixed(result.seconds, 1) << " s\n";
}

}  // namespace coapt
