#include "core/metrics/shape_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/metrics/quantile.h"
#include "core/valve/vertex_normals.h"

namespace coapt {
namespace {

std::set<std::pair<int, int>> edges_of(const Faces& faces) {
  std::set<std::pair<int, int>> edges;
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax({faces(f, k), faces(f, (k + 1) % 3)}));
  return edges;
}

DistanceSummary summary_of(const std::vector<double>& distances_mm) {
  DistanceSummary summary;
  std::vector<double> lengths;
  double squares = 0.0;
  for (const double distance : distances_mm) {
    lengths.push_back(std::abs(distance));
    squares += distance * distance;
    summary.max_mm = std::max(summary.max_mm, lengths.back());
  }
  summary.rms_mm =
      std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, lengths.size())));
  summary.p95_mm = quantile(std::move(lengths), 0.95);
  return summary;
}

std::vector<double> lengths_of(const Points& ways_mm) {
  const Eigen::VectorXd lengths = ways_mm.rowwise().norm();
  return {lengths.begin(), lengths.end()};
}

void measure_nodes(const LeafletMesh& reference, ShapeComparison& comparison) {
  const Points ways = comparison.moved_mm - reference.vertices_mm;
  const Points normals = vertex_normals(reference.vertices_mm, reference.faces);
  comparison.signed_mm = lengths_of(ways);
  for (std::size_t i = 0; i < comparison.signed_mm.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (ways.row(row).dot(normals.row(row)) < 0.0) comparison.signed_mm[i] *= -1.0;
  }
  comparison.back = summary_of(comparison.signed_mm);
}

/// Leaves distances out once cancelled.
void measure_surface(const LeafletMesh& closed, const SurfaceTree& reference,
                     ShapeComparison& comparison, const std::function<bool()>& cancelled) {
  const Points normals = vertex_normals(reference.vertices_mm(), reference.faces());
  const SurfaceEdge edge(reference.faces());
  const Points& at_mm = comparison.moved_mm;
  const std::vector<TreePoint> nearest_to = nearest_to_each(reference, at_mm, cancelled);
  if (std::ssize(nearest_to) < at_mm.rows()) return;
  Index beyond = 0;
  for (Eigen::Index i = 0; i < at_mm.rows(); ++i) {
    const Vec3 point = at_mm.row(i).transpose();
    const TreePoint& nearest = nearest_to[static_cast<std::size_t>(i)];
    Vec3 normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      normal += nearest.weights[k] * normals.row(reference.faces()(nearest.face, k)).transpose();
    const double side = (point - nearest.point_mm).dot(normal) < 0.0 ? -1.0 : 1.0;
    comparison.signed_mm.push_back(side * nearest.distance_mm);
    if (nearest.distance_mm > 0.0 && edge.holds(nearest)) ++beyond;
  }
  comparison.beyond_edge_share = static_cast<double>(beyond) / static_cast<double>(at_mm.rows());
  const SurfaceTree back(at_mm, closed.faces);
  std::vector<double> distances;
  for (const TreePoint& nearest : nearest_to_each(back, reference.vertices_mm(), cancelled))
    distances.push_back(nearest.distance_mm);
  if (!distances.empty()) comparison.back = summary_of(distances);
}

}  // namespace

const char* to_string(Alignment alignment) {
  switch (alignment) {
    case Alignment::Auto:
      return "auto";
    case Alignment::None:
      return "none";
    case Alignment::Rigid:
      return "rigid";
  }
  return "";
}

LeafletMesh without_loose_vertices(const LeafletMesh& mesh) {
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices_mm.rows()), -1);
  for (const int vertex : mesh.faces.reshaped()) number[static_cast<std::size_t>(vertex)] = 0;
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(static_cast<Eigen::Index>(i));
  }
  LeafletMesh without = mesh;
  without.vertices_mm = mesh.vertices_mm(kept, Eigen::all);
  for (int& vertex : without.faces.reshaped()) vertex = number[static_cast<std::size_t>(vertex)];
  return without;
}

LeafletMesh in_pieces(Points vertices_mm, Faces faces) {
  std::vector<int> root(static_cast<std::size_t>(vertices_mm.rows()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int vertex) {
    while (root[static_cast<std::size_t>(vertex)] != vertex) {
      int& up = root[static_cast<std::size_t>(vertex)];
      up = root[static_cast<std::size_t>(up)];
      vertex = up;
    }
    return vertex;
  };
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 1; k < 3; ++k)
      root[static_cast<std::size_t>(find(faces(f, k)))] = find(faces(f, 0));
  LeafletMesh mesh{std::move(vertices_mm), std::move(faces), {}, {}};
  std::vector<int> piece(root.size(), -1);
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    int& number = piece[static_cast<std::size_t>(find(mesh.faces(f, 0)))];
    if (number < 0) {
      number = static_cast<int>(mesh.names.size());
      mesh.names.push_back("piece " + std::to_string(number + 1));
    }
    mesh.leaflets.push_back(number);
  }
  return mesh;
}

