// The repair-plan search: which plans keep a valve closed also when the surgeon's hand and the
// ventricle vary, and what they cost the patient.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "search/evaluator.h"
#include "search/plans/plan_evaluations.h"
#include "search/plans/search_options.h"
#include "search/plans/search_result.h"

namespace coapt {

/// What a search needs beside its options.
struct SearchContext {
  SearchMonitor::Report progress{};  ///< may be empty
  /// Checked before each closure; the best so far is returned. May be null.
  const std::atomic<bool>* cancelled = nullptr;
  KnownPlans known{};  ///< of this valve and these closure options
  std::function<void(const std::string& key, int disturbance, const PlanClosure&)> keep{};
  Evaluator evaluate{};  ///< empty: closing_evaluator(); called from several threads at once
  Opener open{};         ///< empty: open_plan(), or nothing where `evaluate` is not
  SearchClock now{};     ///< empty: the steady clock
};

/// What speaks against a search, without closing anything: options out of range, rules that contradict each other or that the valve
/// does not allow. Errors point into the options ("/evaluations", "/rules/forbidden/0").
Errors check_search(const Valve& valve, const SearchOptions& options);

/// Errors are those of check_search(). Where rules close all that is indicated, there are no plans, the search is exhausted, and `cut` says
/// what was closed.
Expected<SearchResult> search_plans(const Valve& valve, const SearchOptions& options,
                                    const SearchContext& context);

struct NamedPlan {
  std::string name;
  RepairPlan plan;
};

/// Own plans, scored and ranked as a search ranks its finalists; options for searching are not
/// used. Errors point to "/plans/I/steps/...".
Expected<SearchResult> evaluate_plans(const Valve& valve, const std::vector<NamedPlan>& plans,
                                      const SearchOptions& options, const SearchContext& context);

}  // namespace coapt
