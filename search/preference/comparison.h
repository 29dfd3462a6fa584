// What an expert is asked and answers: which of two plans of one case they would rather do.
#pragma once

#include <compare>
#include <limits>
#include <string>
#include <vector>

#include "search/plans/cost_terms.h"

namespace coapt {

enum class Preference { First, Second, Unable };
/// "first", "second" or "unable" (cannot tell).
const char* to_string(Preference answer);
/// What it is with the two plans on each other's side.
Preference swapped(Preference answer);

/// A plan as it is compared. Figures that are not known are NaN.
struct ComparedPlan {
  std::vector<std::string> description;  ///< in surgical words, one line a step
  CostTerms terms;
  double leak_mm2 = std::numeric_limits<double>::quiet_NaN();          ///< mean over its region
  double opening_area_mm2 = std::numeric_limits<double>::quiet_NaN();  ///< in diastole
  double durability_mm = std::numeric_limits<double>::quiet_NaN();     ///< of further disease
};

/// The ranked plans of one search.
struct PlanCase {
  std::string name;  ///< differs from those of other cases, and from that of other plans
  std::vector<ComparedPlan> plans;
  double sd_share = CostWeights{}.sd_share;  ///< by which leaks became amounts
};

/// Indices into a list of cases and the plans of one.
struct PlanPair {
  int of_case = 0;
  int first = 0, second = 0;

  auto operator<=>(const PlanPair&) const = default;
};

struct GivenAnswer {
  PlanPair pair;
  Preference answer = Preference::Unable;
};

/// The pair with the lower index first, and what that makes of the answer: the same question, whatever side its plans
/// were shown on.
GivenAnswer in_order(const GivenAnswer& given);

/// By how much the first plan has more of each term than the second.
CostTerms difference(const PlanPair& pair, const std::vector<PlanCase>& cases);

}  // namespace coapt
