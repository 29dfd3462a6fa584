#include "io/mesh/sheet_repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <tuple>

#include "core/valve/number_text.h"

namespace coapt {
namespace {

/// A side of a face: its ends in ascending order, and whether the face leads from the lower to the higher.
struct FaceSide {
  int low, high, face;
  bool upwards;
  std::pair<int, int> edge() const { return {low, high}; }
};

std::vector<FaceSide> sorted_sides(const Faces& faces) {
  std::vector<FaceSide> sides;
  sides.reserve(static_cast<std::size_t>(3 * faces.rows()));
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = faces(f, k), b = faces(f, (k + 1) % 3);
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const FaceSide& p, const FaceSide& q) {
    return std::tie(p.low, p.high, p.face) < std::tie(q.low, q.high, q.face);
  });
  return sides;
}

/// Calls `use(first, last)` with the sides of each edge.
template <class Use>
void for_edges(const std::vector<FaceSide>& sides, const Use& use) {
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].edge() == sides[i].edge()) ++next;
    use(sides.begin() + static_cast<std::ptrdiff_t>(i),
        sides.begin() + static_cast<std::ptrdiff_t>(next));
  }
}

/// Vertices in the same place become the first of them.
int weld(TriangleMesh& mesh) {
  std::vector<int> order(static_cast<std::size_t>(mesh.vertices_mm.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int v) {
    return std::tuple(mesh.vertices_mm(v, 0), mesh.vertices_mm(v, 1), mesh.vertices_mm(v, 2));
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<int> becomes(order.size());
  int welded = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    becomes[static_cast<std::size_t>(order[i])] =
        same ? becomes[static_cast<std::size_t>(order[i - 1])] : order[i];
    welded += same ? 1 : 0;
  }
  if (welded > 0)
    for (int& corner : mesh.faces.reshaped()) corner = becomes[static_cast<std::size_t>(corner)];
  return welded;
}

/// Of triangles with the same three corners the first stays.
int drop_repeats(TriangleMesh& mesh) {
  std::vector<std::array<int, 4>> sorted;  // corners in ascending order, then the face
  sorted.reserve(static_cast<std::size_t>(mesh.faces.rows()));
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    std::array<int, 4> face = {mesh.faces(f, 0), mesh.faces(f, 1), mesh.faces(f, 2),
                               static_cast<int>(f)};
    std::sort(face.begin(), face.begin() + 3);
    sorted.push_back(face);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> kept(sorted.size(), true);
  int repeats = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (!std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[i - 1].begin())) continue;
    kept[static_cast<std::size_t>(sorted[i][3])] = false;
    ++repeats;
  }
  if (repeats > 0) mesh = part_of(mesh, kept);
  return repeats;
}

/// Neighbours lead along their common edge in opposite directions, wherever the surface allows; the face of the smallest
/// number in each piece stays as it is.
void turn_alike(RepairedSheet& sheet) {
  Faces& faces = sheet.mesh.faces;
  const std::vector<FaceSide> sides = sorted_sides(faces);
  std::vector<std::array<std::pair<int, bool>, 3>> next(static_cast<std::size_t>(faces.rows()),
                                                        {{{-1, false}, {-1, false}, {-1, false}}});
  std::vector<int> used(next.size(), 0);
  for_edges(sides, [&](auto first, auto last) {
    sheet.branching_edges += last - first > 2 ? 1 : 0;
    if (last - first != 2) return;
    const auto second = first + 1;
    const bool alike = first->upwards != second->upwards;
    for (const auto& [from, to] : {std::pair(first, second), std::pair(second, first)}) {
      int& slot = used[static_cast<std::size_t>(from->face)];
      next[static_cast<std::size_t>(from->face)][static_cast<std::size_t>(slot++)] = {to->face,
                                                                                      alike};
    }
  });
  std::vector<int> turned(next.size(), -1);
  for (std::size_t seed = 0; seed < next.size(); ++seed) {
    if (turned[seed] >= 0) continue;
    std::vector<std::size_t> piece = {seed};
    turned[seed] = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const auto& [to, alike] : next[piece[i]]) {
        if (to < 0 || turned[static_cast<std::size_t>(to)] >= 0) continue;
        turned[static_cast<std::size_t>(to)] = alike ? turned[piece[i]] : 1 - turned[piece[i]];
        piece.push_back(static_cast<std::size_t>(to));
      }
    }
    const auto count =
        std::count_if(piece.begin(), piece.end(), [&](std::size_t f) { return turned[f] == 1; });
    const bool keeps = 2 * count <= std::ssize(piece);
    for (const std::size_t f : piece) {
      if ((turned[f] == 1) != keeps) continue;
      std::swap(faces(static_cast<Eigen::Index>(f), 1), faces(static_cast<Eigen::Index>(f), 2));
      ++sheet.turned;
    }
  }
}

