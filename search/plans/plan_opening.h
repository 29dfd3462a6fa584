// How a repaired valve opens: what a small ring costs, which systole does not show.
//
// Price: usual rings leave 3.4 +- 1.6 mmHg at rest (opened_valve.h); a mean gradient above 5 mmHg is functional stenosis.
#pragma once

#include <functional>
#include <optional>

#include "core/opened/opened_valve.h"
#include "search/plans/cost_terms.h"
#include "search/plans/gates.h"

namespace coapt {

/// Its measure means something only where it is trusted().
struct PlanOpening {
  ClosureStatus status = ClosureStatus::Converged;
  bool crossing = false;
  OpeningMeasure measure{};
  bool two_orifices = false;  ///< ties leave two, of which too little is known
};

/// Came to rest, uncrossed, with one orifice, its areas numbers.
bool trusted(const PlanOpening& opening);

/// Opens a repaired valve. Called from several threads at once.
using Opener = std::function<PlanOpening(const Valve&)>;

/// At rest, by open_valve()'s own options.
PlanOpening open_plan(const Valve& repaired);

inline constexpr const char* kUnknownOpening =
    "the opening is not known where a clip or stitch leaves two orifices";
inline constexpr double kUsualGradient_mmhg = 3.0, kStenosis_mmhg = 5.0;
inline constexpr double kStenosis_mm2 = 150.0, kNarrow_mm2 = 200.0;  ///< rejected, warned of

/// "5.6 mmHg, above 5 mmHg", with the digits that tell it from the limit.
std::string gradient_words(double mmhg);

/// GradientAbove3 and GradientAbove5; 0 where it is not trusted: the gates say so.
CostTerms opening_terms(const PlanOpening& opening);

/// "opening_area", "mean_gradient": always these, in this order; not assessed without an opening that is trusted.
std::vector<Gate> opening_gates(const std::optional<PlanOpening>& opening);

/// Whether practice would not leave the valve so narrow.
bool is_stenotic(const std::optional<PlanOpening>& opening);

}  // namespace coapt
