#include "core/metrics/gap.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <queue>

#include "core/metrics/leaflet_sides.h"
#include "core/metrics/side_net.h"
#include "core/metrics/surface_tree.h"

namespace coapt {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kOutermost = 1e-9;  // share of the line between the commissures

/// Area over a length along which the width changes linearly; where it is negative there is none.
double area_between(double width, double other_width, double length_mm) {
  const auto [less, more] = std::minmax({width, other_width});
  if (more <= 0.0) return 0.0;
  if (less >= 0.0) return 0.5 * (less + more) * length_mm;
  return 0.5 * more * more / (more - less) * length_mm;
}

const auto kJoined = [] {
  std::array<std::array<bool, kNodesOfFace>, kNodesOfFace> table{};
  for (int i = 0; i < kNodesOfFace; ++i)
    for (int j = 0; j < kNodesOfFace; ++j)
      table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = joined(i, j);
  return table;
}();

/// A step that may be worth taking. Its area is a lower bound as long as the distance at its end is
/// not known: from one node to the next it changes by their distance at most.
struct Step {
  double area_mm2 = 0.0;  // of the way to `to`
  double left = 0.0;      // of the way to the other commissure
  int to = 0, from = -1;
  bool is_exact = false;
};

/// For a queue: the smallest area first. Where leaflets touch, all have none, and the step nearest
/// to the goal is the first; there the search runs straight on.
struct Later {
  bool operator()(const Step& a, const Step& b) const {
    if (a.area_mm2 != b.area_mm2) return a.area_mm2 > b.area_mm2;
    if (a.left != b.left) return a.left > b.left;
    return a.to != b.to ? a.to > b.to : a.from > b.from;
  }
};

class LineSearch {
 public:
  LineSearch(const SideNet& net, const SurfaceTree& other, double thickness_mm)
      : net_(net), other_(other), thickness_mm_(thickness_mm), nodes_(net.nodes_mm.size()) {}

  double run() {
    for (const int start : ends(false)) queue_.push({0.0, 0.0, start, -1, true});
    for (const int goal : ends(true)) node(goal).is_goal = true;
    while (true) {
      if (queue_.empty() && !bridge()) return kUnreached;
      const Step step = queue_.top();
      queue_.pop();
      Node& to = node(step.to);
      if (to.is_settled) continue;
      if (!step.is_exact) {
        push(step.from, step.to, true);
        continue;
      }
      look_across(step.to, step.from);
      to.is_settled = true;
      to.area_mm2 = step.area_mm2;
      if (to.is_goal) return to.area_mm2;
      leave(step.to);
    }
  }

 private:
  struct Node {
    std::optional<TreePoint> across;
    double area_mm2 = kUnreached;  // of the best way known
    bool is_settled = false, is_goal = false;
  };

  Node& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  const Vec3& place(int i) const { return net_.nodes_mm[static_cast<std::size_t>(i)]; }
  double width(int i) { return node(i).across->distance_mm - thickness_mm_; }

  /// Where lines end, at the anterolateral (or the posteromedial) commissure.
  std::vector<int> ends(bool posteromedial) const {
    std::vector<int> ends;
    double outermost = posteromedial ? -kUnreached : kUnreached;
    for (int v = 0; v < net_.vertices; ++v) {
      const double along = net_.along[static_cast<std::size_t>(v)];
      outermost = posteromedial ? std::max(outermost, along) : std::min(outermost, along);
      if (net_.shared[static_cast<std::size_t>(v)] && (along > 0.5) == posteromedial)
        ends.push_back(v);
    }
    if (!ends.empty()) return ends;
    for (int v = 0; v < net_.vertices; ++v)
      if (std::abs(net_.along[static_cast<std::size_t>(v)] - outermost) < kOutermost)
        ends.push_back(v);
    return ends;
  }

  void look_across(int i, int neighbour) {
    Node& at = node(i);
    if (at.across) return;
    const int hint = neighbour < 0 ? -1 : node(neighbour).across->face;
    at.across = other_.nearest(place(i), kUnreached, hint);
  }

  void push(int from, int to, bool exactly) {
    if (node(to).area_mm2 <= node(from).area_mm2) return;
    const double own_mm = (place(to) - place(from)).norm();
    // A way through contact costs nothing, wherever it ends; most that begin there are never needed.
    if (exactly || width(from) > 0.0) look_across(to, from);
    exactly = node(to).across.has_value();
    // Of a place that is not known the nearest point may stay, and be nearer by all of the way.
    const double other_mm =
        exactly ? (node(to).across->point_mm - node(from).across->point_mm).norm() : 0.0;
    const double area_mm2 =
        node(from).area_mm2 + area_between(width(from), exactly ? width(to) : width(from) - own_mm,
                                           0.5 * (own_mm + other_mm));
    if (area_mm2 >= node(to).area_mm2) return;
    if (exactly) node(to).area_mm2 = area_mm2;
    queue_.push({area_mm2, left(to), to, from, exactly});
  }

  double left(int i) const { return 1.0 - net_.along[static_cast<std::size_t>(i)]; }

  void leave(int from) {
    const auto i = static_cast<std::size_t>(from);
    for (int at = net_.first_face[i]; at < net_.first_face[i + 1]; ++at) {
      const int f = net_.node_faces[static_cast<std::size_t>(at)];
      const auto& face = net_.faces[static_cast<std::size_t>(f)];
      const auto own =
          static_cast<std::size_t>(std::find(face.begin(), face.end(), from) - face.begin());
      for (std::size_t k = 0; k < face.size(); ++k)
        if (kJoined[own][k] && !node(face[k]).is_settled) push(from, face[k], false);
    }
  }

  /// From the vertices that have been reached to those that cannot be.
  bool bridge() {
    for (int from = 0; from < net_.vertices; ++from)
      for (int to = 0; node(from).is_settled && to < net_.vertices; ++to)
        if (!node(to).is_settled) push(from, to, true);
    return !queue_.empty();
  }

  const SideNet& net_;
  const SurfaceTree& other_;
  double thickness_mm_;
  std::vector<Node> nodes_;
  std::priority_queue<Step, std::vector<Step>, Later> queue_;
};

}  // namespace

double gap_mm2(const Valve& valve, const Points& closed_mm) {
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  const SideNet net = make_side_net(valve, closed_mm, sides, Leaflet::Anterior);
  const SurfaceTree posterior = surface_of(valve, closed_mm, sides, Leaflet::Posterior);
  if (net.faces.empty() || posterior.faces().rows() == 0) return kUnreached;
  return LineSearch(net, posterior, valve.tissue.thickness_mm).run();
}

}  // namespace coapt
