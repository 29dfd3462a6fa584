#include "search/plans/strength_gates.h"

#include <algorithm>
#include <variant>

#include "core/valve/counted.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

// Knots of expanded PTFE unravel at 7.1 +- 4.1 N and break at 16.7 +- 2.0 N: one sd below the first.
constexpr double kKnotHolds_n = 3.0;
constexpr const char* kKnots = "240 knots of ePTFE sutures: Ann Thorac Surg 2016 (PubMed 26652523)";
constexpr const char* kRingSutures =
    "forces in sheep, strength of their annuli: Pierce 2016 (Ann Thorac Surg, PubMed 27133454)";

Gate neochorda_strength(const PlanRecord& plan) {
  constexpr const char* kRule = "neochorda_strength";
  if (!has_step<Neochorda>(plan.plan)) return {kRule, GateSeverity::Pass, "no neochorda", kKnots};
  double peak = 0.0;
  int trusted_closures = 0, above = 0;
  for (const auto& [disturbance, closure] : plan.closures) {
    if (!trusted(closure)) continue;
    ++trusted_closures;
    peak = std::max(peak, closure.tension_max_n);
    above += closure.tension_max_n > kKnotHolds_n;
  }
  if (trusted_closures == 0)
    return {kRule, GateSeverity::NotAssessed, "no closure is reliable", kKnots};
  const std::string closures = counted(trusted_closures, "closure") + ", including disturbed ones";
  const std::string knots = "; knots may unravel above " + shown(kKnotHolds_n) + " N";
  if (above == 0)
    return {kRule, GateSeverity::Pass,
            "the highest chordal tension in " + closures + ", is " + with_decimals(peak, 1) + " N" +
                knots,
            kKnots};
  return {kRule, GateSeverity::Warn,
          "chordal tension exceeds " + shown(kKnotHolds_n) + " N, with a maximum of " +
              with_decimals(peak, 1) + " N, in " + std::to_string(above) + " of " + closures +
              knots,
          kKnots};
}

}  // namespace

std::vector<Gate> strength_gates(const PlanRecord& plan) {
  Gate ring{"ring_sutures", GateSeverity::Pass, "no ring", kRingSutures};
  if (has_step<Annuloplasty>(plan.plan)) {
    ring.severity = GateSeverity::NotAssessed;
    ring.finding =
        "forces on ring sutures are not simulated; published forces are 2.8 ± 1.3 N anteriorly and "
        "1.8 ± 1.2 N posteriorly, with tear-out at 6.4 ± 3.6 and 3.9 ± 1.6 N";
  }
  return {neochorda_strength(plan), ring};
}

}  // namespace coapt
