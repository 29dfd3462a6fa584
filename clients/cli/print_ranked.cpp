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
#include "core/closed/diagnosis.h"
#include "core/valve/number_text.h"
#include "io/json/json.h"
#include "io/picture/model_study_page.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr std::size_t kColumns = 100;

std::string known(double number) { return std::isfinite(number) ? fixed(number, 1) : "-"; }
std::string known(const Json& value) { return known(number_of(value)); }

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

double number_in(const Json& plan, const char* key) {
  const auto found = plan.find(key);  // results of earlier releases have fewer
  return found == plan.end() ? std::numeric_limits<double>::quiet_NaN() : number_of(*found);
}

/// In so many of its units, to the digits that are known.
std::string known_estimate(const Json& plan, const char* name, double units = 1.0) {
  const double value = number_in(plan, name);
  if (!std::isfinite(value)) return "-";
  const Json estimate = plan.value("estimates", Json::object()).value(name, Json::object());
  return known_tenths(units * value, units * half_width(estimate_of(estimate, value)));
}

/// What a cardiologist would call what is left: by mean + sd over the region, or as planned where that was not closed.
std::string leak_words(const Json& plan) {
  const Json& leak = plan["leak_mm2"];
  const double over_region = number_of(leak["mean"]) + number_of(leak["sd"]);
  const double left = std::isfinite(over_region) ? over_region : number_of(leak["nominal"]);
  if (!std::isfinite(left)) return "unknown";
  if (left < kTraceLeak_mm2) return "none or trace";
  return left < kMildLeak_mm2 ? "mild" : fixed(left, 0) + " mm2";
}

/// Else nothing is known of errors of execution.
bool is_varied(const Json& plan) { return plan["region_closures"] > 1; }

int muscles_sutured(const Json& plan) {
  const Json& steps = plan["plan"]["steps"];
  return static_cast<int>(std::count_if(steps.begin(), steps.end(), [](const Json& step) {
    return step["step"] == "papillary_approximation";
  }));
}

void print_header(std::ostream& out) {
  out << "rank  residual leak  < 5 mm2 reserve opening  gradient  steps   muscles   sizes\n"
      << "                                 mm     cm2      mmHg           sutured   below\n";
}

void print_row(std::ostream& out, const Json& plan) {
  const double likely = is_varied(plan) ? number_in(plan, "acceptable_probability")
                                        : std::numeric_limits<double>::quiet_NaN();
  out << std::setw(4) << plan["rank"].get<int>() << "  " << std::left << std::setw(14)
      << leak_words(plan) << std::right << std::setw(8)
      << (std::isfinite(likely) ? probability_text(likely) : "-") << std::setw(8)
      << known_estimate(plan, "durability_mm") << std::setw(8)
      << known_estimate(plan, "opening_area_mm2", 0.01) << std::setw(10)
      << known_estimate(plan, "gradient_mmhg") << std::setw(7) << plan["plan"]["steps"].size()
      << std::setw(10) << muscles_sutured(plan) << std::setw(8) << known(plan["ring_sizes_below"])
      << (plan["pareto"].get<bool>() ? "  *\n" : "\n");
}

/// As the table's columns call what beaten_by names.
std::string column_of(const std::string& objective) {
  if (objective == "durability") return "reserve";
  return objective == "operation" ? "effort" : objective;
}

void print_beaten(std::ostream& out, const Json& plan) {
  const auto beaten = plan.find("beaten_by");
  if (beaten == plan.end() || beaten->is_null()) return;  // not of earlier releases
  std::string words;
  for (const std::string objective : (*beaten)["in"])
    words += (words.empty() ? "" : " and ") + column_of(objective);
  print_words(out, "      ",
              "plan " + std::to_string((*beaten)["rank"].get<int>()) +
                  " is at least as good in leak, opening and reserve, and better in " + words);
}

/// Whether the finer mesh gave it another place.
bool changed_place(const Json& plan) {
  const Json& fine = plan["fine"];
  return !fine.is_null() && !fine["own_mesh_rank"].is_null() &&
         fine["own_mesh_rank"] != plan["rank"];
}

/// Where the finer mesh says otherwise.
void print_fine(std::ostream& out, const Json& plan) {
  const Json& fine = plan["fine"];
  if (fine.is_null()) return;
  const bool closes = fine["status"] == "converged" && !fine["crossing"].get<bool>() &&
                      number_of(fine["leak_mm2"]) < kTraceLeak_mm2;
  if (closes && !changed_place(plan)) return;
  std::string words =
      "on " + grouped(fine["triangles"]) + " triangles: leak " +
      with_error(number_of(fine["leak_mm2"]), number_of(fine["leak_mm2_error"]), "mm2");
  if (fine["status"] != "converged" || fine["crossing"].get<bool>())
    words += ", " + fine["status"].get<std::string>() + ", " + crossing_words(fine);
  if (changed_place(plan))
    words += "; on the valve's own mesh the plan ranks " +
             std::to_string(fine["own_mesh_rank"].get<int>());
  print_words(out, "      ", words);
}