std::string all_sizes(const std::vector<double>& areas) {
  std::string text;
  for (std::size_t i = 0; i < areas.size() && i < 4; ++i)
    text += (i == 0 ? "" : ", ") + significant(areas[i], 3);
  return text + (areas.size() > 4 ? ", ..." : "");
}

/// Keeps the largest piece. Errors: another one of kIslandShare or more.
Errors drop_islands(RepairedSheet& sheet) {
  const std::vector<int> piece = face_pieces(sheet.mesh.faces);
  std::vector<double> areas(
      static_cast<std::size_t>(*std::max_element(piece.begin(), piece.end())) + 1);
  for (std::size_t f = 0; f < piece.size(); ++f)
    areas[static_cast<std::size_t>(piece[f])] +=
        area_vector(sheet.mesh, static_cast<Eigen::Index>(f)).norm();
  const auto largest = std::max_element(areas.begin(), areas.end());
  const int kept = static_cast<int>(largest - areas.begin());
  std::vector<double> large;
  for (const double area : areas)
    if (area >= kIslandShare * *largest) large.push_back(area);
  std::sort(large.rbegin(), large.rend());
  if (!(*largest > 0.0))
    return {{ErrorCode::BadGeometry, "/faces", "has no triangle with an area"}};
  if (large.size() > 1)
    return {
        {ErrorCode::BadTopology, "/faces",
         "comes in " + std::to_string(large.size()) + " parts of " + all_sizes(large) +
             " mm2; must be one sheet (only pieces smaller than 5 % of the largest are dropped)"}};
  sheet.area_mm2 = *largest;
  sheet.islands = static_cast<int>(areas.size()) - 1;
  if (sheet.islands == 0) return {};
  sheet.islands_mm2 = std::accumulate(areas.begin(), areas.end(), 0.0) - *largest;
  std::vector<bool> keep;
  for (const int number : piece) keep.push_back(number == kept);
  sheet.mesh = part_of(sheet.mesh, keep);
  return {};
}

/// A fan from the hole's edge to its centre.
void fill(const std::vector<int>& loop, const Vec3& centre_mm, TriangleMesh& mesh) {
  const auto centre = static_cast<int>(mesh.vertices_mm.rows());
  mesh.vertices_mm.conservativeResize(centre + 1, 3);
  mesh.vertices_mm.row(centre) = centre_mm;
  Eigen::Index f = mesh.faces.rows();
  mesh.faces.conservativeResize(f + std::ssize(loop), 3);
  for (std::size_t i = 0; i < loop.size(); ++i, ++f)
    mesh.faces.row(f) << loop[(i + 1) % loop.size()], loop[i], centre;
}

Errors mend_holes(RepairedSheet& sheet, std::size_t outlines, const ClosureBudget& budget) {
  const std::vector<std::vector<int>> loops = boundary_loops(sheet.mesh);
  Errors errors;
  for (std::size_t i = std::min(outlines, loops.size()); i < loops.size(); ++i) {
    const Points edge = sheet.mesh.vertices_mm(loops[i], Eigen::all);
    SheetHole hole;
    hole.centre_mm = edge.colwise().mean();
    hole.width_mm = 2.0 * (edge.rowwise() - hole.centre_mm.transpose()).rowwise().norm().mean();
    if (hole.width_mm > kWidestHole_mm) {
      errors.push_back({ErrorCode::BadTopology, "/faces",
                        "has a hole " + significant(hole.width_mm, 2) + " mm wide at (" +
                            significant(hole.centre_mm.x(), 3) + ", " +
                            significant(hole.centre_mm.y(), 3) + ", " +
                            significant(hole.centre_mm.z(), 3) +
                            ") mm; holes up to 6 mm are filled, larger ones must be filled "
                            "beforehand, and perforations cannot be represented"});
    } else if (hole.width_mm > kBridged_mm) {
      if (budget.is_cancelled()) break;
      fill(loops[i], hole.centre_mm, sheet.mesh);
      hole.filled = true;
    }
    sheet.holes.push_back(hole);
  }
  return errors;
}

}  // namespace

TriangleMesh welded(TriangleMesh mesh) {
  weld(mesh);
  return mesh;
}

int drop_loose_points(TriangleMesh& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.vertices_mm.rows()), false);
  for (const int corner : mesh.faces.reshaped()) used[static_cast<std::size_t>(corner)] = true;
  const auto loose = static_cast<int>(std::count(used.begin(), used.end(), false));
  if (loose > 0)
    mesh = part_of(mesh, std::vector<bool>(static_cast<std::size_t>(mesh.faces.rows()), true));
  return loose;
}

