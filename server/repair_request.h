// A valve and a repair plan in a request: what closures, scenes, exports and pictures are asked for with.
#pragma once

#include <variant>

#include "io/json/repair_answers.h"
#include "server/answers.h"
#include "server/json_body.h"
#include "server/request_closures.h"
#include "server/route.h"

namespace coapt {

/// A body of "valve", "plan" and "material" (optional) and the fields `more`; or its refusal: read_body()'s, or 422 if the valve does
/// not allow the plan or the material.
std::variant<RepairRequest, Answer> read_repair_request(const ValveSource& valves,
                                                        std::string_view body,
                                                        std::vector<JsonField> more);

/// What `answer(asked, closures)` makes of such a body, by some `closures_n` closures, when it is this request's turn to compute; or the refusal.
template <class MakeAnswer>
Answer answer_repair(const ValveSource& valves, Compute& compute, const Request& request,
                     std::vector<JsonField> more, const MakeAnswer& answer,
                     std::ptrdiff_t closures_n = 1) {
  const auto asked = read_repair_request(valves, request.body, std::move(more));
  if (const auto* refused = std::get_if<Answer>(&asked)) return *refused;
  const TurnCost cost = cost_of(std::get<RepairRequest>(asked).repaired, closures_n);
  return answer_in_turn(compute, valves.limits, request, cost, [&](RequestClosures& closures) {
    return answer(std::get<RepairRequest>(asked), closures);
  });
}

}  // namespace coapt
