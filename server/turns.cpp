#include "server/turns.h"

namespace coapt {
namespace {

// What takes about a second on one core: a closure of so many vertices, or so many of the presets' size.
constexpr Index kShortVertices = 1000;
constexpr std::ptrdiff_t kShortClosures = 24;

}  // namespace

OperationLimits operation_limits(const ServiceLimits& limits) {
  return {.vertices = limits.vertices,
          .chordae = limits.chordae,
          .vertex_steps = limits.vertex_steps,
          .seconds = limits.request_seconds,
          .closures = limits.evaluation_closures,
          .threads = limits.request_threads};
}

TurnCost cost_of(Index vertices, std::ptrdiff_t closures) {
  return vertices <= kShortVertices && closures <= kShortClosures ? TurnCost::Short
                                                                  : TurnCost::Long;
}

Answer refusal(const Errors& errors) {
  const bool is_busy = errors.front().code == ErrorCode::Busy;
  return problem(is_busy ? 503 : 422, errors);
}

}  // namespace coapt
