#include "clients/cli/print_opening.h"

#include <cmath>
#include <ostream>

#include "clients/cli/print.h"
#include "core/valve/number_text.h"
#include "io/json/json.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

/// In cm2, as openings are given.
std::string cm2(const Json& mm2) { return fixed(0.01 * number_of(mm2), 1) + " cm2"; }

/// "1.0 mmHg at 155 ml/s".
std::string gradient(const Json& mmhg, const Json& flow) {
  return fixed(number_of(mmhg), 1) + " mmHg at " + significant(number_of(flow), 3) + " ml/s";
}

/// With its error, if that is stated: "5.70 ± 0.29 cm2".
std::string open_area(const Json& opening) {
  const std::string words = figure_and_error(opening, "opening_area_mm2", "cm2", 0.01);
  return words.empty() ? cm2(opening["opening_area_mm2"]) : words;
}

/// "1.0 ± 0.1 mmHg at 155 ml/s".
std::string gradient_at_rest(const Json& opening) {
  const std::string words = figure_and_error(opening, "gradient_mmhg", "mmHg");
  return words.empty() ? gradient(opening["gradient_mmhg"], opening["flow_ml_s"])
                       : words + " at " + significant(number_of(opening["flow_ml_s"]), 3) + " ml/s";
}

/// What speaks against its figures; empty: nothing.
const char* distrust(const Json& opening) {
  if (opening["crossing"].get<bool>()) return "leaflets cross, so no opening was measured";
  return opening["status"] == "converged"
             ? ""
             : "the leaflets did not reach equilibrium, so no opening was measured";
}

}  // namespace

void print_opening(std::ostream& out, const Json& opening) {
  const std::string problem = distrust(opening);
  out << printable(opening["name"].get<std::string>()) << ": "
      << (problem.empty() ? "open, at rest" : problem) << '\n';
  if (problem.empty()) {
    out << "  opening         " << open_area(opening) << ", minimal surface\n  projected       "
        << cm2(opening["projected_area_mm2"]) << " along the annular normal; annulus "
        << cm2(opening["annulus_area_mm2"]) << " in diastole\n  mean gradient   "
        << gradient_at_rest(opening) << ", "
        << gradient(opening["gradient_exercise_mmhg"], opening["flow_exercise_ml_s"]) << '\n';
  }
  for (const Json& warning : opening["warnings"])
    out << "  ! " << printable(warning.get<std::string>()) << '\n';
  if (problem.empty())
    out << "coapt is research software, not a medical device; not for clinical decisions.\n";
}

std::string opening_in_short(const Json& opening) {
  if (const std::string problem = distrust(opening); !problem.empty()) return problem;
  return open_area(opening) + ", mean gradient " + gradient_at_rest(opening);
}

}  // namespace coapt
