// Papillary approximation and its robustness (thesis 4.2.3, figure 4.10), by four protocols.
//
// A displaced muscle moves straight to its anchor until the orifice is below 5 mm2 (Optimum: to
// where mean + sd over 9 points of its region and the price of the movement, search/objective.h,
// are lowest). Around the place where it ends lies the region of interest (search/perturbation.h):
// 1,089 nodes on and about the sphere around the anchor. Positions are in displacement space
// (anchor_sites.h).
#pragma once

#include <string>
#include <vector>

#include "search/studies/anchor_sites.h"
#include "search/studies/orifice_field.h"

namespace coapt {

/// Over the nodes of the region of interest.
struct RegionOrifice {
  double mean_mm2 = 0.0, sd_mm2 = 0.0, worst_mm2 = 0.0;
  double length_sd_mm2 = 0.0;            ///< what of sd goes in proportion with the suture's length
  double angle_sd_mm2 = 0.0;             ///< likewise with the two angles (linear regression)
  double length_slope_mm2_per_mm = 0.0;  ///< of that regression: orifice per mm of suture
  double swing_slope_mm2_per_mm = 0.0;   ///< per mm that the tip swings in the steepest direction
  double leaking_share = 0.0;            ///< of nodes above 5 mm2
  double clamped_share = 0.0;            ///< of nodes outside the grid (LookupClamped)
};

struct Approximation {
  Displaced displaced = Displaced::Anterolateral;
  Vec3 displaced_mm = Vec3::Zero();
  double displaced_area_mm2 = 0.0;
  std::size_t anchor = 0;  ///< index into the anchors
  /// Below 5 mm2 no later than half way to the anchor; if not, what follows is of where it leaked
  /// least.
  bool repaired = false;
  Vec3 position_mm = Vec3::Zero();
  double suture_mm = 0.0;  ///< from tip to anchor
  double movement_mm = 0.0;
  double area_mm2 = 0.0;  ///< there
  RegionOrifice region;
};

struct ApproximationOptions {
  double displacement_step_mm = 1.0;  ///< of those displaced, 0 to 6 mm along each axis
  int region_points = 1089;           ///< the first of region_of_interest()
  double least_mm2 = 5.0;             ///< displaced configurations that leak less are left alone
};

struct ApproximationStudy {
  Protocol protocol = Protocol::LookupExtended;
  std::vector<AnchorSite> anchors;
  ApproximationOptions options;
  std::vector<Approximation> approximations;  ///< by class, displacement, anchor
};

ApproximationStudy study_approximation(OrificeTable& table, Protocol protocol,
                                       const std::vector<AnchorSite>& anchors,
                                       const ApproximationOptions& options = {});

}  // namespace coapt
