#include "server/turns.h"

#include <cmath>
#include <functional>

#include "io/exchange/valve_labels.h"

namespace coapt {

OperationLimits operation_limits(const ServiceLimits& limits) {
  OperationLimits of_operations = OperationLimits::unlimited();
  of_operations.vertices = limits.vertices;
  of_operations.chordae = limits.chordae;
  of_operations.vertex_steps = limits.vertex_steps;
  of_operations.seconds = limits.request_seconds;
  of_operations.closures = limits.evaluation_closures;
  of_operations.voxels = kMostLabelVoxels;
  of_operations.threads = limits.request_threads;
  return of_operations;
}

double closing_seconds(Index vertices, std::ptrdiff_t closures) {
  // human-functional-mr with 720 to 4,692 vertices takes 0.12, 0.32, 1.1 and 2.5 s.
  constexpr double kOf1000Vertices_s = 0.18, kPower = 1.7;
  return kOf1000Vertices_s * static_cast<double>(closures) *
         std::pow(1e-3 * static_cast<double>(vertices), kPower);
}

TurnAsk turn_for(const Request& request, double seconds) {
  const std::hash<std::string> hash;
  std::size_t asked = hash(request.client + request.path) + 31 * hash(request.body);
  for (const auto& [name, value] : request.query) asked = 31 * asked + hash(name + '=' + value);
  return {seconds, request.client, asked};
}

Answer no_turn(const Compute::Turn& turn) {
  return retry_later(503,
                     turn.end() == Compute::End::TooLong
                         ? "the same request ran out of time a moment ago"
                         : "all cores are busy with other requests",
                     turn.retry_after_s());
}

Answer refusal(const Errors& errors) {
  const bool is_busy = errors.front().code == ErrorCode::Busy;
  return problem(is_busy ? 503 : 422, errors);
}

std::optional<Answer> read_files_in_turn(OperationTask& task, Compute& compute, Context& context,
                                         const Request& request) {
  if (!task.read_files) return std::nullopt;
  Answer answer =
      answer_in_turn(compute, context, turn_for(request, kImport_s), [&](Context& within) {
        const Expected<Index> vertices = task.read_files(within);
        if (!vertices) return refusal(vertices.errors());
        task.vertices = *vertices;
        return Answer{};
      });
  if (answer.status == 200) return std::nullopt;
  return answer;
}

}  // namespace coapt
