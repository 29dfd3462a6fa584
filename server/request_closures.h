// Closures that a client waits for: within the limits of the service, and only while somebody waits.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/opened/opened_valve.h"
#include "server/answers.h"
#include "server/compute.h"
#include "server/limits.h"
#include "server/route.h"

namespace coapt {

class RequestClosures {
 public:
  /// Thrown where a closure was not finished; refusal() says why.
  struct Unfinished {};

  /// The time of the request starts. Both must outlive it.
  RequestClosures(const Request& request, const ServiceLimits& limits)
      : request_(request), limits_(limits) {}

  ClosureResult close(const Valve& valve, ClosureOptions options = {});
  ClosedValve close_and_measure(const Valve& valve, const ClosureOptions& options = {});
  /// Errors: open_valve()'s.
  Expected<OpenedValve> open(const Valve& valve, OpeningOptions options);

  /// For what closes valves itself and ends without a result when it is spent: then, if cancelled(), with Unfinished. Not to
  /// outlive this.
  ClosureBudget budget();

  /// Whether a closure that has begun is to end: its request is out of time, or nobody waits for it. From then on.
  bool cancelled();

  /// 422 for a closure that takes too many steps, 503 for a request that takes too long.
  Answer refusal() const;

 private:
  const Request& request_;
  const ServiceLimits& limits_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  bool cancelled_ = false;
};

/// Of so many closures of this valve, or of something as long.
TurnCost cost_of(const Valve& valve, std::ptrdiff_t closures = 1);

/// What `answer(closures)` makes when it is this request's turn; or the refusal.
template <class MakeAnswer>
Answer answer_in_turn(Compute& compute, const ServiceLimits& limits, const Request& request,
                      TurnCost cost, const MakeAnswer& answer) {
  const Compute::Turn turn(compute, cost);
  if (!turn) return too_busy();
  RequestClosures closures(request, limits);
  try {
    return answer(closures);
  } catch (const RequestClosures::Unfinished&) {
    return closures.refusal();
  }
}

}  // namespace coapt
