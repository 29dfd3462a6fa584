#include "clients/cli/print_ranked.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "clients/cli/print.h"
#include "io/json/json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kColumns = 100;
constexpr double kFarthest_mm = 1.0, kFarthest_deg = 5.0;  // borders of the region: see LeakMargin

std::string known(const Json& value, int decimals = 1) {
  const double number = number_of(value);
  return std::isfinite(number) ? fixed(number, decimals) : "-";
}

std::string margin(const Json& value, double farthest, int decimals) {
  return (number_of(value) >= farthest ? ">" : "") + known(value, decimals);
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
  out << "                   leak over the region, mm2         margin to leak\n"
      << "rank     leak    mean    sd   p95  worst  <5 mm2      mm   deg"
      << "  coaptation  tension\n"
      << "          mm2" << std::string(49, ' ') << "          mm        N\n";
}

void print_row(std::ostream& out, const Json& plan) {
  const Json &leak = plan["leak_mm2"], &to_leak = plan["margin_to_leak"];
  const Json &measure = plan["measure"], &coaptation = measure["coaptation"];
  const double below = number_of(leak["below_5"]);
  out << std::setw(4) << plan["rank"].get<int>() << std::setw(9) << known(measure["leak_mm2"])
      << std::setw(8) << known(leak["mean"]) << std::setw(6) << known(leak["sd"]) << std::setw(6)
      << known(leak["p95"]) << std::setw(7) << known(leak["worst"]) << std::setw(8)
      << (std::isfinite(below) ? percent(below) : "-") << std::setw(8)
      << margin(to_leak["suture_length_mm"], kFarthest_mm, 2) << std::setw(6)
      << margin(to_leak["angle_deg"], kFarthest_deg, 1) << std::setw(12)
      << known(coaptation["height_mean_mm"]) << std::setw(9) << known(measure["tension_max_n"], 2)
      << (plan["pareto"].get<bool>() ? "  *\n" : "\n");
}

/// Whether the finer mesh gave it another place.
bool changed_place(const Json& plan) {
  const Json& fine = plan["fine"];
  return !fine.is_null() && !fine["own_mesh_rank"].is_null() &&
         fine["own_mesh_rank"] != plan["rank"];
}

void print_fine(std::ostream& out, const Json& plan) {
  const Json& fine = plan["fine"];
  if (fine.is_null()) return;
  std::string words =
      "on " + grouped(fine["triangles"]) + " triangles: leak " +
      with_error(number_of(fine["leak_mm2"]), number_of(fine["leak_mm2_error"]), "mm2");
  if (fine["status"] != "converged" || fine["crossing"].get<bool>())
    words += ", " + fine["status"].get<std::string>() + ", " + crossing_words(fine);
  if (changed_place(plan))
    words += "; by its own mesh it would rank " + std::to_string(fine["own_mesh_rank"].get<int>());
  print_words(out, "      ", words);
}

/// "opens to 3.1 cm2, mean gradient 2.0 mmHg; bears 4.2 mm of further disease (25 % of courses all 12 mm)"
void print_outlook(std::ostream& out, const Json& plan) {
  const auto number = [&](const char* key) {
    const auto found = plan.find(key);  // a result of release 0.1 has none
    return found == plan.end() ? std::numeric_limits<double>::quiet_NaN() : number_of(*found);
  };
  const double area = number("opening_area_mm2");
  std::string words;
  if (std::isfinite(area))
    words = "opens to " + fixed(0.01 * area, 1) + " cm2, mean gradient " +
            fixed(number("gradient_mmhg"), 1) + " mmHg at rest";
  if (const double lasts = number("durability_mm"); std::isfinite(lasts))
    words += (words.empty() ? "bears " : "; bears ") + fixed(lasts, 1) +
             " mm of further disease before it leaks 5 mm2 (" + percent(number("outlasting")) +
             " of courses all 12 mm)";
  if (!words.empty()) print_words(out, "      ", words);
}

