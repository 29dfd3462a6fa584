// What the engine's answers have in common.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "clients/engine/engine.h"
#include "io/json/json.h"
#include "io/json/repair_answers.h"

namespace coapt {

EngineAnswer json_answer(int status, Json object, Points closed_mm = {});
EngineAnswer problem(int status, const Errors& errors);

/// A body of "valve", "plan" and "material" (optional) and the fields `more`; or its refusal.
std::optional<EngineAnswer> read_request(std::string_view body, RepairRequest& asked,
                                         std::vector<JsonField> more);

}  // namespace coapt