void print_model_draws(std::ostream& out, const Json& result) {
  const auto model = result.find("model_draws");
  if (model == result.end() || (*model)["before"].is_null()) return;
  print_words(
      out, "Model: ",
      counted((*model)["draws"].get<long>(), "variant") +
          (model->value("fit_drawn", false)
               ? " of tissue and of the parameters that the fit left uncertain"
           : model->value("chordae_drawn", false) ? " of tissue and of chordae that were not imaged"
                                                  : " of tissue and chordae") +
          ", common to all plans" +
          (result["plans"].empty() ? "" : "; the probability of a leak below 5 mm2 includes them"));
  if (model->value("observed", Json::array()).empty()) return;
  const bool contradicts = (*model)["contradicts_model"].get<bool>();
  const char* const who =
      contradicts ? "it "
                  : "the variants are weighted by their agreement with the observations; they ";
  print_words(out, "Observed: ", who + weight_words(contradicts, number_of((*model)["effective"])));
}

/// What the finer mesh was for, and whether it would order the plans otherwise.
void print_fine_mesh(std::ostream& out, const Json& result) {
  const auto mesh = result.find("fine_mesh");
  if (mesh == result.end() || (*mesh)["levels"] == 0) return;
  const Json& plans = result["plans"];
  const std::string leak = grouped((*mesh)["triangles"]) + " triangles, unrepaired leak " +
                           known((*mesh)["leak_before_mm2"]) + " mm2";
  if (plans.empty()) return print_words(out, "Finer mesh: ", leak);
  const bool complete = std::none_of(plans.begin(), plans.end(),
                                     [](const Json& plan) { return plan["fine"].is_null(); });
  const bool changed = std::any_of(plans.begin(), plans.end(), changed_place);
  print_words(
      out, "Finer mesh: ",
      leak + "; " +
          (!complete ? "it does not affect the ranking, because not all plans were closed on it"
           : changed ? "it changes the ranking, as noted with each plan"
                     : "it does not change the ranking"));
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

/// How far each step of the first plan may be off, each alone.
void print_tolerance(std::ostream& out, const Json& plan) {
  const Json curves = plan.value("tolerance", Json::array());  // not of earlier releases
  std::string words;
  for (const Json& curve : curves) {
    std::string error = curve["error"];
    std::replace(error.begin(), error.end(), '_', ' ');
    words += (words.empty() ? "" : ", ") + error + ' ' +
             (curve["leaks_beyond"].get<bool>() ? "" : "at least ") +
             fixed(number_of(curve["margin_mm"]), 1) + " mm";
  }
  if (!words.empty())
    print_words(out, "      ",
                "error of one step until it leaks " + shown(kTraceLeak_mm2) + " mm2: " + words);
}

void print_plan(std::ostream& out, const Json& plan) {
  print_row(out, plan);
  if (plan.contains("name")) print_words(out, "      ", plan["name"].get<std::string>() + ":");
  for (const std::string step : plan["description"]) print_words(out, "      ", step);
  if (plan["plan"]["steps"].empty()) out << "      no repair\n";
  if (const auto leak = plan.find("leak"); leak != plan.end())  // not of earlier releases
    print_words(out, "      ", "leak as planned: " + leak_and_error(*leak));
  print_tolerance(out, plan);
  print_beaten(out, plan);
  print_fine(out, plan);
  if (plan["status"] != "converged" || plan["crossing"].get<bool>())
    out << "      ! " << plan["status"].get<std::string>() << ", " << crossing_words(plan) << '\n';
  print_warnings(out, plan);
  if (const auto preferred = plan.find("preferred_over_next");
      preferred != plan.end() && !preferred->is_null())
    out << "      probability that an expert with these weights prefers it to the next: "
        << percent(*preferred) << '\n';
}

/// What is not among the plans, and why.
void print_cut(std::ostream& out, const Json& result) {
  for (const Json& cut : result["cut"])
    print_words(out, "Not considered: ",
                cut["what"].get<std::string>() + ": " + cut["why"].get<std::string>());
}

}  // namespace

void print_ranked(std::ostream& out, const Json& result) {
  const Json &before = result["before"], &coaptation = before["coaptation"];
  const Json& plans = result["plans"];
  print_words(out, "Before: ",
              "leak " + leak_and_error(before["leak"]) + ", coaptation " +
                  fixed(number_of(coaptation["height_mean_mm"]), 1) + " mm, " +
                  before["status"].get<std::string>() + ", " + crossing_words(before));
  if (const auto diagnosis = result.find("diagnosis");
      diagnosis != result.end() && !diagnosis->is_null())
    print_words(out, "Diagnosis: ", (*diagnosis)["sentence"].get<std::string>());
  out << '\n';
  if (plans.empty()) {
    out << (result["stop"] == "exhausted"
                ? "No plan: the indicated techniques were not considered, see below.\n"
                : "no plan yet\n");
  } else {
    if (const std::string verdict = result.value("verdict", ""); !verdict.empty())  // from 0.3 on
      print_words(out, "", verdict);
    out << '\n';
    print_header(out);
  }
  for (const Json& plan : plans) print_plan(out, plan);
  if (std::any_of(plans.begin(), plans.end(),
                  [](const Json& plan) { return plan["pareto"].get<bool>(); }))
    print_words(out, "* ",
                "Pareto-optimal among the ranked plans in leak (mean + sd), opening and reserve");
  out << '\n';
  print_fine_mesh(out, result);
  print_model_draws(out, result);
  print_cut(out, result);
  out << counted(result["closures"].get<long>(), "closure") << " ("
      << result["closures_not_converged"] << " not converged, " << result["closures_crossed"]
      << " crossed";
  if (result["closures_known"] > 0)
    out << ", " << result["closures_known"] << " reused from an earlier run";
  out << ") in " << fixed(number_of(result["seconds"]), 1) << " s\n";
}

}  // namespace coapt
