// The order of plans, as a surgeon would have it: what practice rejects comes last; plans that leave at most a mild leak come first, of these
// those without a warning that others avoid; plans that cannot be told apart form a class, which its simplest member heads.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace coapt {

/// What decides between plans.
struct PlanMerits {
  bool trusted = true;  ///< as planned, on its own mesh
  bool varied =
      true;  ///< closed at more than one node: else nothing is known of errors of execution
  bool fails_often = false;  ///< its closures over the region
  bool rejected = false;     ///< by a rule of practice
  bool stenotic = false;
  /// That the valve leaks less than kMildLeak_mm2, over errors of execution, tissue and mesh.
  double acceptable_probability = 0.0;
  bool closes_finely = true;   ///< on the finer mesh, too
  int avoidable_warnings = 0;  ///< of kAvoidable
  double durability_mm =
      std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known, of all plans or of none
  double gradient_mmhg = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
  int steps = 0, muscles = 0;                                       ///< muscles: sutured ones
  int free_anchors = 0;  ///< of sutures: no landmark to find
  int resections = 0;    ///< tissue that cannot be put back
  double sizes_below = 0.0;
  double leak_mm2 = 0.0;  ///< mean + sd over the region
  double cost = 0.0;
};

/// To the digit that is printed, in tenths.
inline double tenths(double value) { return std::round(10.0 * value); }

/// What ranks before all else, best first. What is not acceptable comes after all that is.
enum class PlanTier {
  Acceptable,     ///< without a warning that another plan may well do without
  Warned,         ///< acceptable, with such a warning
  NotAcceptable,  ///< is_acceptable(), and none of those below
  Stenotic,
  FailsOften,
  Untrusted,
  Rejected,
};
inline constexpr int kPlanTiers = 7;
const char* to_string(PlanTier tier);  ///< "acceptable", "warned", "not_acceptable", ...

/// From that probability on a plan is acceptable.
inline constexpr double kAcceptable = 0.95;

/// What the order hangs on, and no measurement fixes.
struct OrderThresholds {
  double acceptable = kAcceptable;
  /// Within these, plans cannot be told apart: durability_mm of the best of a class; gradient of the least, or not above what usual rings
  /// leave (plan_opening.h).
  double same_durability_mm = 2.0, same_gradient_mmhg = 1.0;
  /// Plans that last so long cannot be told apart either: they bear once more the disease that a valve came with. Papillary tips had
  /// moved by 6.5 +- 3.2 mm when ischaemia made sheep's valves leak (Tibayan 2003).
  double enough_durability_mm = 6.5;
};

/// 27: acceptable from 0.90, 0.95, 0.98; durability alike within 3, 2, 1 mm and enough from 5, 6.5, 8 mm on; 0.5, 1, 2 mmHg.
std::vector<OrderThresholds> threshold_settings();

/// Trusted, varied, seldom failing, not rejected, not stenotic, its gradient at most kStenosis_mmhg (plan_opening.h) where it is known,
/// mild with that probability, on the finer mesh, too.
bool is_acceptable(const PlanMerits& plan, double acceptable = kAcceptable);

PlanTier tier_of(const PlanMerits& plan, double acceptable = kAcceptable);

struct PlanPlace {
  int index = 0;     ///< into the plans given
  int of_class = 1;  ///< from 1: plans of one class cannot be told apart
};

/// All plans, best first; the first of a class is its simplest member: fewest steps, fewest muscles, fewest free anchors,
/// fewest resections, least undersizing in whole sizes, least leak above a trace, longest durability and least gradient, to the tenth.
/// What is not acceptable is a class of its own, by how likely it is to be, then by cost.
/// @param by_price by cost instead within what is acceptable and what is not, each plan a class of its own
std::vector<PlanPlace> order_of(const std::vector<PlanMerits>& plans, bool by_price = false,
                                const OrderThresholds& thresholds = {});

/// Of each plan, in how many of threshold_settings() it comes first.
std::vector<int> times_first(const std::vector<PlanMerits>& plans);

}  // namespace coapt
