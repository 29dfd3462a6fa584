#include "clients/cli/print_ranked.h"

#include <algorithm>
#include <array>
#include <cmath>
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
#include "io/picture/text_table.h"
#include "search/plans/plan_row.h"

namespace coapt {
namespace {

constexpr std::size_t kColumns = 100;

std::string known(const Json& value) {
  const double number = number_of(value);
  return std::isfinite(number) ? fixed(number, 1) : "-";
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

/// The rows of the table; `shared` gets the cells that all plans share.
std::vector<PlanRow> rows_of(const Json& plans, PlanRow& shared) {
  std::vector<PlanRow> rows;
  for (const Json& plan : plans) {
    const Json row = plan.value("row", Json::object());  // not of earlier releases
    rows.push_back({row.value("leak", "-"), row.value("reserve", "-"), row.value("opening", "-"),
                    row.value("effort", "-")});
  }
  shared = take_shared(rows);
  return rows;
}

/// Marked where a rule of practice rejects the plan.
std::vector<std::string> warnings_of(const Json& plan) {
  std::vector<std::string> warnings;
  for (const std::string warning : plan["warnings"]) {
    const bool rejects =
        std::any_of(plan["gates"].begin(), plan["gates"].end(), [&](const Json& gate) {
          return gate["severity"] == "reject" && gate["finding"] == warning;
        });
    warnings.push_back((rejects ? "rejected: " : "") + warning);
  }
  return warnings;
}

std::vector<std::string> shared_warnings(const Json& plans) {
  std::vector<std::string> shared;
  if (plans.size() < 2) return shared;
  shared = warnings_of(plans[0]);
  for (const Json& plan : plans) {
    const std::vector<std::string> own = warnings_of(plan);
    std::erase_if(shared, [&](const std::string& warning) {
      return std::find(own.begin(), own.end(), warning) == own.end();
    });
  }
  return shared;
}

void print_shared(std::ostream& out, const PlanRow& shared,
                  const std::vector<std::string>& warnings) {
  const std::string words = words_of(shared);
  if (words.empty() && warnings.empty()) return;
  print_words(out, "All plans: ", words);
  for (const std::string& warning : warnings) print_words(out, "      ! ", warning);
  out << '\n';
}

/// Lines of the table, the head first, each without the cells that all plans share.
std::vector<std::string> table_lines(const Json& plans, const std::vector<PlanRow>& rows,
                                     const PlanRow& shared) {
  std::vector<std::string> lines = {"rank"};
  for (const Json& plan : plans) {
    const std::string rank = std::to_string(plan["rank"].get<int>());
    lines.push_back(std::string(lines[0].size() - rank.size(), ' ') + rank);
  }
  for (const auto& [name, cell] : kPlanColumns) {
    if (!(shared.*cell).empty()) continue;
    std::vector<std::string> cells = {name};
    for (const PlanRow& row : rows) cells.push_back(row.*cell);
    int width = 0;
    for (const std::string& one : cells) width = std::max(width, width_of(one));
    for (std::size_t line = 0; line < lines.size(); ++line)
      lines[line] += "  " + cells[line] +
                     std::string(static_cast<std::size_t>(width - width_of(cells[line])), ' ');
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

void print_beaten(std::ostream& out, const Json& plan) {
  const auto beaten = plan.find("beaten_by");
  if (beaten == plan.end() || beaten->is_null()) return;  // not of earlier releases
  std::string words;
  for (const std::string objective : (*beaten)["in"])
    words += (words.empty() ? "" : " and ") + objective;
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
      variants_words(*model) + ", common to all plans" +
          (result["plans"].empty() ? "" : "; the probability of a leak below 5 mm2 includes them"));
  if (model->value("observed", Json::array()).empty()) return;
  const bool contradicts = (*model)["contradicts_model"].get<bool>();
  const char* const who =
      contradicts ? "the observation "
                  : "the variants are weighted by their agreement with the observations; they ";
  print_words(out, "Observed: ", who + weight_words(contradicts, number_of((*model)["effective"])));
}

/// Which measurement would say most of the leak that the first plan leaves.
void print_information(std::ostream& out, const Json& result) {
  const Json rows = result.value("information", Json::array());  // not of earlier releases
  if (rows.empty() || rows[0]["share_removed"].is_null()) return;
  print_words(out, "Information: ",
              "measuring " + rows[0]["measurement"].get<std::string>() + " would remove " +
                  percent(rows[0]["share_removed"].get<double>()) +
                  " of the variance of the first plan's leak between these variants");
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

/// Figures of rules of practice, each with its error.
void print_figures(std::ostream& out, const Json& plan) {
  struct Row {
    const char *name, *what, *unit;
    double units = 1.0;
  };
  constexpr std::array<Row, 5> kRows = {{{"coaptation_a2_p2_mm", "coaptation of A2 with P2", "mm"},
                                         {"tension_max_n", "highest chordal tension", "N"},
                                         {"leaflet_ratio", "leaflet ratio", ""},
                                         {"opening_area_mm2", "opening in diastole", "cm2", 0.01},
                                         {"gradient_mmhg", "mean gradient", "mmHg"}}};
  for (const auto& [name, what, unit, units] : kRows)
    if (const std::string words = figure_and_error(plan, name, unit, units); !words.empty())
      print_words(out, "      ", std::string(what) + ": " + words);
}

void print_plan(std::ostream& out, const Json& plan, const std::vector<std::string>& shared) {
  if (plan.contains("name")) print_words(out, "      ", plan["name"].get<std::string>() + ":");
  for (const std::string step : plan["description"]) print_words(out, "      ", step);
  if (plan["plan"]["steps"].empty()) out << "      no repair\n";
  if (const auto leak = plan.find("leak"); leak != plan.end())  // not of earlier releases
    print_words(out, "      ", "leak as planned: " + leak_and_error(*leak));
  print_figures(out, plan);
  print_tolerance(out, plan);
  print_beaten(out, plan);
  print_fine(out, plan);
  if (plan["status"] != "converged" || plan["crossing"].get<bool>())
    print_words(out, "      ! ", plan["status"].get<std::string>() + ", " + crossing_words(plan));
  for (const std::string& warning : warnings_of(plan))
    if (std::find(shared.begin(), shared.end(), warning) == shared.end())
      print_words(out, "      ! ", warning);
  if (const auto preferred = plan.find("preferred_over_next");
      preferred != plan.end() && !preferred->is_null())
    out << "      probability that an expert with these weights prefers it to the next: "
        << percent(*preferred) << '\n';
}

void print_plans(std::ostream& out, const Json& plans) {
  PlanRow shared;
  const std::vector<PlanRow> rows = rows_of(plans, shared);
  const std::vector<std::string> warnings = shared_warnings(plans);
  print_shared(out, shared, warnings);
  const std::vector<std::string> lines = table_lines(plans, rows, shared);
  out << lines.front() << '\n';
  for (std::size_t i = 0; i < plans.size(); ++i) {
    out << printable(lines[i + 1]) << '\n';
    print_plan(out, plans[i], warnings);
  }
}

/// What is not among the plans, and why: what has one reason in one line.
void print_cut(std::ostream& out, const Json& result) {
  std::vector<std::pair<std::string, std::string>> by_reason;
  for (const Json& cut : result["cut"]) {
    const std::string what = cut["what"], why = cut["why"];
    const auto same = std::find_if(by_reason.begin(), by_reason.end(),
                                   [&](const auto& line) { return line.second == why; });
    if (same == by_reason.end())
      by_reason.emplace_back(what, why);
    else
      same->first += ", " + what;
  }
  for (const auto& [what, why] : by_reason) print_words(out, "Not considered: ", what + ": " + why);
}

}  // namespace

void print_ranked(std::ostream& out, const Json& result) {
  const Json& before = result["before"];
  const std::string coaptation = figure_and_error(before, "coaptation_a2_p2_mm", "mm");
  const Json& plans = result["plans"];
  print_words(out, "Before: ",
              "leak " + leak_and_error(before["leak"]) + ", coaptation of A2 with P2 " +
                  (coaptation.empty() ? "not known" : coaptation) + ", " +
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
    print_plans(out, plans);
  }
  out << '\n';
  print_fine_mesh(out, result);
  print_model_draws(out, result);
  print_information(out, result);
  print_cut(out, result);
  out << counted(result["closures"].get<long>(), "closure") << " ("
      << result["closures_not_converged"] << " not converged, " << result["closures_crossed"]
      << " crossed";
  if (result["closures_known"] > 0)
    out << ", " << result["closures_known"] << " reused from an earlier run";
  out << ") in " << fixed(number_of(result["seconds"]), 1) << " s\n";
}

}  // namespace coapt