bool have_same_nodes(const LeafletMesh& a, const LeafletMesh& b) {
  if (a.vertices_mm.rows() != b.vertices_mm.rows() || a.faces.rows() != b.faces.rows())
    return false;
  const auto of_a = edges_of(a.faces), of_b = edges_of(b.faces);
  if (of_a.size() != of_b.size()) return false;
  // Edges of a alone must be diagonals of quadrangles that b splits the other way.
  std::map<std::pair<int, int>, std::vector<int>> opposite;
  for (Eigen::Index f = 0; f < a.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto edge = std::minmax({a.faces(f, k), a.faces(f, (k + 1) % 3)});
      if (!of_b.contains(edge)) opposite[edge].push_back(a.faces(f, (k + 2) % 3));
    }
  return std::all_of(opposite.begin(), opposite.end(), [&](const auto& entry) {
    const std::vector<int>& corners = entry.second;
    return corners.size() == 2 && of_b.contains(std::minmax({corners[0], corners[1]}));
  });
}

std::vector<LeafletArea> leaflet_areas(const LeafletMesh& mesh) {
  std::vector<LeafletArea> areas;
  for (const std::string& name : mesh.names) areas.push_back({name, 0.0});
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    const Vec3 a = mesh.vertices_mm.row(mesh.faces(f, 0)).transpose();
    const Vec3 b = mesh.vertices_mm.row(mesh.faces(f, 1)).transpose();
    const Vec3 c = mesh.vertices_mm.row(mesh.faces(f, 2)).transpose();
    const int leaflet = mesh.leaflets[static_cast<std::size_t>(f)];
    areas[static_cast<std::size_t>(leaflet)].area_mm2 += 0.5 * (b - a).cross(c - a).norm();
  }
  return areas;
}

std::vector<bool> nodes_in_contact(const LeafletMesh& mesh, double distance_mm,
                                   const std::function<bool()>& cancelled) {
  const Points& x = mesh.vertices_mm;
  const double neighbourhood_mm = 3.0 * distance_mm;
  std::vector<std::vector<int>> beside(static_cast<std::size_t>(x.rows()));
  for (const auto& [a, b] : edges_of(mesh.faces)) {
    beside[static_cast<std::size_t>(a)].push_back(b);
    beside[static_cast<std::size_t>(b)].push_back(a);
  }
  const SurfaceTree tree(x, mesh.faces);
  std::vector<double> way(beside.size(), neighbourhood_mm);
  std::vector<bool> contact;
  for (int node = 0; node < x.rows() && !(cancelled && cancelled()); ++node) {
    // Dijkstra, as far as the neighbourhood goes.
    std::set<std::pair<double, int>> open = {{0.0, node}};
    std::vector<int> reached = {node};
    way[static_cast<std::size_t>(node)] = 0.0;
    while (!open.empty()) {
      const auto [distance, at] = *open.begin();
      open.erase(open.begin());
      for (const int next : beside[static_cast<std::size_t>(at)]) {
        const double there = distance + (x.row(next) - x.row(at)).norm();
        double& known = way[static_cast<std::size_t>(next)];
        if (there >= known) continue;
        if (known < neighbourhood_mm) open.erase({known, next});
        known = there;
        open.insert({there, next});
        reached.push_back(next);
      }
    }
    const auto elsewhere = [&](int face) {
      return std::none_of(mesh.faces.row(face).begin(), mesh.faces.row(face).end(), [&](int v) {
        return way[static_cast<std::size_t>(v)] < neighbourhood_mm;
      });
    };
    contact.push_back(tree.nearest_within(x.row(node).transpose(), distance_mm, elsewhere).face >=
                      0);
    for (const int vertex : reached) way[static_cast<std::size_t>(vertex)] = neighbourhood_mm;
  }
  return contact;
}

ShapeComparison compare_shapes(const LeafletMesh& closed, const LeafletMesh& reference,
                               Alignment alignment, const std::function<bool()>& cancelled) {
  ShapeComparison comparison;
  comparison.node_to_node = have_same_nodes(closed, reference);
  comparison.aligned =
      alignment == Alignment::Rigid || (alignment == Alignment::Auto && !comparison.node_to_node);
  const SurfaceTree surface(reference.vertices_mm, reference.faces);
  if (comparison.node_to_node) {
    const RigidMotion best = fit_to_points(closed.vertices_mm, reference.vertices_mm);
    comparison.rms_after_rigid_mm =
        summary_of(lengths_of(moved(closed.vertices_mm, best) - reference.vertices_mm)).rms_mm;
    if (comparison.aligned) comparison.motion = best;
  } else if (comparison.aligned) {
    const SurfaceFit fit =
        fit_mesh_to_surface(closed.vertices_mm, closed.faces, surface, cancelled);
    comparison.motion = fit.motion;
    comparison.settled = fit.settled;
  }
  comparison.moved_mm = moved(closed.vertices_mm, comparison.motion);
  if (comparison.node_to_node) {
    measure_nodes(reference, comparison);
  } else {
    measure_surface(closed, surface, comparison, cancelled);
  }
  if (comparison.signed_mm.empty()) return comparison;
  comparison.distance = summary_of(comparison.signed_mm);
  double sum = 0.0;
  for (const double distance : comparison.signed_mm) sum += distance;
  comparison.mean_signed_mm = sum / static_cast<double>(comparison.signed_mm.size());
  return comparison;
}

}  // namespace coapt
