// An approximation study in few numbers: each anchor over all displaced configurations of a class.
#pragma once

#include <string>
#include <vector>

#include "search/studies/approximation_study.h"

namespace coapt {

/// Share of the saddle peak's value within which two anchors are a tie.
inline constexpr double kAnchorTie = 0.01;

/// One anchor over all displaced configurations of a class: means, but for sd_of_means; movement
/// and suture over those that are repaired (NaN if there is none).
struct AnchorSummary {
  Protocol protocol = Protocol::LookupExtended;
  Displaced displaced = Displaced::Anterolateral;
  AnchorSite anchor;
  int configurations = 0, repaired = 0;
  double mean_mm2 = 0.0, sd_mm2 = 0.0, sd_of_means_mm2 = 0.0;
  double length_sd_mm2 = 0.0, angle_sd_mm2 = 0.0;
  double length_slope_mm2_per_mm = 0.0, swing_slope_mm2_per_mm = 0.0;
  double movement_mm = 0.0, suture_mm = 0.0, leaking_share = 0.0, clamped_share = 0.0;
};

/// By class, then anchor; classes without a leaking configuration are left out.
std::vector<AnchorSummary> summarise(const ApproximationStudy& study);

/// Null if it is not there.
const AnchorSummary* find_summary(const std::vector<AnchorSummary>& summaries, Protocol protocol,
                                  Displaced displaced, const std::string& anchor);

/// Trigone against saddle peak on the same displaced configurations.
struct PairedAnchors {
  int configurations = 0;
  int smaller_mean = 0, smaller_sd = 0;  ///< the trigone's region has less
};
PairedAnchors pair_anchors(const ApproximationStudy& study, Displaced displaced);

}  // namespace coapt
