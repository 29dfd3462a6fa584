#include "search/training/free_edge.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/valve/leaflet_coordinates.h"

namespace coapt {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kEdgeHeight = 1.0 - 1e-6;  // of leaflet coordinates, which are solved for

double apart(double around, double other) { return std::abs(std::remainder(around - other, 1.0)); }

/// The vertex nearest to the mean direction of these; -1 of none.
int middle_of(const std::set<int>& vertices, const std::vector<double>& around) {
  double sine = 0.0, cosine = 0.0;
  for (const int vertex : vertices) {
    sine += std::sin(kTurn * around[static_cast<std::size_t>(vertex)]);
    cosine += std::cos(kTurn * around[static_cast<std::size_t>(vertex)]);
  }
  const double mean = std::atan2(sine, cosine) / kTurn;
  int nearest = -1;
  double distance = std::numeric_limits<double>::infinity();
  for (const int vertex : vertices) {
    const double from_mean = apart(around[static_cast<std::size_t>(vertex)], mean);
    if (from_mean >= distance) continue;
    distance = from_mean;
    nearest = vertex;
  }
  return nearest;
}

}  // namespace

Expected<FreeEdge> free_edge(const Valve& valve) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  FreeEdge edge;
  for (std::size_t v = 0; v < coordinates.height.size(); ++v)
    if (coordinates.height[v] > kEdgeHeight) edge.vertices.push_back(static_cast<int>(v));
  std::array<std::set<int>, kSegments> of_segment;
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int vertex = valve.faces(f, k);
      if (coordinates.height[static_cast<std::size_t>(vertex)] > kEdgeHeight)
        of_segment[static_cast<std::size_t>(valve.segments[static_cast<std::size_t>(f)])].insert(
            vertex);
    }
  for (const Segment segment : kAllSegments) {
    const auto s = static_cast<std::size_t>(segment);
    edge.middle_vertex[s] = middle_of(of_segment[s], coordinates.around);
    if (edge.middle_vertex[s] < 0)
      return Error{ErrorCode::BadGeometry, "/segments",
                   std::string(to_string(segment)) + " has no part of the free edge to pull at"};
  }
  return edge;
}

}  // namespace coapt
