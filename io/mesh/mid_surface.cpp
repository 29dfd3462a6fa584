#include "io/mesh/mid_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

#include "core/metrics/surface_tree.h"
#include "core/valve/median.h"
#include "core/valve/vertex_normals.h"
#include "io/mesh/sheet_repair.h"

namespace coapt {
namespace {

constexpr int kSmoothings = 10;  // pairs of steps
constexpr double kShrink = 0.5, kGrow = -0.53;
constexpr double kReach_mm = 1.5;
constexpr double kOpposed = -0.7;  // cosine of normals
constexpr double kThickerThanMedian = 2.5;
constexpr double kLeastOpposed = 0.5;  // share of the area
constexpr int kVotes = 10;
constexpr int kThicknessSmoothings = 3;
constexpr Eigen::Index kRays = 64;  // between two looks at the budget

using Neighbours = std::vector<std::vector<int>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Neighbours vertex_neighbours(const TriangleMesh& mesh) {
  Neighbours near(static_cast<std::size_t>(mesh.vertices_mm.rows()));
  for (const auto& face : mesh.faces.rowwise())
    for (int k = 0; k < 3; ++k) {
      near[at(face[k])].push_back(face[(k + 1) % 3]);
      near[at(face[k])].push_back(face[(k + 2) % 3]);
    }
  for (std::vector<int>& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

/// Vertices of the surface's edge stay.
Points smoothed(const TriangleMesh& mesh, int pairs) {
  const Neighbours near = vertex_neighbours(mesh);
  Points x = mesh.vertices_mm;
  std::vector<bool> fixed(near.size(), false);
  for (const std::vector<int>& loop : boundary_loops(mesh))
    for (const int v : loop) fixed[at(v)] = true;
  for (int step = 0; step < 2 * pairs; ++step) {
    Points next = x;
    for (Eigen::Index v = 0; v < x.rows(); ++v) {
      const auto i = static_cast<std::size_t>(v);
      if (near[i].empty() || fixed[i]) continue;
      const Eigen::RowVector3d mean = x(near[i], Eigen::all).colwise().mean();
      next.row(v) += (step % 2 == 0 ? kShrink : kGrow) * (mean - x.row(v));
    }
    x = std::move(next);
  }
  return x;
}

double volume_mm3(const TriangleMesh& mesh) {
  const Vec3 centre = mesh.vertices_mm.colwise().mean();
  double sum = 0.0;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f)
    sum += area_vector(mesh, f).dot(Vec3(mesh.vertices_mm.row(mesh.faces(f, 0))) - centre) / 3.0;
  return sum;
}

double mean_edge_mm(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& face : mesh.faces.rowwise())
    for (int k = 0; k < 3; ++k)
      sum += (mesh.vertices_mm.row(face[(k + 1) % 3]) - mesh.vertices_mm.row(face[k])).norm();
  return sum / static_cast<double>(3 * mesh.faces.rows());
}

/// So many pairs of steps that they reach about kReach_mm: none for coarse triangles, whose shape they would take away.
int gentle_pairs(const TriangleMesh& mesh) {
  const double steps = kReach_mm / std::max(mean_edge_mm(mesh), 1e-3);
  return static_cast<int>(std::min<double>(kSmoothings, std::round(steps * steps)));
}

/// The smoothed shell, its normals outwards, and which triangles are opposite each other.
struct Shell {
  TriangleMesh mesh;
  Points gentle_mm;            ///< vertices, smoothed as little as their distances allow
  Points normals;              ///< of faces
  std::vector<int> opposite;   ///< -1: of the rim
  double thickness_mm = 0.0;   ///< median
  double opposed_share = 0.0;  ///< of the area
};

/// None of it opposed if the budget is cancelled.
Shell facing_itself(const TriangleMesh& input, const ClosureBudget& budget) {
  Shell shell;
  shell.mesh = {smoothed(input, kSmoothings), input.faces};
  shell.gentle_mm = smoothed(input, gentle_pairs(input));
  if (volume_mm3(shell.mesh) < 0.0) shell.mesh.faces.col(1).swap(shell.mesh.faces.col(2));
  const Points at_vertices = vertex_normals(shell.mesh.vertices_mm, shell.mesh.faces);
  const Eigen::Index n = shell.mesh.faces.rows();
  shell.normals.resize(n, 3);
  for (Eigen::Index f = 0; f < n; ++f) {
    Vec3 sum = at_vertices(shell.mesh.faces.row(f), Eigen::all).colwise().sum();
    shell.normals.row(f) = sum.normalized().transpose();
  }
  const SurfaceTree tree(shell.mesh.vertices_mm, shell.mesh.faces);
  const TriangleMesh gentle{shell.gentle_mm, shell.mesh.faces};
  std::vector<double> away(static_cast<std::size_t>(n)), lengths;
  for (Eigen::Index f = 0; f < n; ++f) {
    if (f % kRays == 0 && budget.is_cancelled()) return shell;
    const Vec3 centre =
        shell.mesh.vertices_mm(shell.mesh.faces.row(f), Eigen::all).colwise().mean();
    const TreePoint hit = tree.first_hit(centre, -Vec3(shell.normals.row(f)), kThickest_mm,
                                         [f](int face) { return face != f; });
    const bool opposed =
        hit.face >= 0 && (shell.normals.row(f).dot(shell.normals.row(hit.face)) < kOpposed ||
                          area_vector(gentle, f).normalized().dot(
                              area_vector(gentle, hit.face).normalized()) < kOpposed);
    shell.opposite.push_back(opposed ? hit.face : -1);
    away[static_cast<std::size_t>(f)] = hit.distance_mm;
    if (opposed) lengths.push_back(hit.distance_mm);
  }
  if (lengths.empty()) return shell;
  shell.thickness_mm = median(lengths);
  double total = 0.0, opposed = 0.0;
  for (Eigen::Index f = 0; f < n; ++f) {
    int& opposite = shell.opposite[static_cast<std::size_t>(f)];
    if (away[static_cast<std::size_t>(f)] > kThickerThanMedian * shell.thickness_mm) opposite = -1;
    const double area = area_vector(shell.mesh, f).norm();
    total += area;
    if (opposite >= 0) opposed += area;
  }
  shell.opposed_share = total > 0.0 ? opposed / total : 0.0;
  return shell;
}

/// +1 and -1 on the two sides, 0 on the rim.
std::vector<int> two_coloured(const Shell& shell) {
  struct Edge {
    int to;
    double weight;  ///< below zero: opposite
  };
  const int n = static_cast<int>(shell.opposite.size());
  const Neighbours near = face_neighbours(shell.mesh.faces);
  std::vector<std::vector<Edge>> edges(at(n));
  for (int f = 0; f < n; ++f) {
    const int opposite = shell.opposite[at(f)];
    if (opposite < 0) continue;
    for (const int other : near[at(f)]) {
      const double cosine = shell.normals.row(f).dot(shell.normals.row(other));
      if (cosine > 0.0 && shell.opposite[at(other)] >= 0) edges[at(f)].push_back({other, cosine});
    }
    if (shell.opposite[at(opposite)] < 0) continue;
    const double cosine = shell.normals.row(f).dot(shell.normals.row(opposite));
    edges[at(f)].push_back({opposite, cosine});
    edges[at(opposite)].push_back({f, cosine});
  }
  std::vector<int> colour(at(n), 0);
  std::priority_queue<std::tuple<double, int, int>> open;  // strength, -face, its colour
  const auto spread = [&](int seed) {
    open.emplace(2.0, -seed, 1);
    while (!open.empty()) {
      const auto [strength, negative, value] = open.top();
      open.pop();
      const int f = -negative;
      if (colour[at(f)] != 0) continue;
      colour[at(f)] = value;
      for (const Edge& edge : edges[at(f)])
        if (colour[at(edge.to)] == 0)
          open.emplace(std::abs(edge.weight), -edge.to, edge.weight > 0.0 ? value : -value);
    }
  };
  int first = 0;  // the most certain triangle
  for (int f = 1; f < n; ++f)
    if (edges[at(f)].size() > edges[at(first)].size()) first = f;
  if (shell.opposite[at(first)] >= 0) spread(first);
  for (int f = 0; f < n; ++f)
    if (shell.opposite[at(f)] >= 0 && colour[at(f)] == 0) spread(f);
  for (int vote = 0; vote < kVotes; ++vote) {
    std::vector<int> next = colour;
    for (int f = 0; f < n; ++f) {
      double sum = 0.0;
      for (const Edge& edge : edges[at(f)]) sum += edge.weight * colour[at(edge.to)];
      if (sum != 0.0) next[at(f)] = sum > 0.0 ? 1 : -1;
    }
    if (next == colour) break;
    colour = std::move(next);
  }
  // Patches without an opposite one that only one side touches belong to that side.
  std::vector<int> seen(at(n), 0);
  for (int seed = 0; seed < n; ++seed) {
    if (colour[at(seed)] != 0 || seen[at(seed)] != 0) continue;
    std::vector<int> patch = {seed};
    seen[at(seed)] = 1;
    bool touches[2] = {false, false};
    for (std::size_t i = 0; i < patch.size(); ++i)
      for (const int other : near[at(patch[i])]) {
        if (colour[at(other)] != 0 && seen[at(other)] == 0) {
          touches[colour[at(other)] > 0 ? 1 : 0] = true;
        } else if (seen[at(other)] == 0) {
          seen[at(other)] = 1;
          patch.push_back(other);
        }
      }
    if (touches[0] == touches[1]) continue;
    for (const int f : patch) colour[at(f)] = touches[1] ? 1 : -1;
  }
  return colour;
}

/// Of the faces of one colour the largest piece.
std::vector<bool> largest_piece(const TriangleMesh& mesh, const std::vector<int>& colour, int of) {
  std::vector<int> chosen;
  for (std::size_t f = 0; f < colour.size(); ++f)
    if (colour[f] == of) chosen.push_back(static_cast<int>(f));
  std::vector<bool> kept(colour.size(), false);
  if (chosen.empty()) return kept;
  const std::vector<int> piece = face_pieces(mesh.faces(chosen, Eigen::all));
  std::map<int, double> areas;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    areas[piece[i]] += area_vector(mesh, chosen[i]).norm();
  const int largest =
      std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
  for (std::size_t i = 0; i < chosen.size(); ++i) kept[at(chosen[i])] = piece[i] == largest;
  return kept;
}

double kept_area(const TriangleMesh& mesh, const std::vector<bool>& kept) {
  double sum = 0.0;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f]) sum += area_vector(mesh, static_cast<Eigen::Index>(f)).norm();
  return sum;
}

}  // namespace

