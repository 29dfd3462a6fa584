#include "server/request_closures.h"

#include "core/valve/number_text.h"

namespace coapt {
namespace {

// A client that has closed its half of the connection may still wait for an answer, but not for long.
constexpr std::chrono::seconds kPatience(1);

// What takes about a second on one core: a closure of so many vertices, or so many of the presets' size.
constexpr Index kShortVertices = 1000;
constexpr std::ptrdiff_t kShortClosures = 8;

}  // namespace

TurnCost cost_of(const Valve& valve, std::ptrdiff_t closures) {
  return valve.rest_mm.rows() <= kShortVertices && closures <= kShortClosures ? TurnCost::Short
                                                                              : TurnCost::Long;
}

ClosureResult RequestClosures::close(const Valve& valve, ClosureOptions options) {
  options.budget = budget();
  ClosureResult closure = close_valve(valve, options);
  if (closure.unfinished) throw Unfinished{};
  return closure;
}

ClosedValve RequestClosures::close_and_measure(const Valve& valve, const ClosureOptions& options) {
  ClosureResult closure = close(valve, options);
  const ValveMeasure measured = measure(valve, closure);
  return {valve, std::move(closure), measured};
}

Expected<OpenedValve> RequestClosures::open(const Valve& valve, OpeningOptions options) {
  options.budget = budget();
  Expected<OpenedValve> opened = open_valve(valve, options);
  if (opened && opened->closure.unfinished) throw Unfinished{};
  return opened;
}

ClosureBudget RequestClosures::budget() {
  return {limits_.vertex_steps, [this] { return cancelled(); }};
}

bool RequestClosures::cancelled() {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started_;
  cancelled_ = cancelled_ || seconds.count() > limits_.request_seconds ||
               (seconds > kPatience && request_.abandoned && request_.abandoned());
  return cancelled_;
}

Answer RequestClosures::refusal() const {
  if (cancelled_)
    return retry_later(503, "took longer than " + shown(limits_.request_seconds) +
                                " s: ask for fewer plans or region_points at once, search as a job "
                                "(POST /v1/plans), or close, study or import the valve offline "
                                "(coapt close, coapt study, coapt valve import)");
  return problem(422, ErrorCode::OutOfRange,
                 "the closure takes more than " + shown(limits_.vertex_steps) +
                     " steps times vertices, the limit of this service: use a coarser mesh or "
                     "softer chordae, or close the valve offline (coapt close)");
}

}  // namespace coapt
