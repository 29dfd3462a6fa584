#include "operations/context.h"

#include <algorithm>
#include <utility>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

// Who has closed a half of the connection may still wait for an answer, but not for long.
constexpr double kPatience_s = 1.0;

constexpr double kUsualTriangles = 650.0;

}  // namespace

std::ptrdiff_t most_closures(const Valve& valve, const OperationLimits& limits) {
  const double size = static_cast<double>(valve.faces.rows()) / kUsualTriangles;
  return static_cast<std::ptrdiff_t>(limits.closures / std::max(1.0, size));
}

Errors check_size(const Valve& valve, const OperationLimits& limits) {
  Errors errors;
  const auto check = [&](const char* path, std::ptrdiff_t count, int most, const char* what) {
    if (count <= most) return;
    errors.push_back({ErrorCode::OutOfRange, path,
                      "has " + std::to_string(count) + ' ' + what +
                          ", but this service accepts at most " + std::to_string(most)});
  };
  check("/vertices_mm", valve.rest_mm.rows(), limits.vertices, "vertices");
  check("/chordae", std::ssize(valve.chordae), limits.chordae, "chordae");
  return errors;
}

Expected<ClosedValve> Context::close(const Valve& valve, ClosureOptions options) {
  options.budget = budget();
  ClosureResult closure = close_valve(valve, options);
  if (closure.unfinished) return refusal();
  const ValveMeasure measured = measure(valve, closure);
  return ClosedValve{valve, std::move(closure), measured};
}

Expected<OpenedValve> Context::open(const Valve& valve, OpeningOptions options) {
  options.budget = budget();
  Expected<OpenedValve> opened_valve = open_valve(valve, options);
  if (opened_valve && opened_valve->closure.unfinished) return refusal();
  return opened_valve;
}

ClosureBudget Context::budget() const {
  return {limits.vertex_steps, [this] { return cancelled(); }};
}

bool Context::cancelled() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
  return seconds.count() > limits.seconds ||
         (seconds.count() > kPatience_s && abandoned && abandoned());
}

Error Context::refusal() const {
  if (cancelled())
    return {ErrorCode::Busy, "",
            "took longer than " + shown(limits.seconds) +
                " s; request fewer plans or region_points, run a search as a job (POST /v1/plans), "
                "or close, study or import the valve offline (coapt close, coapt study, coapt "
                "valve import)"};
  return {ErrorCode::OutOfRange, "",
          "the closure takes more than " + shown(limits.vertex_steps) +
              " steps times vertices, the limit of this service; use a coarser mesh or softer "
              "chordae, or close the valve offline (coapt close)"};
}

}  // namespace coapt