double opposed_share(const TriangleMesh& shell, const ClosureBudget& budget) {
  return facing_itself(shell, budget).opposed_share;
}

Expected<MidSurface> mid_surface(const TriangleMesh& input, const ClosureBudget& budget) {
  const Error unclear{ErrorCode::BadTopology, "/faces",
                      "is a closed surface whose two sides cannot be distinguished; must be one "
                      "sheet, or a shell at most 8 mm thick"};
  const Shell shell = facing_itself(input, budget);
  if (shell.opposed_share < kLeastOpposed) return unclear;
  const std::vector<int> colour = two_coloured(shell);
  const std::vector<bool> one = largest_piece(shell.mesh, colour, 1),
                          two = largest_piece(shell.mesh, colour, -1);
  const double one_mm2 = kept_area(shell.mesh, one), two_mm2 = kept_area(shell.mesh, two);
  if (!(std::min(one_mm2, two_mm2) > kLeastOpposed * std::max(one_mm2, two_mm2))) return unclear;
  const std::vector<bool>& kept = one_mm2 >= two_mm2 ? one : two;
  const TriangleMesh smooth_side = part_of(shell.mesh, kept);
  const Points normals = vertex_normals(smooth_side.vertices_mm, smooth_side.faces);
  const TriangleMesh side = part_of({shell.gentle_mm, shell.mesh.faces}, kept);
  const SurfaceTree other(shell.gentle_mm, shell.mesh.faces);
  const std::vector<bool>& facing = one_mm2 >= two_mm2 ? two : one;
  const auto counts = [&](int f) { return facing[at(f)]; };
  const double limit_mm = kThickerThanMedian * shell.thickness_mm;
  std::vector<double> thickness(static_cast<std::size_t>(side.vertices_mm.rows()));
  for (Eigen::Index v = 0; v < side.vertices_mm.rows(); ++v) {
    if (v % kRays == 0 && budget.is_cancelled()) return unclear;
    const Vec3 from = side.vertices_mm.row(v);
    TreePoint hit = other.first_hit(from, -Vec3(normals.row(v)), limit_mm, counts);
    if (hit.face < 0) hit = other.nearest_within(from, limit_mm, counts);
    thickness[static_cast<std::size_t>(v)] = hit.face >= 0 ? hit.distance_mm : shell.thickness_mm;
  }
  const Neighbours near = vertex_neighbours(side);
  for (int step = 0; step < kThicknessSmoothings; ++step) {
    std::vector<double> next = thickness;
    for (std::size_t v = 0; v < near.size(); ++v) {
      for (const int w : near[v]) next[v] += thickness[at(w)];
      next[v] /= static_cast<double>(near[v].size() + 1);
    }
    thickness = std::move(next);
  }
  MidSurface middle{side, std::move(thickness)};
  for (Eigen::Index v = 0; v < side.vertices_mm.rows(); ++v)
    middle.sheet.vertices_mm.row(v) -=
        0.5 * middle.thickness_mm[static_cast<std::size_t>(v)] * normals.row(v);
  middle.sheet.vertices_mm = smoothed(middle.sheet, 2 * gentle_pairs(middle.sheet));
  return middle;
}

}  // namespace coapt
