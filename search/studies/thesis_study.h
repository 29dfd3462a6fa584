// Chapter 4 of the thesis, redone on any valve.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "search/studies/anchor_summary.h"
#include "search/studies/geometry_studies.h"

namespace coapt {

struct ThesisStudyOptions {
  int papillary_nodes = 7;  ///< along each axis, 0 to 6 mm; the thesis's 7 or, quicker, 4
  std::vector<Protocol> protocols = {Protocol::LookupClamped, Protocol::LookupExtended};
  ApproximationOptions approximation;
  /// Anchors around the annulus, 0: none. By LookupExtended if it is among the protocols, else the
  /// first of them.
  int scan_sites = 24;
  /// Told of the part that begins.
  std::function<void(const std::string&)> stage;
};

/// Papillary approximation to trigone and saddle peak, by protocol, and to places around the
/// annulus.
struct AnchorStudies {
  std::vector<ApproximationStudy> approximation;
  std::vector<AnchorSummary> scan;
};

AnchorStudies study_anchors(OrificeTable& table, const ThesisStudyOptions& options = {});

struct ThesisStudy {
  AnnulusStudy annulus;
  PapillaryStudy papillary;
  RingStudy ring;
  AnchorStudies anchors;
  /// How the middles of A1, A2, A3 move when the anterolateral tips go 6 mm outwards (thesis 4.4);
  /// the valve's frame; NaN where the displaced valve cannot be made.
  std::array<Vec3, 3> belly_shift_mm;
};

ThesisStudy study_thesis(OrificeTable& table, const ThesisStudyOptions& options = {});

}  // namespace coapt
