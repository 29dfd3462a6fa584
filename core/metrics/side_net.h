// A net over the faces of one side of the valve, along which lines are drawn on it: the vertices,
// and points between them on every edge. Any two nodes of a face are joined, unless a third lies
// between them on the same edge.
//
// A line along the net is longer than the straight one across a flat sheet, by nothing along edges
// and by about 2 % in between, on fine meshes as on coarse ones. One more node on each edge doubles
// the time of a search; one less moved gaps of closures by up to a tenth.
#pragma once

#include <array>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

constexpr int kNodesOnEdge = 2;                     ///< between its ends
constexpr int kNodesOfFace = 3 + 3 * kNodesOnEdge;  ///< around it, from one corner on

struct SideNet {
  std::vector<Vec3> nodes_mm;  ///< on the closed valve
  /// Of each node at rest: 0 beside the anterolateral commissure, 1 beside the posteromedial one.
  std::vector<double> along;
  std::vector<char> shared;  ///< of each node: a vertex of the other side, too
  std::vector<std::array<int, kNodesOfFace>> faces;
  /// The faces of node i are node_faces[first_face[i]] to node_faces[first_face[i + 1] - 1].
  std::vector<int> first_face, node_faces;
  int vertices = 0;  ///< nodes [0, vertices) are vertices of the valve, the others lie on edges
};

/// @param sides order of Valve::faces (leaflet_sides())
SideNet make_side_net(const Valve& valve, const Points& closed_mm,
                      const std::vector<Leaflet>& sides, Leaflet side);

/// Whether nodes `i` and `j` of a face (0 to kNodesOfFace - 1) are joined.
bool joined(int i, int j);

}  // namespace coapt
