// Self-contact of the leaflets as a C1 penalty between vertices and triangles.
//
// Broad phase: sweep and prune of vertex and triangle boxes along x, kept as a list that stays
// valid until some node has moved half its margin (temporal coherence, thesis 2.2.3). Narrow phase:
// exact closest point; contact pressure stiffness x (h - d)^2 on the vertex's rest area for d < h,
// every pair in range, equal and opposite on the triangle. With `edges` also pairs of edges, on the
// area around both and from half the thickness on: it stops the sharp folds of surplus tissue from
// passing through each other edge by edge, for twice the cost; the closure asks for it when needed.
// Only pairs that share a vertex are left out. Near neighbours would touch already at rest: a
// pair's thickness is at most 0.8 of its rest distance, and its stiffness grows by the same factor.
// Leaving pairs out by rest distance instead lets the leaflets cross at the commissures.
#pragma once

#include <utility>
#include <vector>

#include "core/closure/model.h"
#include "core/closure/self_contact.h"

namespace coapt {

struct ContactLaw {
  double thickness_mm = 1.0;
  double stiffness_n_per_mm4 = 0.74;
  bool edges = false;
  SelfContact self = SelfContact::All;

  bool operator==(const ContactLaw&) const = default;
};

/// The vertices of those leaflets (each of the first that has it) and the faces, in ascending
/// order.
std::vector<int> vertices_of(const ClosureModel& model, const ContactSides& sides);
std::vector<int> faces_of(const ClosureModel& model, const ContactSides& sides);

/// The law between edges: only a net under that of vertices and faces, at a share of its thickness
/// and with the same largest pressure.
ContactLaw edge_law(const ContactLaw& law);

/// Closest point of triangle (a, b, c) to p, as barycentric weights (Ericson 2005, 5.1.5).
Vec3 closest_point_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Closest points of segments (a, b) and (c, d), as shares of their lengths (Ericson 2005, 5.1.9).
std::pair<double, double> closest_point_shares(const Vec3& a, const Vec3& b, const Vec3& c,
                                               const Vec3& d);

/// Two features, a vertex and a face or two edges, as a difference of four weighted nodes.
struct ContactPair {
  std::array<int, 4> nodes = {0, 0, 0, 0};  ///< vertex, then face; or edge, then edge
  double thickness_mm = 0.0;
  double force_n_per_mm2 = 0.0;  ///< force = this x (thickness - distance)^2
};

/// Axis-aligned boxes, |n| x 3 corners.
struct Boxes {
  Points low_mm, high_mm;
};

/// All pairs (i, j) whose boxes a_i and b_j overlap, in the order of a sweep along x (sweep and
/// prune).
std::vector<std::pair<int, int>> overlapping(const Boxes& a, const Boxes& b);

/// A pair's own thickness: what the law says, but at most 0.8 of the distance at rest, mm.
double pair_thickness_mm(const ContactLaw& law, const ClosureModel& model,
                         const std::array<int, 4>& nodes, bool edges);

/// A pair nearer than its thickness. Moving node k by d moves the first feature off the second one
/// by weights[k] x d . direction.
struct Touch {
  std::array<int, 4> nodes = {0, 0, 0, 0};
  std::array<double, 4> weights = {0.0, 0.0, 0.0, 0.0};  ///< signed
  Vec3 direction = Vec3::Zero();                         ///< unit, from second to first feature
  double thickness_mm = 0.0;
  double gap_mm = 0.0;           ///< thickness - distance
  double force_n_per_mm2 = 0.0;  ///< force = this x gap^2
};

/// The list of candidate pairs and where it was made.
class Contact {
 public:
  /// `guarded_faces`: their edges have contact among each other where the law has none of edges.
  explicit Contact(const ContactLaw& law, std::vector<int> guarded_faces = {})
      : law_(law), guarded_faces_(std::move(guarded_faces)) {}
  /// Adds contact forces, N; renews the candidates when they may be out of date.
  void add_forces(const ClosureModel& model, const Points& x, Points& force);
  /// The pairs that push, in the order of add_forces; renews the candidates likewise.
  std::vector<Touch> touches(const ClosureModel& model, const Points& x);

 private:
  void renew_if_old(const ClosureModel& model, const Points& x);
  void renew(const ClosureModel& model, const Points& x);
  template <class Function>
  void for_each_touch(const Points& x, const Function& function) const;
  void add_candidate(const ClosureModel& model, const std::array<int, 4>& nodes, bool edges);

  ContactLaw law_;
  std::vector<int> guarded_faces_;
  Points listed_at_;  // |V| x 3, empty before the first list
  std::vector<ContactPair> faces_, edges_;
};

}  // namespace coapt
