// Every document that holds repair plans: what is written by coapt, by its service or by its page can be read again.
#pragma once

#include <string_view>
#include <vector>

#include "core/valve/problem_list.h"
#include "search/plans/plan_search.h"

namespace coapt {

/// The plans of a document, in its order, at least one: a plan (coapt.plan/1), a kept plan of the service, or a list
/// under "plans" (ranked plans, coapt.plans/2; the file of the page) or "kept_plans". Named as there, else
/// "plan 1" and so on; a plan by itself has no name. Lists every problem of form and range.
Expected<std::vector<NamedPlan>> read_plans(std::string_view text);

}  // namespace coapt
