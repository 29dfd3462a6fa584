// Which of two sheets is the anterior leaflet: anatomy says it, before names, and names before numbers and the order of files.
//
// Three signs, each a log-likelihood ratio of two normal distributions, added up:
// - the share of the annulus that a sheet is the nearest to: 0.36 of the anterior leaflet (27 to 45 % in twelve valves, of hearts and
//   published sets), 0.64 of the posterior one, standard deviation 0.07; at most 8;
// - its height, the farthest that it reaches from the annulus, over that of the other: anterior e^0.4, standard deviation e^0.35; at most 2;
// - how far the annulus rises at its middle over where the other has its own, towards the atrium: the saddle peak is
//   mitral-aortic; 1.5 mm, standard deviation 2; at most 1.5.
// Limits: the shares of a tricuspid or a congenitally malformed valve are others.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

/// What the two sheets look like.
struct LeafletSigns {
  std::array<double, 2> share = {0.5, 0.5};  ///< of the annulus
  std::array<double, 2> height_mm = {0, 0};  ///< over the annulus, to the free edge
  double rise_mm = 0.0;                      ///< of the annulus at the first, over it at the second
  double first_is_anterior = 0.5;            ///< 0 to 1
};

/// Lengths must be millimetres. @pre two sound sheets, an annulus of three points or more
LeafletSigns leaflet_signs(const std::vector<TriangleMesh>& leaflets, const Points& annulus_mm);

/// A claim that stands against what the sheets look like: from this share of the annulus on the claimed anterior leaflet is refused.
inline constexpr double kRefusedShare = 0.6;

struct SettledOrder {
  bool swapped = false;
  std::vector<ImportDecision> decisions;  ///< one, of two sheets
};

/// Changes the order of the leaflets where nobody but their order says which is which, and they look the other way round. Errors:
/// at "/leaflets/0", a claim of the user or of a name that is plainly wrong, unless it is to be trusted.
Expected<SettledOrder> settle_leaflet_order(ImportSource& source, bool trust_labels);

}  // namespace coapt
