// What a plan is priced by: amounts of leak, surgery, gradient and so on, each in its own unit. A cost is the sum of prices times
// amounts, so other prices need no closure.
#pragma once

#include <Eigen/Core>
#include <array>

namespace coapt {

/// Prices in mm2, each in [0, 1e6]. They are judgements, not measurements: competence may never be
/// outbid by comfort, and between competent plans the lesser operation wins.
struct CostWeights {
  /// Per mm2 of mean + sd_share x sd.
  double leak = 1.0;
  /// Sds that count beside the mean: thesis 4.2.3 compares both.
  double sd_share = 1.0;
  /// More, per mm2 of that above 1: 1 mm2 outbids a whole step.
  double incompetence = 5.0;
  /// For a plan that leaks at once; none if no disturbance makes it leak.
  double margin = 1.0;
  /// Per mm that A2 with P2 falls short of 8; weak evidence.
  double coaptation = 0.5;
  /// Per mm by which leaflets are further apart than they are thick.
  double gap = 2.0;
  /// Per mm of papillary movement.
  double movement = 0.2;
  /// More, per mm above what is usual.
  double movement_above_10 = 1.0;
  /// Per size: less annulus to move, and less opening, of which gradient_above_3 sees the narrow end alone.
  double undersizing = 0.5;
  /// More, per size above what practice accepts.
  double undersizing_above_4 = 2.0;
  /// Per step: each costs time on bypass.
  double step = 1.0;
  /// Per newton of peak chordal tension above the unrepaired valve's.
  double tension = 1.0;
  /// Per mmHg of mean gradient in diastole above 3, what usual rings leave (plan_opening.h).
  double gradient_above_3 = 2.0;
  /// More, per mmHg above 5.
  double gradient_above_5 = 10.0;
  /// Per mm of disease that the repair does not last, of 12 (durability.h); of reported plans alone.
  double durability = 0.25;
  /// For closures that did not converge or crossed, by their share.
  double untrusted = 1e4;
};

/// Order of the sum; those of the operation come first.
enum class CostTerm {
  Step,               ///< steps
  Undersizing,        ///< ring sizes
  UndersizingAbove4,  ///< ring sizes above 4
  Movement,           ///< mm, of both muscles
  MovementAbove10,    ///< mm above 10, of both muscles
  Leak,               ///< mean + sd_share x sd, mm2
  Incompetence,       ///< of that above 1 mm2
  Margin,             ///< 0 to 1: how near the first disturbance is that leaks
  Coaptation,         ///< mm short of 8, mean
  Gap,                ///< mm further apart than thick, mean
  Tension,            ///< N above the unrepaired valve's peak, mean
  GradientAbove3,     ///< mmHg
  GradientAbove5,     ///< mmHg
  Durability,         ///< mm of disease not lasted, of 12
  Untrusted           ///< share of the closures that failed; 2 if all did
};
inline constexpr int kTerms = 15;

/// Amounts by CostTerm. A difference of two may be negative.
struct CostTerms {
  Eigen::Array<double, kTerms, 1> amounts = Eigen::Array<double, kTerms, 1>::Zero();

  double& operator[](CostTerm term) { return amounts[static_cast<int>(term)]; }
  double operator[](CostTerm term) const { return amounts[static_cast<int>(term)]; }
};

struct CostTermRow {
  const char* name;
  double CostWeights::*weight;
};
/// By CostTerm; sd_share alone has no term: it is within Leak.
const std::array<CostTermRow, kTerms>& cost_term_rows();

/// mm2
double price(const CostTerms& terms, const CostWeights& weights);

}  // namespace coapt
