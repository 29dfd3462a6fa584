// The rules that practice would hold against a plan, each with its source. A finished plan states
// every rule: passed, warned of, rejected, or not assessed because coapt cannot see it.
#pragma once

#include <string>
#include <vector>

#include "search/plans/effort.h"

namespace coapt {

enum class GateSeverity { Pass, Warn, Reject, NotAssessed };
const char* to_string(GateSeverity severity);  ///< "pass", "warn", "reject", "not_assessed"

struct Gate {
  std::string rule;  ///< short name: "papillary_movement"
  GateSeverity severity = GateSeverity::Pass;
  std::string finding;  ///< with its figure: "posteromedial muscle moved by 11.5 mm"
  std::string source;   ///< of the rule
};

struct SurgicalOperation {
  const RepairPlan& plan;
  const Valve& valve;       ///< before
  const Valve& repaired;    ///< apply_plan() of these
  bool untethered = false;  ///< its leaflets, for sure: rings then are hardly undersized
};

/// Of what is done, whether or not the valve then closes: "ring_width", "ring_stenosis",
/// "undersizing", "papillary_movement", "suture_length", "filling",
/// "neochorda_length", "neochorda_half", "native_chordae". Always these, in this order; a rule
/// without a subject passes.
/// @pre apply_plan() accepts the plan.
std::vector<Gate> operation_gates(const SurgicalOperation& operation);

/// Whether a rule rejects: a search does not try such a plan.
bool is_rejected(const std::vector<Gate>& gates);

/// Warnings that another plan may well do without.
int avoidable_warnings(const std::vector<Gate>& gates);

/// One line for each gate that warns or rejects.
std::vector<std::string> warnings_of(const std::vector<Gate>& gates);

}  // namespace coapt
