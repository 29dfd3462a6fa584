#include "core/metrics/side_net.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace coapt {
namespace {

/// Numbers of the edges' first nodes, as they turn up. Edges are filed under their smaller vertex:
/// few share one.
class EdgeNodes {
 public:
  EdgeNodes(int vertices, int first_node) : of_vertex_(static_cast<std::size_t>(vertices), -1) {
    next_node_ = first_node;
  }

  /// The first node of the edge from vertex `a` to a greater one, `b`, and whether it is a new one.
  std::pair<int, bool> find_or_add(int a, int b) {
    int& first = of_vertex_[static_cast<std::size_t>(a)];
    for (int e = first; e >= 0; e = edges_[static_cast<std::size_t>(e)].next)
      if (edges_[static_cast<std::size_t>(e)].to == b)
        return {edges_[static_cast<std::size_t>(e)].node, false};
    edges_.push_back({b, next_node_, first});
    first = static_cast<int>(edges_.size()) - 1;
    next_node_ += kNodesOnEdge;
    return {edges_.back().node, true};
  }

 private:
  struct Edge {
    int to, node, next;
  };
  std::vector<int> of_vertex_;  // an index into edges_, or -1
  std::vector<Edge> edges_;
  int next_node_ = 0;
};

struct Vertices {
  std::vector<int> of_valve;  // the side's, in order
  std::vector<int> node;      // of each vertex of the valve; -1: not on this side
  std::vector<char> shared;   // of_valve's
};

Vertices vertices_of(const Valve& valve, const std::vector<Leaflet>& sides, Leaflet side) {
  const auto count = static_cast<std::size_t>(valve.rest_mm.rows());
  std::vector<char> own(count, 0), other(count, 0);
  for (Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      (sides[static_cast<std::size_t>(f)] == side
           ? own
           : other)[static_cast<std::size_t>(valve.faces(f, k))] = 1;
  Vertices vertices{{}, std::vector<int>(count, -1), {}};
  for (std::size_t v = 0; v < count; ++v) {
    if (!own[v]) continue;
    vertices.node[v] = static_cast<int>(vertices.of_valve.size());
    vertices.of_valve.push_back(static_cast<int>(v));
    vertices.shared.push_back(other[v]);
  }
  return vertices;
}

void list_faces_of_nodes(SideNet& net) {
  net.first_face.assign(net.nodes_mm.size() + 1, 0);
  for (const auto& face : net.faces)
    for (const int node : face) ++net.first_face[static_cast<std::size_t>(node) + 1];
  for (std::size_t i = 0; i < net.nodes_mm.size(); ++i) net.first_face[i + 1] += net.first_face[i];
  net.node_faces.resize(static_cast<std::size_t>(net.first_face.back()));
  std::vector<int> next(net.first_face.begin(), net.first_face.end() - 1);
  for (std::size_t f = 0; f < net.faces.size(); ++f)
    for (const int node : net.faces[f]) {
      int& slot = next[static_cast<std::size_t>(node)];
      net.node_faces[static_cast<std::size_t>(slot++)] = static_cast<int>(f);
    }
}

}  // namespace

SideNet make_side_net(const Valve& valve, const Points& closed_mm,
                      const std::vector<Leaflet>& sides, Leaflet side) {
  const Vec3 from = valve.rest_mm.row(valve.landmarks.anterolateral_commissure);
  const Vec3 to = valve.rest_mm.row(valve.landmarks.posteromedial_commissure);
  const Vec3 direction = (to - from) / (to - from).squaredNorm();
  const Vertices vertices = vertices_of(valve, sides, side);
  SideNet net;
  net.vertices = static_cast<int>(vertices.of_valve.size());
  for (const int v : vertices.of_valve) {
    net.nodes_mm.emplace_back(closed_mm.row(v));
    net.along.push_back((Vec3(valve.rest_mm.row(v)) - from).dot(direction));
  }
  net.shared = vertices.shared;

  EdgeNodes edges(net.vertices, net.vertices);
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    if (sides[static_cast<std::size_t>(f)] != side) continue;
    std::array<int, kNodesOfFace>& face = net.faces.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const int here = vertices.node[static_cast<std::size_t>(valve.faces(f, k))];
      const int there = vertices.node[static_cast<std::size_t>(valve.faces(f, (k + 1) % 3))];
      const auto [a, b] = std::minmax({here, there});
      const auto [node, is_new] = edges.find_or_add(a, b);
      auto* slot = face.data() + k * (1 + kNodesOnEdge);
      *slot = here;
      for (int i = 0; i < kNodesOnEdge; ++i)
        slot[1 + i] = node + (here == a ? i : kNodesOnEdge - 1 - i);
      for (int i = 0; is_new && i < kNodesOnEdge; ++i) {
        const double share = (i + 1.0) / (kNodesOnEdge + 1.0);
        const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
        net.nodes_mm.emplace_back((1.0 - share) * net.nodes_mm[ia] + share * net.nodes_mm[ib]);
        net.along.push_back((1.0 - share) * net.along[ia] + share * net.along[ib]);
        net.shared.push_back(0);
      }
    }
  }
  list_faces_of_nodes(net);
  return net;
}

bool joined(int i, int j) {
  constexpr int kStep = 1 + kNodesOnEdge;
  const int apart = std::abs(i - j);
  if (apart == 1 || apart == kNodesOfFace - 1) return true;
  for (int corner = 0; corner < 3; ++corner) {
    const auto on_edge = [&](int node) {
      return (node - corner * kStep + kNodesOfFace) % kNodesOfFace <= kStep;
    };
    if (on_edge(i) && on_edge(j)) return false;
  }
  return i != j;
}

}  // namespace coapt
