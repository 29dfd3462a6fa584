// The repair plan, schema coapt.plan/1 (io/schema/plan.schema.json).
#pragma once

#include <string_view>

#include "core/repair/plan.h"
#include "io/json/json.h"

namespace coapt {

struct JsonPlace;

/// Every problem of form and range; what a valve does not allow is apply_plan's to say.
Expected<RepairPlan> read_plan(std::string_view text);

/// The same for a document already parsed (by parse_json); pointers start at `json`.
Expected<RepairPlan> plan_from_json(const Json& json);

/// The same of a plan inside another document, which need not say its schema; lists what is wrong there.
RepairPlan read_plan_within(const JsonPlace& place);

Json to_json(const RepairPlan& plan);

}  // namespace coapt
