// A repair plan: what a surgeon does, in terms that do not depend on the mesh. Ranges: limits.h.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "core/repair/ring_terms.h"
#include "core/valve/leaflet_point.h"
#include "core/valve/valve.h"

namespace coapt {

/// The valve's own annulus, smaller by sizes of 2 mm of the transverse dimension, the others in
/// proportion: U1 to U3 of thesis 4.2.3.
struct OwnRing {
  int sizes_below = 0;  ///< 0 to 6
};

/// A ring of the catalogue (rings.h), labelled by its transverse size.
struct CatalogueRing {
  std::string shape;
  double size_mm = 0.0;  ///< 24 to 40 in steps of 2
};

/// A shape of one's own, with the name by which plans, rules and branches know it.
struct DesignedShape {
  std::string name;  ///< check_designed_shape()
  RingTerms terms;

  bool operator==(const DesignedShape&) const = default;
};

/// A ring of a designed shape, labelled by its true width.
struct DesignedRing {
  DesignedShape shape;
  double size_mm = 0.0;  ///< 24 to 40 in steps of 2
};

/// A ring sutured to the annulus.
struct Annuloplasty {
  std::variant<OwnRing, CatalogueRing, DesignedRing> ring;
};

inline constexpr const char* kOwnShape = "own";  ///< of an OwnRing, in plans, rules and branches
inline constexpr const char* kDesignedShape = "designed";  ///< of any DesignedRing, in plans

/// kOwnShape, or the name in the catalogue, or the designed shape's.
std::string shape_of(const Annuloplasty& step);

/// ePTFE suture from a papillary head to the leaflet.
struct Neochorda {
  std::string head;  ///< PapillaryHead::id
  LeafletPoint insertion;
  double length_mm = 0.0;  ///< 5 to 40
};

struct ChordalLengthChange {
  std::string chorda;      ///< Chorda::id
  double change_mm = 0.0;  ///< -20 to 20, of its trunk; negative shortens
};

struct ChordalExcision {
  std::string chorda;
};

/// The chorda's insertions move to a new point.
struct ChordalTransfer {
  std::string chorda;
  LeafletPoint insertion;
};

enum class Anchor { IpsilateralTrigone, SaddlePeak, AnnulusPoint };

/// A suture ties the papillary muscle to the annulus; its heads move together along the line from
/// their mean tip to the anchor until the suture is taut (thesis 4.2.3).
struct PapillaryApproximation {
  Side side = Side::Anterolateral;
  Anchor anchor = Anchor::IpsilateralTrigone;
  double annulus_around = 0.25;   ///< AnnulusPoint only, as LeafletCoordinates::around
  double suture_length_mm = 0.0;  ///< 12 to 100
};

enum class EdgeDevice { Stitch, Clip, CleftSuture };

/// Opposite points of the leaflets' free edges are held together: a stitch along the edges (Alfieri), or a clip, whose arms hold
/// the leaflets above them, too, and which draws the annulus in. Or the two edges of a cleft of the posterior leaflet are.
struct EdgeToEdge {
  EdgeDevice device = EdgeDevice::Stitch;
  double along = 0.5;  ///< of both edges, or of a cleft's root, LeafletPoint::along; 0.5: A2 to P2
  double width_mm = 4.0;  ///< along the edges, of a cleft from its root: 2 to 15
  // Of a clip alone (edge_to_edge.h has sizes and sources).
  double grasp_mm = 5.0;  ///< of each leaflet between the arms, from the free edge: 2 to 12
  int rows = 2;           ///< of ties over that: 1 to 5
  /// By which the anteroposterior diameter gets smaller, 0 to 25; nothing behind a ring.
  double annulus_drawn_in_percent = 11.0;
};

enum class ResectionShape { Triangular, Quadrangular };

/// Tissue of a leaflet is cut out, and the edges of the cut are sewn together.
struct LeafletResection {
  Leaflet leaflet = Leaflet::Posterior;  ///< Quadrangular: the posterior one
  ResectionShape shape = ResectionShape::Triangular;
  double along = 0.5;      ///< of its middle, LeafletPoint::along
  double width_mm = 10.0;  ///< along the free edge
  double height = 0.7;     ///< Triangular: from the free edge, as a share of the way to the annulus
  /// Quadrangular: what is left is spread over the posterior annulus; else the annulus is gathered.
  bool sliding = true;
};

using RepairStep =
    std::variant<Annuloplasty, Neochorda, ChordalLengthChange, ChordalExcision, ChordalTransfer,
                 PapillaryApproximation, EdgeToEdge, LeafletResection>;

struct RepairPlan {
  std::vector<RepairStep> steps;
};

template <class Step>
bool has_step(const RepairPlan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [](const RepairStep& step) { return std::holds_alternative<Step>(step); });
}

Vec3 anchor_mm(const Valve& valve, const PapillaryApproximation& step);

const char* to_string(Anchor anchor);
const char* to_string(EdgeDevice device);
const char* to_string(ResectionShape shape);

}  // namespace coapt
