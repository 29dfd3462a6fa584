// Where a papillary suture may be anchored, seen from the displaced tips.
//
// Displacement space: (transverse, posterior, apical) of a muscle's tip from where the valve has
// it, mm. An anchor is a point there, too. For both muscles displaced alike it is the mean of the
// two (the thesis's mean papillary-to-anchor vector, 4.4.2).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "search/studies/configuration.h"

namespace coapt {

struct AnchorSite {
  std::string name;  ///< "trigone", "saddle peak", "annulus"
  /// Share of the annulus (LeafletCoordinates::around) for the posteromedial muscle; the
  /// anterolateral one takes its mirror image.
  double around = 0.0;
  std::array<Vec3, 3> at_mm;  ///< order of kDisplaced
};

/// The ipsilateral trigone, and the saddle peak (thesis 4.2.3).
std::vector<AnchorSite> thesis_anchors(const Valve& valve);

/// `count` places evenly around the annulus.
std::vector<AnchorSite> annulus_scan(const Valve& valve, int count);

}  // namespace coapt