void print_model_draws(std::ostream& out, const Json& result) {
  const auto model = result.find("model_draws");
  if (model == result.end() || (*model)["before"].is_null()) return;
  const Json& leak = (*model)["before"]["leak_mm2"];
  print_words(
      out, "Model: ",
      counted((*model)["draws"].get<long>(), "draw") +
          (model->value("fit_drawn", false)       ? " of tissue and of what the fit left uncertain"
           : model->value("chordae_drawn", false) ? " of tissue and of chordae that were not seen"
                                                  : " of tissue and chordae") +
          ", the same for all plans; unrepaired leak " + known(leak["mean"]) + " ± " +
          known(leak["sd"]) + " mm2" +
          (result["plans"].empty() ? "" : ". A rank that does not hold in them is called a tie"));
}

/// What the finer mesh was for, and whether it would order the plans otherwise.
void print_fine_mesh(std::ostream& out, const Json& result) {
  const auto mesh = result.find("fine_mesh");
  if (mesh == result.end() || (*mesh)["levels"] == 0) return;
  const Json& plans = result["plans"];
  const bool complete = std::none_of(plans.begin(), plans.end(),
                                     [](const Json& plan) { return plan["fine"].is_null(); });
  const bool changed = std::any_of(plans.begin(), plans.end(), changed_place);
  print_words(out, "Finer mesh: ",
              grouped((*mesh)["triangles"]) + " triangles, unrepaired leak " +
                  known((*mesh)["leak_before_mm2"]) + " mm2; " +
                  (!complete ? "not all plans were closed on it, so it does not order them"
                   : changed ? "it changes the order of these plans, see there"
                             : "it leaves the order of these plans as it is"));
}

/// What the model's own error makes of the leak as planned.
void print_draws(std::ostream& out, const Json& plan) {
  const auto drawn = plan.find("under_draws");
  if (drawn == plan.end() || drawn->is_null()) return;
  const Json& leak = (*drawn)["leak_mm2"];
  std::string words = "leak " + known(plan["leak_mm2"]["nominal"]) + " mm2 as planned: model ± " +
                      known(leak["sd"]) + " (mean " + known(leak["mean"]) + ", worst " +
                      known(leak["worst"]);
  if (const int failures = (*drawn)["failures"]; failures > 0)
    words += "; " + counted(failures, "draw") + " failed";
  print_words(out, "      ", words + ")");
}

/// How many of a sample end elsewhere from a cold start.
void print_cold_starts(std::ostream& out, const Json& plan) {
  const auto starts = plan.find("cold_starts");
  if (starts == plan.end() || starts->is_null() || (*starts)["closures"] == 0) return;
  const int closures = (*starts)["closures"], elsewhere = (*starts)["elsewhere"];
  print_words(out, "      ",
              "closed from the open state, " + std::to_string(elsewhere) + " of " +
                  std::to_string(closures) +
                  " closures of the region end elsewhere; leaks differ by " +
                  known((*starts)["leak_difference_max_mm2"], 2) + " mm2 at most");
}

/// Why the order of a plan and the next is open.
std::string tie_words(const Json& plan) {
  const double likely = number_of(plan["probability_outranks_next"]);
  const double ahead = number_of(plan.value("share_of_draws_ahead", Json()));
  std::string words = std::isfinite(likely) ? percent(likely) + " likely ahead" : "";
  if (std::isfinite(ahead))
    words += (words.empty() ? "" : ", ") + ("ahead in " + percent(ahead)) + " of the model's draws";
  return words;
}

/// What gates say against a plan, then what else is to be warned of.
void print_warnings(std::ostream& out, const Json& plan) {
  std::vector<std::string> said;
  for (const Json& gate : plan["gates"]) {
    const bool rejected = gate["severity"] == "reject";
    if (!rejected && gate["severity"] != "warn") continue;
    said.push_back(gate["finding"]);
    print_words(out, "      ! ", (rejected ? "rejected: " : "") + said.back());
  }
  for (const std::string warning : plan["warnings"])
    if (std::find(said.begin(), said.end(), warning) == said.end())
      print_words(out, "      ! ", warning);
}

