#include "core/closed/mesh_convergence.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/closed/close_refined.h"

namespace coapt {
namespace {

constexpr double kLeastOrder = 0.5, kMostOrder = 2.0;  // beyond them three meshes say nothing
constexpr double kSafety = 1.25;                       // Roache 1998, of three meshes
constexpr double kNoChange_mm2 = 1e-9;
constexpr double kOtherSpeed = 0.5;

MeshLevel level_of(const ClosedValve& closed) {
  MeshLevel level;
  level.triangles = static_cast<int>(closed.valve.faces.rows());
  level.vertices = static_cast<int>(closed.valve.rest_mm.rows());
  level.status = closed.closure.status;
  level.crossing = closed.closure.crossing;
  level.leak_mm2 = closed.measure.leak.area_mm2;
  return level;
}

bool is_closed(const ClosureResult& closure) {
  return closure.status == ClosureStatus::Converged && !closure.crossing && !closure.unfinished;
}

bool is_closed(const MeshLevel& level) {
  return level.status == ClosureStatus::Converged && !level.crossing;
}

/// The given mesh, come to rest by another way.
void take_other_end(const Valve& valve, ClosureOptions options, MeshConvergence& result) {
  options.speed *= kOtherSpeed;
  const ClosedValve other = close_and_measure(valve, options);
  ClosedValve& finest = result.finest;
  finest.closure.unfinished = finest.closure.unfinished || other.closure.unfinished;
  if (!is_closed(other.closure)) return;
  result.other_end_mm2 = other.measure.leak.area_mm2 - result.levels.front().leak_mm2;
  finest.measure.leak_error_mm2 = std::hypot(finest.measure.leak_error_mm2, result.other_end_mm2);
}

bool settled(const MeshLevel& level, const MeshConvergenceOptions& options) {
  return std::abs(level.change_mm2) <=
         std::max(options.within_mm2, options.within_share * level.leak_mm2);
}

}  // namespace

const char* to_string(MeshStop stop) {
  switch (stop) {
    case MeshStop::Settled:
      return "settled";
    case MeshStop::MostMeshes:
      return "most_meshes";
    case MeshStop::VertexLimit:
      return "vertex_limit";
    case MeshStop::NotClosed:
      return "not_closed";
  }
  return "";
}

MeshLimit mesh_limit(const std::vector<double>& leaks_mm2) {
  MeshLimit limit;
  limit.leak_mm2 = leaks_mm2.back();
  limit.error_mm2 = std::numeric_limits<double>::quiet_NaN();
  const std::size_t size = leaks_mm2.size();
  std::vector<double> changes;
  for (std::size_t i = 1; i < size; ++i) changes.push_back(leaks_mm2[i] - leaks_mm2[i - 1]);
  for (std::size_t i = 1; i < changes.size(); ++i)
    if (std::abs(changes[i]) > std::abs(changes[i - 1]) || changes[i] * changes[i - 1] < 0.0)
      limit.monotonous = false;
  if (changes.empty()) return limit;
  const double last = changes.back();
  limit.error_mm2 = std::abs(last);
  if (changes.size() < 2) return limit;
  const double before = changes[changes.size() - 2];
  if (std::abs(last) <= kNoChange_mm2) return limit;
  const double ratio = before / last;
  if (ratio <= 1.0) {
    limit.error_mm2 = std::max(std::abs(last), std::abs(before));
    return limit;
  }
  limit.order = std::log2(ratio);
  const double rest = last / (std::exp2(std::clamp(limit.order, kLeastOrder, kMostOrder)) - 1.0);
  if (limit.order >= kLeastOrder) limit.leak_mm2 = std::max(0.0, limit.leak_mm2 + rest);
  limit.error_mm2 = kSafety * std::abs(rest);
  return limit;
}

MeshConvergence close_until_settled(const Valve& valve, const MeshConvergenceOptions& options,
                                    const std::function<void(const MeshLevel&)>& told) {
  MeshConvergence result;
  result.finest = close_and_measure(valve, options.closure);
  while (true) {
    MeshLevel level = level_of(result.finest);
    if (!result.levels.empty()) level.change_mm2 = level.leak_mm2 - result.levels.back().leak_mm2;
    result.levels.push_back(level);
    if (told) told(level);
    if (!is_closed(result.finest.closure)) {
      result.stop = MeshStop::NotClosed;
      break;
    }
    if (settled(level, options)) {
      result.stop = MeshStop::Settled;
      break;
    }
    if (std::ssize(result.levels) >= options.most_meshes) {
      result.stop = MeshStop::MostMeshes;
      break;
    }
    std::optional<ClosedValve> finer =
        close_refined(result.finest, options.closure, options.most_vertices);
    if (!finer) {
      result.stop = MeshStop::VertexLimit;
      break;
    }
    result.finest = *std::move(finer);
  }
  std::vector<double> leaks;
  for (const MeshLevel& level : result.levels)
    if (is_closed(level)) leaks.push_back(level.leak_mm2);
  if (leaks.empty()) leaks.push_back(result.levels.back().leak_mm2);
  result.limit = mesh_limit(leaks);
  if (is_closed(result.levels.front())) take_other_end(valve, options.closure, result);
  return result;
}

}  // namespace coapt
