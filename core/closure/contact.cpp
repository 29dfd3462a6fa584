#include "core/closure/contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace coapt {
namespace {

constexpr double kMargin_mm = 0.6;  // how far ahead the list looks; larger: longer, rarer lists
constexpr double kRestShare = 0.8;  // of the rest distance: neighbours do not touch at rest
constexpr double kEdgeShare = 0.5;  // of the thickness, for pairs of edges
constexpr double kThinnestShare = 0.05;  // of the thickness: a rest shape that touches itself

Vec3 node(const Points& x, int i) { return x.row(i); }

/// Signed weights of the four nodes: their sum of products is the vector from the second to the
/// first feature.
using Weights = std::array<double, 4>;

Weights vertex_face_weights(const ContactPair& pair, const Points& x) {
  const auto& n = pair.nodes;
  const Vec3 w = closest_point_weights(node(x, n[0]), node(x, n[1]), node(x, n[2]), node(x, n[3]));
  return {1.0, -w[0], -w[1], -w[2]};
}

Weights edge_edge_weights(const ContactPair& pair, const Points& x) {
  const auto& n = pair.nodes;
  const auto [s, t] =
      closest_point_shares(node(x, n[0]), node(x, n[1]), node(x, n[2]), node(x, n[3]));
  return {1.0 - s, s, t - 1.0, -t};
}

Vec3 apart(const ContactPair& pair, const Weights& w, const Points& x) {
  return w[0] * node(x, pair.nodes[0]) + w[1] * node(x, pair.nodes[1]) +
         w[2] * node(x, pair.nodes[2]) + w[3] * node(x, pair.nodes[3]);
}

std::optional<Touch> touch(const ContactPair& pair, const Weights& w, const Points& x) {
  const Vec3 between = apart(pair, w, x);
  const double distance = between.norm();
  if (distance >= pair.thickness_mm || distance == 0.0) return std::nullopt;
  return Touch{
      pair.nodes,          w, between / distance, pair.thickness_mm, pair.thickness_mm - distance,
      pair.force_n_per_mm2};
}

Boxes boxes_around(const std::vector<std::array<int, 3>>& features, const Points& x,
                   double reach_mm) {
  const Index count = std::ssize(features);
  Boxes boxes{Points(count, 3), Points(count, 3)};
  for (Index i = 0; i < count; ++i) {
    const auto& f = features[i];
    boxes.low_mm.row(i) =
        x.row(f[0]).cwiseMin(x.row(f[1])).cwiseMin(x.row(f[2])).array() - reach_mm;
    boxes.high_mm.row(i) =
        x.row(f[0]).cwiseMax(x.row(f[1])).cwiseMax(x.row(f[2])).array() + reach_mm;
  }
  return boxes;
}

}  // namespace

ContactLaw edge_law(const ContactLaw& law) {
  return {kEdgeShare * law.thickness_mm, law.stiffness_n_per_mm4 / (kEdgeShare * kEdgeShare), true};
}

std::vector<int> vertices_of(const ClosureModel& model, const ContactSides& sides) {
  std::vector<int> first(model.vertices, kLeaflets - 1);
  for (std::size_t f = 0; f < model.leaflet.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      int& leaflet = first[model.faces(f, k)];
      leaflet = std::min(leaflet, model.leaflet[f]);
    }
  std::vector<int> vertices;
  for (int v = 0; v < model.vertices; ++v)
    if (sides.vertices[first[v]]) vertices.push_back(v);
  return vertices;
}

std::vector<int> faces_of(const ClosureModel& model, const ContactSides& sides) {
  std::vector<int> faces;
  for (int f = 0; f < static_cast<int>(model.faces.rows()); ++f)
    if (model.leaflet.empty() || sides.faces[model.leaflet[f]]) faces.push_back(f);
  return faces;
}

Vec3 closest_point_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {1.0 - v, v, 0.0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

std::pair<double, double> closest_point_shares(const Vec3& a, const Vec3& b, const Vec3& c,
                                               const Vec3& d) {
  const Vec3 ab = b - a, cd = d - c, ca = a - c;
  const double ab2 = ab.squaredNorm(), cd2 = cd.squaredNorm(), mixed = ab.dot(cd);
  const double along_ab = ab.dot(ca), along_cd = cd.dot(ca);
  const double denominator = ab2 * cd2 - mixed * mixed;
  double s = denominator > 1e-12 * ab2 * cd2
                 ? std::clamp((mixed * along_cd - along_ab * cd2) / denominator, 0.0, 1.0)
                 : 0.0;
  double t = (mixed * s + along_cd) / cd2;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((mixed * t - along_ab) / ab2, 0.0, 1.0);
  }
  return {s, t};
}

std::vector<std::pair<int, int>> overlapping(const Boxes& a, const Boxes& b) {
  const auto by_low = [](const Boxes& boxes) {
    std::vector<int> order(boxes.low_mm.rows());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      const double p = boxes.low_mm(i, 0), q = boxes.low_mm(j, 0);
      return p < q || (p == q && i < j);
    });
    return order;
  };
  const std::vector<int> order_a = by_low(a), order_b = by_low(b);
  std::vector<std::pair<int, int>> pairs;
  const auto test = [&](int i, int j) {
    if (a.low_mm(i, 1) <= b.high_mm(j, 1) && b.low_mm(j, 1) <= a.high_mm(i, 1) &&
        a.low_mm(i, 2) <= b.high_mm(j, 2) && b.low_mm(j, 2) <= a.high_mm(i, 2))
      pairs.emplace_back(i, j);
  };
  // The box that starts first meets all that start before it ends; each pair is met once.
  std::size_t m = 0, n = 0;
  while (m < order_a.size() && n < order_b.size()) {
    const int i = order_a[m], j = order_b[n];
    if (a.low_mm(i, 0) <= b.low_mm(j, 0)) {
      for (std::size_t k = n; k < order_b.size() && b.low_mm(order_b[k], 0) <= a.high_mm(i, 0); ++k)
        test(i, order_b[k]);
      ++m;
    } else {
      for (std::size_t k = m; k < order_a.size() && a.low_mm(order_a[k], 0) <= b.high_mm(j, 0); ++k)
        test(order_a[k], j);
      ++n;
    }
  }
  return pairs;
}

