// The zone of the leaflet that a chorda pulls at.
//
// A point load on a membrane has no limit under refinement: the displacement under it grows with
// the logarithm of the mesh. Real chordae fan out and merge with the leaflet over a zone (Chen, Yin
// and May-Newman 2004). The chorda's end is the mean of the zone, weighted by a cone
// max(0, 1 - d / r) of the straight distance d from the insertion on the unstressed leaflet; so the
// weights tend to a limit under refinement. A zone at the free edge has half a disc, and its mean
// lies inside the edge, as a fan's does.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Part of a node in a weighted mean of nodes.
struct NodeShare {
  int node = 0;
  double weight = 0.0;
};

/// Vertices and weights, which sum to 1, in ascending order of the vertices. Only faces that hang
/// together with the insertion's within the radius count: another leaflet that lies on it does not.
/// Radius 0: the face of the insertion alone.
std::vector<NodeShare> insertion_zone(const Valve& valve, const Insertion& insertion,
                                      double radius_mm);

/// The weighted mean of nodes, where the end of a chorda is.
inline Vec3 mean_position(const std::vector<NodeShare>& shares, const Points& x) {
  Vec3 mean = Vec3::Zero();
  for (const NodeShare& share : shares) mean += share.weight * x.row(share.node).transpose();
  return mean;
}

}  // namespace coapt
