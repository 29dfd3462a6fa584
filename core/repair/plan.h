// A repair plan: what a surgeon does, in terms that do not depend on the mesh. Ranges: limits.h.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/valve/leaflet_coordinates.h"
#include "core/valve/valve.h"

namespace coapt {

/// A ring sutured to the annulus. Shape "own" scales the valve's own annulus by `sizes_below` sizes
/// (2 mm of the transverse dimension each, the others in proportion: U1 to U3 of thesis 4.2.3);
/// any other shape is one of the catalogue, labelled by its transverse size.
struct Annuloplasty {
  std::string shape = "own";
  double size_mm = 0.0;  ///< 24 to 40 in steps of 2, catalogue shapes only
  int sizes_below = 0;   ///< 0 to 6, shape "own" only
};

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

using RepairStep = std::variant<Annuloplasty, Neochorda, ChordalLengthChange, ChordalExcision,
                                ChordalTransfer, PapillaryApproximation>;

struct RepairPlan {
  std::vector<RepairStep> steps;
};

/// A ring's shape as shares of its transverse size; generic, not a manufacturer's.
struct RingShape {
  std::string name;
  double ap_over_transverse = 0.75;
  double transverse_factor = 1.0;       ///< true transverse width over labelled size
  double saddle_over_transverse = 0.0;  ///< height of the saddle
  std::string note;
};

Vec3 anchor_mm(const Valve& valve, const PapillaryApproximation& step);

const char* to_string(Anchor anchor);

}  // namespace coapt