double pair_thickness_mm(const ContactLaw& law, const ClosureModel& model,
                         const std::array<int, 4>& nodes, bool edges) {
  const ContactPair pair{nodes, 0.0, 0.0};
  const Weights w =
      edges ? edge_edge_weights(pair, model.rest_mm) : vertex_face_weights(pair, model.rest_mm);
  return std::clamp(kRestShare * apart(pair, w, model.rest_mm).norm(),
                    kThinnestShare * law.thickness_mm, law.thickness_mm);
}

void Contact::add_candidate(const ClosureModel& model, const std::array<int, 4>& nodes,
                            bool edges) {
  const ContactLaw law = edges ? edge_law(law_) : law_;
  ContactPair pair{nodes, pair_thickness_mm(law, model, nodes, edges), 0.0};
  const auto area = [&](int n) { return model.area_mm2[n]; };
  const double shared =
      edges ? 0.25 * (area(nodes[0]) + area(nodes[1]) + area(nodes[2]) + area(nodes[3]))
            : area(nodes[0]);
  pair.force_n_per_mm2 = law.stiffness_n_per_mm4 * shared * law.thickness_mm / pair.thickness_mm;
  (edges ? edges_ : faces_).push_back(pair);
}

void Contact::renew(const ClosureModel& model, const Points& x) {
  listed_at_ = x.topRows(model.vertices);
  faces_.clear();
  edges_.clear();
  const double reach = 0.5 * (law_.thickness_mm + kMargin_mm);
  for (const ContactSides& sides : contact_sides(law_.self)) {
    const std::vector<int> vertex = vertices_of(model, sides), face = faces_of(model, sides);
    std::vector<std::array<int, 3>> vertices, faces;
    for (const int v : vertex) vertices.push_back({v, v, v});
    for (const int f : face)
      faces.push_back({model.faces(f, 0), model.faces(f, 1), model.faces(f, 2)});
    for (const auto& [i, j] :
         overlapping(boxes_around(vertices, x, reach), boxes_around(faces, x, reach))) {
      const int v = vertex[i];
      const auto& n = faces[j];
      if (n[0] != v && n[1] != v && n[2] != v) add_candidate(model, {v, n[0], n[1], n[2]}, false);
    }
  }
  std::vector<std::array<int, 3>> edges;
  for (const auto& [a, b] : law_.edges ? model.edges : edges_of(model.faces, guarded_faces_))
    edges.push_back({a, b, b});
  if (edges.empty()) return;
  const Boxes boxes = boxes_around(edges, x, 0.5 * (edge_law(law_).thickness_mm + kMargin_mm));
  for (const auto& [i, j] : overlapping(boxes, boxes)) {
    const auto &e = edges[i], &g = edges[j];
    if (i < j && e[0] != g[0] && e[0] != g[1] && e[1] != g[0] && e[1] != g[1])
      add_candidate(model, {e[0], e[1], g[0], g[1]}, true);
  }
}

void Contact::renew_if_old(const ClosureModel& model, const Points& x) {
  if (listed_at_.rows() == 0 ||
      (x.topRows(model.vertices) - listed_at_).rowwise().squaredNorm().maxCoeff() >
          0.25 * kMargin_mm * kMargin_mm)
    renew(model, x);
}

template <class Function>
void Contact::for_each_touch(const Points& x, const Function& function) const {
  for (const ContactPair& pair : faces_) {
    const Vec3 a = node(x, pair.nodes[1]);
    const Vec3 normal = (node(x, pair.nodes[2]) - a).cross(node(x, pair.nodes[3]) - a);
    const double offset = normal.dot(node(x, pair.nodes[0]) - a);
    // The plane is nearer than the triangle: most candidates end here.
    if (offset * offset >= pair.thickness_mm * pair.thickness_mm * normal.squaredNorm()) continue;
    if (const auto found = touch(pair, vertex_face_weights(pair, x), x)) function(*found);
  }
  for (const ContactPair& pair : edges_)
    if (const auto found = touch(pair, edge_edge_weights(pair, x), x)) function(*found);
}

void Contact::add_forces(const ClosureModel& model, const Points& x, Points& force) {
  renew_if_old(model, x);
  for_each_touch(x, [&](const Touch& t) {
    const Vec3 f = (t.force_n_per_mm2 * t.gap_mm * t.gap_mm) * t.direction;
    for (std::size_t k = 0; k < 4; ++k) force.row(t.nodes[k]) += t.weights[k] * f;
  });
}

std::vector<Touch> Contact::touches(const ClosureModel& model, const Points& x) {
  renew_if_old(model, x);
  std::vector<Touch> all;
  for_each_touch(x, [&](const Touch& t) { all.push_back(t); });
  return all;
}

}  // namespace coapt