void print_plan(std::ostream& out, const Json& plan) {
  print_row(out, plan);
  if (plan.contains("name")) print_words(out, "      ", plan["name"].get<std::string>() + ":");
  for (const std::string step : plan["description"]) print_words(out, "      ", step);
  if (plan["plan"]["steps"].empty()) out << "      no repair\n";
  print_outlook(out, plan);
  print_fine(out, plan);
  print_draws(out, plan);
  print_cold_starts(out, plan);
  if (plan["status"] != "converged" || plan["crossing"].get<bool>())
    out << "      ! " << plan["status"].get<std::string>() << ", " << crossing_words(plan) << '\n';
  print_warnings(out, plan);
  if (plan["tie_with_next"].get<bool>())
    out << "      ties with the next: " << tie_words(plan) << '\n';
  if (const auto preferred = plan.find("preferred_over_next");
      preferred != plan.end() && !preferred->is_null())
    out << "      preferred to the next by an expert of these weights: " << percent(*preferred)
        << '\n';
}

std::string ladder_words(const Json& ladder) {
  std::string words;
  for (const Json& step : ladder) {
    const int from = step["from"];
    const double spearman = number_of(step["spearman"]);
    words += (words.empty() ? "" : "; ") + (from == 0 ? "geometry" : grouped(from)) + " to " +
             grouped(step["to"]) + ": ";
    words += std::isfinite(spearman)
                 ? fixed(spearman, 2) + " over " + counted(step["plans"], "plan")
                 : "not measured";
    if (step["skipped"].get<bool>()) words += ", not trusted";
  }
  return words;
}

void print_search(std::ostream& out, const Json& result) {
  if (!result["ladder"].empty())
    print_words(out, "Ladder: ",
                "Spearman's correlation of costs from few closures a plan with those from more: " +
                    ladder_words(result["ladder"]));
  if (result["branches"] > 0)
    out << "Branches: " << result["branches"] << ", with " << grouped(result["plans_possible"])
        << " possible plans, of which " << grouped(result["plans_tried"]) << " tried\n";
  for (const Json& cut : result["cut"])
    print_words(
        out, "  left out: ", cut["what"].get<std::string>() + ": " + cut["why"].get<std::string>());
}

}  // namespace

void print_ranked(std::ostream& out, const Json& result) {
  const Json &before = result["before"], &coaptation = before["coaptation"];
  const Json& plans = result["plans"];
  print_words(out, "Before: ",
              "leak " +
                  with_error(number_of(before["leak"]["area_mm2"]),
                             number_of(before["leak"]["error_mm2"]), "mm2") +
                  ", coaptation " + fixed(number_of(coaptation["height_mean_mm"]), 1) + " mm, " +
                  before["status"].get<std::string>() + ", " + crossing_words(before));
  out << '\n';
  if (plans.empty()) {
    out << "no plan yet\n";
  } else {
    if (!result["any_competent"].get<bool>())
      out << "No plan closes this valve robustly; the ranking starts with the least bad.\n\n";
    print_header(out);
  }
  for (const Json& plan : plans) print_plan(out, plan);
  if (std::any_of(plans.begin(), plans.end(),
                  [](const Json& plan) { return plan["pareto"].get<bool>(); }))
    print_words(
        out, "* ",
        "Pareto-optimal among the ranked plans in leak (mean + sd), opening and durability");
  out << '\n';
  print_fine_mesh(out, result);
  print_model_draws(out, result);
  print_search(out, result);
  out << result["closures"] << " closures (" << result["closures_not_converged"]
      << " not converged, " << result["closures_crossed"] << " crossed";
  if (result["closures_known"] > 0)
    out << ", " << result["closures_known"] << " known from an earlier run";
  out << ") in " << fixed(number_of(result["seconds"]), 1) << " s\n";
}

}  // namespace coapt