Vec3 area_vector(const TriangleMesh& mesh, Eigen::Index face) {
  const Vec3 a = mesh.vertices_mm.row(mesh.faces(face, 0)),
             b = mesh.vertices_mm.row(mesh.faces(face, 1)),
             c = mesh.vertices_mm.row(mesh.faces(face, 2));
  return 0.5 * (b - a).cross(c - a);
}

double area_mm2(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) sum += area_vector(mesh, f).norm();
  return sum;
}

double length_mm(const std::vector<int>& loop, const Points& vertices_mm) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += (vertices_mm.row(loop[(i + 1) % loop.size()]) - vertices_mm.row(loop[i])).norm();
  return sum;
}

std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh) {
  std::map<int, std::vector<int>> next;
  for_edges(sorted_sides(mesh.faces), [&](auto first, auto last) {
    if (last - first != 1) return;
    next[first->upwards ? first->low : first->high].push_back(first->upwards ? first->high
                                                                             : first->low);
  });
  std::vector<std::vector<int>> loops;
  for (auto& [start, ways] : next) {
    while (!ways.empty()) {
      std::vector<int> loop;
      for (auto at = next.find(start); at != next.end() && !at->second.empty();) {
        loop.push_back(at->first);
        const int to = at->second.back();
        at->second.pop_back();
        if (to == start) break;
        at = next.find(to);
      }
      if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < loops.size(); ++i)
    order.emplace_back(-length_mm(loops[i], mesh.vertices_mm), i);
  std::sort(order.begin(), order.end());
  std::vector<std::vector<int>> sorted;
  for (const auto& [length, i] : order) sorted.push_back(std::move(loops[i]));
  return sorted;
}

TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<bool>& kept) {
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices_mm.rows()), -1);
  std::vector<int> vertices, faces;
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f) {
    if (!kept[static_cast<std::size_t>(f)]) continue;
    faces.push_back(static_cast<int>(f));
    for (const int v : mesh.faces.row(f)) {
      if (number[static_cast<std::size_t>(v)] >= 0) continue;
      number[static_cast<std::size_t>(v)] = static_cast<int>(vertices.size());
      vertices.push_back(v);
    }
  }
  TriangleMesh part{mesh.vertices_mm(vertices, Eigen::all), mesh.faces(faces, Eigen::all)};
  for (int& corner : part.faces.reshaped()) corner = number[static_cast<std::size_t>(corner)];
  return part;
}

std::vector<std::vector<int>> face_neighbours(const Faces& faces) {
  std::vector<std::vector<int>> near(static_cast<std::size_t>(faces.rows()));
  for_edges(sorted_sides(faces), [&](auto first, auto last) {
    for (auto side = first + 1; side < last; ++side) {
      near[static_cast<std::size_t>((side - 1)->face)].push_back(side->face);
      near[static_cast<std::size_t>(side->face)].push_back((side - 1)->face);
    }
  });
  return near;
}

std::vector<int> face_pieces(const Faces& faces) {
  std::vector<int> parent(static_cast<std::size_t>(faces.rows()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int f) {
    while (parent[static_cast<std::size_t>(f)] != f) {
      int& up = parent[static_cast<std::size_t>(f)];
      up = parent[static_cast<std::size_t>(up)];
      f = up;
    }
    return f;
  };
  for_edges(sorted_sides(faces), [&](auto first, auto last) {
    for (auto side = first + 1; side < last; ++side) {
      const int a = root(first->face), b = root(side->face);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  });
  std::vector<int> piece(parent.size());
  int count = 0;
  for (std::size_t f = 0; f < piece.size(); ++f) {
    const int top = root(static_cast<int>(f));
    piece[f] = top == static_cast<int>(f) ? count++ : piece[static_cast<std::size_t>(top)];
  }
  return piece;
}

Expected<RepairedSheet> repaired_sheet(const TriangleMesh& mesh, std::size_t outlines,
                                       const ClosureBudget& budget) {
  RepairedSheet sheet;
  sheet.mesh = {mesh.vertices_mm, mesh.faces};
  sheet.welded = weld(sheet.mesh);
  std::vector<bool> whole;
  for (const auto& face : sheet.mesh.faces.rowwise())
    whole.push_back(face[0] != face[1] && face[1] != face[2] && face[2] != face[0]);
  sheet.collapsed = static_cast<int>(std::count(whole.begin(), whole.end(), false));
  if (sheet.collapsed == mesh.faces.rows())
    return Error{ErrorCode::BadGeometry, "/faces", "has no triangle with an area"};
  if (sheet.collapsed > 0) sheet.mesh = part_of(sheet.mesh, whole);
  sheet.repeated = drop_repeats(sheet.mesh);
  if (Errors errors = drop_islands(sheet); !errors.empty()) return errors;
  turn_alike(sheet);
  if (Errors errors = mend_holes(sheet, outlines, budget); !errors.empty()) return errors;
  return sheet;
}

}  // namespace coapt
