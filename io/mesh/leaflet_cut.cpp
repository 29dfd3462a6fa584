// Each triangle that the half-plane crosses gives a piece between two of its edges. Pieces that
// share an edge are chained. The line starts at the annulus, goes to the nearest point of the chain
// that begins there, along it, and on to the next chain that begins nearby and ends further from
// the annulus.

#include "io/mesh/leaflet_cut.h"

#include <algorithm>
#include <array>

namespace coapt {
namespace {

constexpr double kSpeck_mm = 0.3;  // shorter chains are crumbs of the segmentation

struct Chain {
  std::vector<Vec2> line;
  int sheet = 0;
  bool used = false;
};

/// End of a piece: where the half-plane crosses a mesh edge.
struct Crossing {
  std::array<int, 2> edge;  // vertices, ascending
  Vec2 point;
  std::size_t piece;
};

double length(const std::vector<Vec2>& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/// Two crossings a piece, at 2 i and 2 i + 1.
std::vector<Crossing> cross_faces(const TriangleMesh& mesh, const Vec2& towards) {
  const Eigen::VectorXd side =
      mesh.vertices_mm.col(1) * towards.x() - mesh.vertices_mm.col(0) * towards.y();
  std::vector<char> left(static_cast<std::size_t>(side.size()));
  for (std::size_t v = 0; v < left.size(); ++v) left[v] = side[static_cast<Index>(v)] >= 0.0;
  std::vector<Crossing> crossings;
  const int* corners = mesh.faces.data();
  for (Eigen::Index f = 0; f < mesh.faces.rows(); ++f, corners += 3) {
    // Of hundreds of half-planes each crosses few faces.
    const auto lies_left = [&](int k) { return left[static_cast<std::size_t>(corners[k])]; };
    if (lies_left(0) == lies_left(1) && lies_left(1) == lies_left(2)) continue;
    const std::size_t before = crossings.size();
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(mesh.faces(f, k), mesh.faces(f, (k + 1) % 3));
      const int b = std::max(mesh.faces(f, k), mesh.faces(f, (k + 1) % 3));
      if ((side[a] >= 0.0) == (side[b] >= 0.0)) continue;
      const double share = side[a] / (side[a] - side[b]);
      const Vec3 p =
          mesh.vertices_mm.row(a) + share * (mesh.vertices_mm.row(b) - mesh.vertices_mm.row(a));
      crossings.push_back({{a, b}, {p.head<2>().dot(towards), p.z()}, before / 2});
    }
    if (crossings[before].point.x() + crossings[before + 1].point.x() <= 0.0)
      crossings.resize(before);
  }
  return crossings;
}

/// The other end of the piece of crossing `i`.
std::size_t across(std::size_t i) { return i ^ 1U; }

std::vector<Chain> chain_up(const std::vector<Crossing>& crossings, int sheet) {
  std::vector<std::size_t> order(crossings.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return crossings[i].edge != crossings[j].edge ? crossings[i].edge < crossings[j].edge : i < j;
  });
  // The crossing of the next piece at the same edge, itself at a boundary. Where more than two
  // faces meet, the third is left to a chain of its own.
  std::vector<std::size_t> partner(crossings.size());
  for (std::size_t i = 0; i < order.size(); ++i) partner[order[i]] = order[i];
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    if (crossings[order[i]].edge != crossings[order[i + 1]].edge) continue;
    partner[order[i]] = order[i + 1];
    partner[order[i + 1]] = order[i];
    ++i;
  }
  std::vector<bool> used(crossings.size() / 2, false);
  std::vector<Chain> chains;
  const auto follow = [&](std::size_t start) {
    Chain chain{{crossings[start].point}, sheet};
    for (std::size_t i = start; !used[crossings[i].piece]; i = partner[across(i)]) {
      used[crossings[i].piece] = true;
      chain.line.push_back(crossings[across(i)].point);
    }
    if (length(chain.line) >= kSpeck_mm) chains.push_back(std::move(chain));
  };
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (partner[i] == i && !used[crossings[i].piece]) follow(i);  // from a boundary
  }
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (!used[crossings[i].piece]) follow(i);  // closed loops
  }
  return chains;
}

/// Nearest point of a line, and the index of the line's point after it.
struct Nearest {
  Vec2 point;
  std::size_t after = 0;
  double distance = 1e300;
};

Nearest nearest_on(const std::vector<Vec2>& line, const Vec2& from) {
  Nearest best;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 along = line[i] - line[i - 1];
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0.0 ? std::clamp(along.dot(from - line[i - 1]) / length2, 0.0, 1.0) : 0.0;
    const Vec2 point = line[i - 1] + share * along;
    const double distance = (point - from).norm();
    if (distance < best.distance) best = {point, i, distance};
  }
  return best;
}

/// The chain that begins nearest to the annulus, turned to lead away from it, is appended to the
/// cut.
void begin_at_annulus(std::vector<Chain>& chains, double reach_mm, LeafletCut& cut) {
  const Vec2 annulus = cut.line_mm.front();
  Chain* first = nullptr;
  double least = reach_mm;
  for (Chain& chain : chains) {
    const double distance = nearest_on(chain.line, annulus).distance;
    if (distance > least) continue;
    least = distance;
    first = &chain;
  }
  if (first == nullptr) return;
  first->used = true;
  std::vector<Vec2>& line = first->line;
  if ((line.front() - annulus).norm() > (line.back() - annulus).norm())
    std::reverse(line.begin(), line.end());
  const Nearest start = nearest_on(line, annulus);
  cut.sheet = first->sheet;
  cut.line_mm.push_back(start.point);
  cut.line_mm.insert(cut.line_mm.end(), line.begin() + static_cast<std::ptrdiff_t>(start.after),
                     line.end());
}

/// Appends the next chain within `bridge_mm` that leads further from the annulus; false if there is
/// none.
bool bridge(std::vector<Chain>& chains, double bridge_mm, LeafletCut& cut) {
  const Vec2 annulus = cut.line_mm.front(), end = cut.line_mm.back();
  Chain* next = nullptr;
  double least = bridge_mm;
  for (Chain& chain : chains) {
    if (chain.used) continue;
    std::vector<Vec2>& line = chain.line;
    if ((line.front() - end).norm() > (line.back() - end).norm())
      std::reverse(line.begin(), line.end());
    const double distance = (line.front() - end).norm();
    if (distance > least || (line.back() - annulus).norm() <= (end - annulus).norm()) continue;
    least = distance;
    next = &chain;
  }
  if (next == nullptr) return false;
  next->used = true;
  cut.widest_bridge_mm = std::max(cut.widest_bridge_mm, least);
  cut.line_mm.insert(cut.line_mm.end(), next->line.begin(), next->line.end());
  return true;
}

}  // namespace

double LeafletCut::length_mm() const { return length(line_mm); }

LeafletCut cut_leaflets(const std::vector<TriangleMesh>& sheets, const Vec3& annulus_mm,
                        const CutOptions& options) {
  const Vec2 towards = annulus_mm.head<2>().normalized();
  std::vector<Chain> chains;
  for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet) {
    auto found = chain_up(cross_faces(sheets[sheet], towards), static_cast<int>(sheet));
    chains.insert(chains.end(), found.begin(), found.end());
  }
  LeafletCut cut;
  cut.line_mm.push_back({annulus_mm.head<2>().norm(), annulus_mm.z()});
  begin_at_annulus(chains, options.reach_mm, cut);
  if (cut.sheet < 0) cut.line_mm.clear();
  while (cut.sheet >= 0 && bridge(chains, options.bridge_mm, cut)) {
  }
  return cut;
}

}  // namespace coapt
