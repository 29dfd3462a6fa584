#include "search/training/flaccid.h"

#include <algorithm>
#include <cmath>

#include "core/live/live_valve.h"

namespace coapt {
namespace {

constexpr int kFlaccid_steps = 1800;
constexpr int kArrival_steps = 90;  // annulus and tips, 0.1 mm a step
constexpr int kPull_steps = 1800;
constexpr double kNearer = 0.25;  // of the tips' depth below the annulus

}  // namespace

Valve arrested(Valve valve) {
  const double annulus_mm = valve.annulus_mm.col(2).mean();
  for (PapillaryHead& head : valve.heads)
    head.tip_mm.z() += kNearer * (annulus_mm - head.tip_mm.z());
  return valve;
}

Points flaccid_mm(const Valve& valve) {
  LiveValve live(arrested(valve));
  live.advance(kFlaccid_steps);
  // Branch points of chordae follow the vertices.
  return live.vertices_mm().topRows(valve.rest_mm.rows());
}

double flaccid_difference_mm(const FreeEdge& edge, const Points& one_mm, const Points& other_mm) {
  const Eigen::VectorXd squared = (one_mm - other_mm).rowwise().squaredNorm();
  double on_edge = 0.0;
  for (const int vertex : edge.vertices) on_edge += squared[vertex];
  return std::sqrt(std::max(squared.mean(), on_edge / static_cast<double>(edge.vertices.size())));
}

SegmentHeights pulled_heights_mm(const Valve& valve, const FreeEdge& edge, double pull_n) {
  SegmentHeights heights{};
  const Valve slack = arrested(valve);
  for (std::size_t s = 0; s < kSegments; ++s) {
    LiveValve live(slack);
    live.advance(kArrival_steps);
    live.grab(0, edge.middle_vertex[s]);
    live.pull_with(0, Vec3(0.0, 0.0, pull_n));
    live.advance(kPull_steps);
    heights[s] = live.spot_mm(0).z();
  }
  return heights;
}

}  // namespace coapt
