#include "clients/cli/print.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>

#include "clients/cli/print_opening.h"
#include "core/metrics/estimate.h"
#include "core/valve/number_text.h"
#include "core/valve/observed.h"
#include "io/json/json.h"
#include "io/picture/model_study_page.h"
#include "io/picture/text.h"
#include "search/plans/objective.h"

namespace coapt {
namespace {

constexpr double kSmallestListed_mm2 = 0.5;  // as in pictures

/// None where it is null, or of results of earlier releases.
std::optional<Interval> interval_of(const Json& estimate, const char* cause) {
  const auto found = estimate.find(cause);
  if (found == estimate.end() || found->is_null()) return std::nullopt;
  return Interval{number_of((*found)[0]), number_of((*found)[1])};
}

std::ostream& row(std::ostream& out, const char* label) {
  return out << "  " << std::left << std::setw(16) << label << std::right;
}

/// "n/a" if it is null.
std::string rounded(const Json& value, int decimals) { return fixed(number_of(value), decimals); }

void print_attempts(std::ostream& out, const Json& attempts) {
  if (attempts.size() < 2) return;
  for (const Json& attempt : attempts)
    out << "  tried " << attempt["how"].get<std::string>() << ": "
        << attempt["status"].get<std::string>() << " after " << attempt["steps"] << " steps, "
        << attempt["crossing_pairs"] << " crossings\n";
}

void print_leak(std::ostream& out, const Json& leak) {
  const double error = number_of(leak["error_mm2"]);
  row(out, "leak") << leak_and_error(leak) << '\n';
  for (const Json& opening : leak["openings"]) {
    if (number_of(opening["area_mm2"]) < kSmallestListed_mm2) continue;
    std::string segments;
    for (const Json& segment : opening["segments"])
      segments += (segments.empty() ? " at " : ", ") + segment.get<std::string>();
    row(out, "") << known_digits(number_of(opening["area_mm2"]), error) << " mm2" << segments
                 << ", " << rounded(opening["width_mm"], 1) << " mm wide\n";
  }
}

/// "3.32 ± 0.23 N", or "58 mm2; 31 to 92 mm2 with tissue error (5 to 95 %)".
std::string in_unit(const Estimate& estimate, const std::string& unit) {
  const auto [value, interval, cause] = words_of(estimate);
  const std::string of = unit.empty() ? "" : " " + unit;
  return value + of + (interval.empty() ? "" : "; " + interval + of + " " + cause);
}

/// The same of a figure; of results of earlier releases the value alone.
std::string figure_words(const Json& measure, const char* name, const char* unit, double units,
                         int decimals) {
  const std::string words = figure_and_error(measure, name, unit, units);
  return words.empty() ? fixed(units * number_of(measure[name]), decimals) + " " + unit : words;
}

/// Of a valve that is not mitral.
void print_leaflets(std::ostream& out, const Json& measure) {
  print_leak(out, measure["leak"]);
  for (const Json& leaflet : measure["leaflets"])
    row(out, "leaflet") << printable(leaflet["name"].get<std::string>()) << ": area "
                        << rounded(leaflet["rest_area_mm2"], 0) << " to "
                        << rounded(leaflet["closed_area_mm2"], 0) << " mm2, median stretch "
                        << rounded(leaflet["stretch_median"], 2) << ", in contact with another "
                        << fixed(100.0 * number_of(leaflet["contact_share"]), 1) << " %\n";
  row(out, "chordae") << "highest tension " << rounded(measure["tension_max_n"], 2) << " N, sum "
                      << rounded(measure["tension_sum_n"], 1) << " N\n";
}

/// "leak 30 ± 8 mm2 (3D planimetry), widest gap 3 ± 0.5 mm".
std::string observed_words(const Json& observed) {
  std::string words;
  for (const ObservedRow& figure : kObservedRows) {
    const auto seen = observed.find(figure.name);
    if (seen == observed.end()) continue;
    std::string name = figure.name;  // with its unit
    name.erase(name.rfind('_'));
    std::replace(name.begin(), name.end(), '_', ' ');
    const std::string source = seen->value("source", "");
    words += (words.empty() ? "" : ", ") + name + ' ' +
             with_error(number_of((*seen)["value"]), number_of((*seen)["sd"]), figure.unit) +
             (source.empty() ? "" : " (" + printable(source) + ")");
  }
  return words;
}

void print_measure(std::ostream& out, const Json& measure) {
  if (measure.contains("leaflets")) {
    print_leaflets(out, measure);
    return;
  }
  const Json& coaptation = measure["coaptation"];
  print_leak(out, measure["leak"]);
  const auto draws = measure.find("tissue_draws");
  const bool has_draws = draws != measure.end();
  if (has_draws) row(out, "") << "over " << draws_words(*draws) << '\n';
  if (const auto observed = measure.find("observed"); observed != measure.end())
    row(out, "observed") << observed_words(*observed) << (has_draws ? "" : "; used with --draws")
                         << '\n';
  const Json& sections = coaptation["sections"];
  const auto touching = std::count_if(sections.begin(), sections.end(), [](const Json& section) {
    return section["contact"].get<bool>();
  });
  const std::string a2_p2 = figure_and_error(measure, "coaptation_a2_p2_mm", "mm");
  row(out, "coaptation") << "height min " << rounded(coaptation["height_min_mm"], 1) << ", mean "
                         << rounded(coaptation["height_mean_mm"], 1) << " mm"
                         << (a2_p2.empty() ? "" : ", of A2 with P2 " + a2_p2)
                         << "; leaflets in contact at " << touching << " of " << sections.size()
                         << " sections, largest distance of mid-surfaces "
                         << rounded(coaptation["distance_max_mm"], 2) << " mm";
  if (measure.contains("coaptation_area_index"))
    out << "; " << fixed(100.0 * number_of(measure["coaptation_area_index"]), 0)
        << " % of the leaflet area";
  out << '\n';
  if (const std::string ratio = figure_and_error(measure, "leaflet_ratio", ""); !ratio.empty())
    row(out, "leaflet ratio") << ratio << ", anterior over posterior, annulus to coaptation\n";
  const Json& annulus = measure["annulus"];
  row(out, "annulus") << "AP " << rounded(annulus["ap_mm"], 1) << ", AL-PM "
                      << rounded(annulus["al_pm_mm"], 1) << ", circumference "
                      << rounded(annulus["circumference_mm"], 1) << ", saddle "
                      << rounded(annulus["saddle_height_mm"], 1) << " mm; area "
                      << rounded(annulus["area_mm2"], 0) << " mm2\n";
  row(out, "tenting") << "height " << rounded(measure["tenting_height_mm"], 1) << " mm, area "
                      << rounded(measure["tenting_area_mm2"], 0) << " mm2\n";
  row(out, "chordae") << "highest tension " << figure_words(measure, "tension_max_n", "N", 1.0, 2)
                      << ", sum " << rounded(measure["tension_sum_n"], 1) << " N\n";
  row(out, "leaflet strain") << "99th percentiles: circumferential "
                             << figure_words(measure, "strain_circumferential_max", "%", 100.0, 1)
                             << ", radial "
                             << figure_words(measure, "strain_radial_max", "%", 100.0, 1) << '\n';
}

/// What the meshes say of their limit.
void print_limit(std::ostream& out, const Json& convergence) {
  const double error = number_of(convergence["leak_error_mm2"]);
  const double order = number_of(convergence["order"]);
  const std::size_t meshes = convergence["levels"].size();
  if (meshes < 2 || !std::isfinite(error)) return;
  const std::string off = fixed(error, 1) + " mm2";
  out << "    ";
  if (error == 0.0) {
    out << "the leak no longer changes";
  } else if (meshes == 2) {
    out << "two meshes do not show the order of convergence; assuming 1, the leak is within " << off
        << " of the mesh-independent value";
  } else if (order >= 0.5) {
    out << "observed order of convergence " << fixed(order, 1) << ": the extrapolated leak is "
        << rounded(convergence["leak_limit_mm2"], 1)
        << " mm2, and the leak on the last mesh is within " << off << " of it";
  } else if (std::isfinite(order)) {
    out << "observed order of convergence " << fixed(order, 1)
        << ", too low to extrapolate: the error of the leak may reach " << off;
  } else {
    out << "the leak oscillates or diverges from mesh to mesh; the last changes reach " << off;
  }
  out << '\n';
}

/// Where it matters beside the digits that are printed.
void print_other_end(std::ostream& out, const Json& convergence) {
  constexpr double kNamed_mm2 = 0.5;
  const double other = number_of(convergence["other_end_mm2"]);
  if (!(std::abs(other) >= kNamed_mm2)) return;
  out << "    closed at half the speed, the first mesh leaks " << fixed(std::abs(other), 1)
      << " mm2 " << (other > 0.0 ? "more" : "less") << "; the error of the leak includes this\n";
}

void print_convergence(std::ostream& out, const Json& convergence) {
  const std::string stop = convergence["stop"];
  const double share = number_of(convergence["within_share"]);
  row(out, "finer meshes")
      << (stop == "settled" ? "the leak has converged"
          : stop == "most_meshes"
              ? "the leak has not converged on two meshes; --certainty proof refines further"
          : stop == "not_closed"
              ? "the leak has not converged: the last closure is not reliable"
              : "the leak has not converged: the next mesh would have too many vertices")
      << " (tolerance " << rounded(convergence["within_mm2"], 2) << " mm2"
      << (share > 0.0 ? " or " + percent(share) : "") << ")\n"
      << "    triangles      leak    change   seconds\n";
  for (const Json& level : convergence["levels"])
    out << std::setw(13) << grouped(level["triangles"]) << std::setw(10)
        << rounded(level["leak_mm2"], 1) << std::setw(10)
        << (std::isfinite(number_of(level["change_mm2"])) ? rounded(level["change_mm2"], 1) : "")
        << std::setw(10) << rounded(level["seconds"], 2) << '\n';
  print_limit(out, convergence);
  print_other_end(out, convergence);
}

}  // namespace

Estimate estimate_of(const Json& json, double value) {
  return {value, interval_of(json, "numerical"), interval_of(json, "tissue"),
          interval_of(json, "execution")};
}

std::string leak_and_error(const Json& leak) {
  Estimate estimate = estimate_of(leak, number_of(leak["area_mm2"]));
  if (!leak.contains("numerical"))  // of earlier releases
    estimate.numerical = area_interval(estimate.value, number_of(leak.value("error_mm2", Json())));
  const bool tissue_missing =
      estimate.numerical && !estimate.tissue && words_of(estimate).interval.empty();
  return in_unit(estimate, "mm2") +
         (tissue_missing ? " (numerical error; tissue error not known)" : "");
}

std::string figure_and_error(const Json& measured, const char* name, const std::string& unit,
                             double units) {
  const auto estimates = measured.find("estimates");
  if (estimates == measured.end()) return "";
  const auto found = estimates->find(name);
  if (found == estimates->end()) return "";
  const Estimate estimate = estimate_of(*found, number_of((*found)["value"]));
  return std::isfinite(estimate.value) ? in_unit(scaled(estimate, units), unit) : "";
}

std::string variants_words(const Json& draws) {
  return counted(draws["draws"].get<long>(), "variant") +
         (draws.value("fit_drawn", false)
              ? " of tissue and of the parameters that the fit left uncertain"
          : draws.value("chordae_drawn", false) ? " of tissue and of chordae that were not imaged"
                                                : " of tissue and chordae");
}

std::string draws_words(const Json& draws) {
  const std::string words = variants_words(draws);
  if (draws["observed"].empty()) return words;
  const bool contradicts = draws["contradicts_model"].get<bool>();
  return words +
         (contradicts ? ". The observation "
                      : ", weighted by the observations of the valve: they ") +
         weight_words(contradicts, number_of(draws["effective"]));
}

double number_of(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

const char* crossing_words(const Json& closure) {
  return closure["crossing"].get<bool>() ? "leaflets cross" : "no crossing";
}

void print_closure(std::ostream& out, const Json& closure) {
  out << printable(closure["valve"].get<std::string>()) << ": "
      << closure["status"].get<std::string>() << " after " << closure["steps"]
      << " steps, residual " << rounded(closure["residual"], 4) << ", " << crossing_words(closure)
      << '\n';
  print_attempts(out, closure["attempts"]);
  if (const auto diagnosis = closure.find("diagnosis");
      diagnosis != closure.end() && !diagnosis->is_null())
    out << "  " << (*diagnosis)["sentence"].get<std::string>() << '\n';
  print_measure(out, closure);
  if (const auto opening = closure.find("opening"); opening != closure.end())
    row(out, "opening") << opening_in_short(*opening) << '\n';
  if (const auto accuracy = closure.find("accuracy"); accuracy != closure.end())
    row(out, "accuracy") << "at most " << significant(number_of((*accuracy)["error_mm2"]), 3)
                         << " mm2 requested: "
                         << counted((*accuracy)["refinements"].get<int>(), "refinement")
                         << ", residual " << (*accuracy)["residual_tolerance"].get<double>()
                         << ", predicted displacement "
                         << (*accuracy)["way_tolerance_mm"].get<double>() << " mm\n";
  if (const auto convergence = closure.find("convergence"); convergence != closure.end())
    print_convergence(out, *convergence);
  for (const Json& warning : closure["warnings"])
    out << "  ! " << printable(warning.get<std::string>()) << '\n';
}

}  // namespace coapt
