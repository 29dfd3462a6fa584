// The leaflets as a surface. Directed edges are sorted, so that faces that share an edge meet: two
// of them in opposite directions are wound alike, in the same direction one is flipped; more than
// two are not a surface. Faces are then walked breadth-first over shared edges, each told how it is
// wound relative to the first; the minority of each sheet is called flipped.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "core/valve/validate_parts.h"

namespace coapt {
namespace {

// Ten times the finest mesh in use. More, or shorter edges, and one closure takes days: time steps
// shrink with the edge, pairs in contact grow with the square of the density.
constexpr int kMaxVertices = 100000;
constexpr int kMaxFaces = 100000;
constexpr double kMinEdge_mm = 0.02;         // a 50th of the leaflet's thickness
constexpr double kMinHeightOverEdge = 1e-3;  // below it spring constants (edge over height) explode

struct Edge {
  int low = 0, high = 0;  // vertices
  int face = 0;
  int corner = 0;         // the edge leaves this corner of the face
  bool ascending = true;  // the face walks it from low to high
};

std::vector<Edge> sorted_edges(const Faces& faces) {
  std::vector<Edge> edges;
  edges.reserve(3 * faces.rows());
  for (int face = 0; face < faces.rows(); ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      const int from = faces(face, corner);
      const int to = faces(face, (corner + 1) % 3);
      edges.push_back({std::min(from, to), std::max(from, to), face, corner, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
  });
  return edges;
}

struct Neighbour {
  int face = -1;
  bool wound_alike = true;
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;  // |F|, by corner

struct Surface {
  Neighbours neighbours;
  std::vector<Edge> boundary;
  bool manifold = true;
};

Surface join(const Faces& faces, ProblemList& problems) {
  const std::vector<Edge> edges = sorted_edges(faces);
  Surface surface;
  surface.neighbours.resize(faces.rows());
  const auto slot = [&](const Edge& edge) -> Neighbour& {
    return surface.neighbours[edge.face][edge.corner];
  };
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    const Edge& edge = edges[first];
    while (last < edges.size() && edges[last].low == edge.low && edges[last].high == edge.high) {
      ++last;
    }
    if (last - first == 1) {
      surface.boundary.push_back(edge);
    } else if (last - first == 2) {
      const Edge& other = edges[first + 1];
      const bool alike = edge.ascending != other.ascending;
      slot(edge) = {other.face, alike};
      slot(other) = {edge.face, alike};
    } else {
      surface.manifold = false;
      problems.add(ErrorCode::BadTopology, at("/faces", edges[first + 2].face),
                   "is the third face at the edge of vertices " + std::to_string(edge.low) +
                       " and " + std::to_string(edge.high) + "; at most two may meet");
    }
  }
  return surface;
}

// Lists what is not joined to face 0 and what is flipped; true if there is none of that.
bool check_sheet(const Neighbours& neighbours, ProblemList& problems) {
  enum class Winding : char { Unseen, Alike, Opposite };
  std::vector<Winding> winding(neighbours.size(), Winding::Unseen);
  bool orientable = true;
  std::vector<std::size_t> queue = {0};
  winding[0] = Winding::Alike;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const bool alike = winding[queue[i]] == Winding::Alike;
    for (const Neighbour& neighbour : neighbours[queue[i]]) {
      if (neighbour.face < 0) continue;
      const Winding expected = alike == neighbour.wound_alike ? Winding::Alike : Winding::Opposite;
      Winding& found = winding[neighbour.face];
      if (found == Winding::Unseen) {
        found = expected;
        queue.push_back(neighbour.face);
      } else if (found != expected) {
        orientable = false;
      }
    }
  }
  if (!orientable) {
    problems.add(ErrorCode::BadTopology, "/faces",
                 "is one-sided (a Moebius strip): no winding fits all faces");
    return false;
  }
  const auto opposite = std::count(winding.begin(), winding.end(), Winding::Opposite);
  const Winding minority = 2 * opposite > std::ssize(queue) ? Winding::Alike : Winding::Opposite;
  bool good = true;
  for (std::size_t face = 0; face < winding.size(); ++face) {
    if (winding[face] != minority) continue;
    good = false;
    problems.add(ErrorCode::BadGeometry, at("/faces", face),
                 "is flipped: wound against its neighbours; seen from the atrial surface all faces "
                 "must be counter-clockwise");
  }
  if (queue.size() == neighbours.size()) return good;
  const auto apart = std::find(winding.begin(), winding.end(), Winding::Unseen) - winding.begin();
  problems.add(ErrorCode::BadTopology, at("/faces", apart),
               "is not joined to face 0 over shared edges; both leaflets must be one sheet, joined "
               "at the commissures");
  return false;
}

// The vertex after each one along the boundary, in the direction of the faces.
std::vector<int> follow_boundary(const Valve& valve, const std::vector<Edge>& boundary,
                                 ProblemList& problems) {
  std::vector<int> next(valve.rest_mm.rows(), -1);
  std::vector<int> pinched;
  for (const Edge& edge : boundary) {
    const int from = edge.ascending ? edge.low : edge.high;
    int& after = next[from];
    if (after >= 0) pinched.push_back(from);
    after = edge.ascending ? edge.high : edge.low;
  }
  std::sort(pinched.begin(), pinched.end());
  pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
  for (const int vertex : pinched) {
    problems.add(ErrorCode::BadTopology, at("/vertices_mm", vertex),
                 "joins parts of the surface that share no edge there (a bow tie)");
  }
  if (!pinched.empty()) next.clear();
  return next;
}

bool check_face_indices(const Valve& valve, ProblemList& problems) {
  const int vertices = static_cast<int>(valve.rest_mm.rows());
  bool usable = true;
  std::vector<bool> used(vertices, false);
  for (int face = 0; face < valve.faces.rows(); ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      const int vertex = valve.faces(face, corner);
      if (vertex >= 0 && vertex < vertices) {
        used[vertex] = true;
        continue;
      }
      usable = false;
      problems.add(ErrorCode::BadReference, at(at("/faces", face), corner),
                   "is " + std::to_string(vertex) + ", must be the index of a vertex, 0 to " +
                       std::to_string(vertices - 1));
    }
  }
  for (int vertex = 0; usable && vertex < vertices; ++vertex) {
    if (used[vertex]) continue;
    problems.add(ErrorCode::BadTopology, at("/vertices_mm", vertex), "belongs to no face");
  }
  return usable;
}

double shortest_edge_mm(const Valve& valve, int face) {
  const auto corners = valve.faces.row(face);
  double shortest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    shortest = std::min(
        shortest, (valve.rest_mm.row(corners[(k + 1) % 3]) - valve.rest_mm.row(corners[k])).norm());
  return shortest;
}

// One problem for all edges that are too short: in a file in metres every edge is.
void check_edges(const Valve& valve, ProblemList& problems) {
  int shortest_face = 0, count = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (int face = 0; face < valve.faces.rows(); ++face) {
    const double length = shortest_edge_mm(valve, face);
    if (length < kMinEdge_mm) ++count;
    if (length >= shortest) continue;
    shortest = length;
    shortest_face = face;
  }
  if (count == 0) return;
  problems.add(ErrorCode::BadGeometry, at("/faces", shortest_face),
               "has an edge of " + shown(shortest) + " mm, the shortest of " +
                   std::to_string(count) + (count == 1 ? " face" : " faces") +
                   " with edges below 0.02 mm; edges must be 0.02 mm or longer");
}

// Lists faces without an area; false if some face has the same vertex twice.
bool check_shapes(const Valve& valve, bool vertices_usable, ProblemList& problems) {
  bool distinct = true;
  for (int face = 0; face < valve.faces.rows(); ++face) {
    const auto corners = valve.faces.row(face);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      distinct = false;
      problems.add(ErrorCode::BadGeometry, at("/faces", face), "names a vertex twice");
      continue;
    }
    if (!vertices_usable) continue;
    const Vec3 a = valve.rest_mm.row(corners[0]);
    const Vec3 b = valve.rest_mm.row(corners[1]);
    const Vec3 c = valve.rest_mm.row(corners[2]);
    const double longest2 =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double twice_area = (b - a).cross(c - a).norm();
    if (!(twice_area > kMinHeightOverEdge * longest2)) {
      problems.add(ErrorCode::BadGeometry, at("/faces", face),
                   "is degenerate: its height must be more than 0.001 of its longest edge");
    }
  }
  return distinct;
}

}  // namespace

