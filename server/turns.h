// What is computed for a client that waits: within the limits of the service, in its turn, and only while somebody waits.
#pragma once

#include "operations/operation.h"
#include "server/answers.h"
#include "server/compute.h"
#include "server/limits.h"
#include "server/route.h"

namespace coapt {

OperationLimits operation_limits(const ServiceLimits& limits);

/// Of so many closures of a valve of so many vertices, or of something as long.
TurnCost cost_of(Index vertices, std::ptrdiff_t closures = 1);

/// 503 for what was busy or took too long, else 422.
Answer refusal(const Errors& errors);

/// What `answer(context)` makes when it is this request's turn. Both must outlive it.
template <class MakeAnswer>
Answer answer_in_turn(Compute& compute, Context& context, TurnCost cost, const MakeAnswer& answer) {
  const Compute::Turn turn(compute, cost);
  if (!turn) return too_busy();
  context.start();
  return answer(context);
}

/// The same for a request that names no valve.
template <class MakeAnswer>
Answer answer_in_turn(Compute& compute, const ServiceLimits& limits, const Request& request,
                      TurnCost cost, const MakeAnswer& answer) {
  Context context{.limits = operation_limits(limits), .abandoned = request.abandoned};
  return answer_in_turn(compute, context, cost, answer);
}

}  // namespace coapt
