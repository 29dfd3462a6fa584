// What is computed for a client that waits: within the limits of the service, in its turn, and only while somebody waits.
#pragma once

#include <optional>

#include "operations/operation.h"
#include "server/answers.h"
#include "server/compute.h"
#include "server/limits.h"
#include "server/route.h"

namespace coapt {

OperationLimits operation_limits(const ServiceLimits& limits);

/// So many closures of a valve of so many vertices, or something as long, in seconds on a core of its own, roughly.
double closing_seconds(Index vertices, std::ptrdiff_t closures = 1);

/// Reading the files of a request, and making a valve of those of an import, likewise: a long turn.
inline constexpr double kImport_s = 2.0;

/// What a turn for this request is asked with.
TurnAsk turn_for(const Request& request, double seconds);

/// 503 without a turn; says when to come again.
Answer no_turn(const Compute::Turn& turn);

/// 503 for what was busy or took too long, else 422.
Answer refusal(const Errors& errors);

/// What `answer(context)` makes when it is this request's turn. All must outlive it.
template <class MakeAnswer>
Answer answer_in_turn(Compute& compute, Context& context, const TurnAsk& ask,
                      const MakeAnswer& answer) {
  Compute::Turn turn(compute, ask);
  if (!turn) return no_turn(turn);
  context.start();
  Answer made = answer(context);
  if (made.status < 300) turn.done();
  if (made.status == 503 && !(context.abandoned && context.abandoned())) turn.ran_out();
  return made;
}

/// The same for a request that names no valve.
template <class MakeAnswer>
Answer answer_in_turn(Compute& compute, const ServiceLimits& limits, const Request& request,
                      double seconds, const MakeAnswer& answer) {
  Context context{.limits = operation_limits(limits), .abandoned = request.abandoned};
  return answer_in_turn(compute, context, turn_for(request, seconds), answer);
}

/// Reads the files of a task, if it has any, in a turn of their own; then it knows its vertices. Else why not.
std::optional<Answer> read_files_in_turn(OperationTask& task, Compute& compute, Context& context,
                                         const Request& request);

}  // namespace coapt