MeshCheck check_mesh(const Valve& valve, ProblemList& problems) {
  MeshCheck mesh;
  const auto count = [&](const char* path, std::ptrdiff_t rows, int min, int max) {
    if (rows >= min && rows <= max) return true;
    problems.add(ErrorCode::OutOfRange, path,
                 "has " + std::to_string(rows) + " rows, must have " + std::to_string(min) +
                     " to " + std::to_string(max));
    return false;
  };
  const bool some_vertices = count("/vertices_mm", valve.rest_mm.rows(), 6, kMaxVertices);
  if (some_vertices) mesh.vertices_usable = check_points(valve.rest_mm, "/vertices_mm", problems);
  if (!count("/faces", valve.faces.rows(), 6, kMaxFaces) || !some_vertices) return mesh;
  mesh.faces_usable = check_face_indices(valve, problems);
  if (!mesh.faces_usable || !check_shapes(valve, mesh.vertices_usable, problems)) return mesh;
  if (mesh.vertices_usable) check_edges(valve, problems);
  const Surface surface = join(valve.faces, problems);
  if (!surface.manifold || !check_sheet(surface.neighbours, problems)) return mesh;
  mesh.next_on_boundary = follow_boundary(valve, surface.boundary, problems);
  mesh.surface = !mesh.next_on_boundary.empty();
  return mesh;
}

}  // namespace coapt
