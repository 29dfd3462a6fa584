// A valve from a dozen anatomical dimensions, at any resolution.
//
// A contour (dimensions or a measurement) is cut into stations of equal arc between the landmarks;
// from each hangs a row of vertices, inclined inwards, as long as the leaflet is high there.
// Chordae: per muscle three heads, five marginal trunks that branch in three, one strut and two
// basal chordae, placed in leaflet coordinates, so that they mean the same at every resolution.
// Their lengths reach from the tip to where an idealised closed leaflet has the insertion;
// core/presets takes them from a closure.
#pragma once

#include <optional>
#include <string>

#include "core/valve/valve.h"

namespace coapt {

/// How the posteromedial half differs from the anterolateral one. Each value is half the
/// difference: it is added on the posteromedial side and taken away on the anterolateral one.
struct Asymmetry {
  Vec3 tip_mm = Vec3::Zero();   ///< transverse (outwards), posterior, apical
  double leaflet_height = 0.0;  ///< share of the height at the commissures, nothing at the midline
  double slack = 0.0;           ///< of the chordae
};

/// Lengths of chordae over their lengths in the closed, pressurised valve.
struct ChordalSlack {
  double anterior = 1.0, posterior = 1.0,
         commissural = 1.0;  ///< marginal, by held_by() in ruptures.h
  double strut = 1.0;
  double basal = 1.0;

  bool operator==(const ChordalSlack&) const = default;
};

/// Ranges stand in dimension_table.h.
struct ParametricValve {
  std::string name = "parametric";
  double ap_mm = 29.0;     ///< anteroposterior diameter of the annulus under pressure
  double al_pm_mm = 39.0;  ///< transverse diameter
  // Left out, these are a human valve's, in proportion to the annulus: see proportions(). Heights
  // are those of the unpressurised heart with the default tissue, else as tissue.reference says.
  std::optional<double> saddle_height_mm;
  std::optional<double> anterior_height_mm;   ///< A2
  std::optional<double> posterior_height_mm;  ///< P2
  std::optional<double> lateral_height_mm;    ///< P1, P3
  std::optional<double> commissure_height_mm;
  double cleft_depth_mm = 0.5;  ///< between the posterior scallops
  /// Height at the free edge of folds where P1 and P3 meet P2, outwards, and where A1 and A3 meet A2, inwards: tissue that unfolds
  /// in diastole, as clefts do. No source gives sizes.
  double posterior_fold_mm = 0.0, anterior_fold_mm = 0.0;
  double anterior_arc = 0.38;  ///< share of the annulus from commissure to commissure
  /// Of the unpressurised leaflets, inwards from the vertical; each of its own leaflet, blended at the commissures.
  double anterior_inclination_deg = 20.0, posterior_inclination_deg = 20.0;
  double tip_depth_mm = 23.5;     ///< papillary tips below the annulus plane
  double tip_spread_mm = 26.0;    ///< between the tips, transverse
  double tip_posterior_mm = 4.0;  ///< tips behind the annulus centre
  double trigone_share = 0.66;    ///< trigones, share of the arc from saddle peak to commissure
  ChordalSlack slack;
  Asymmetry asymmetry;
  Tissue tissue{.reference = TissueReference::InVivo};
  std::optional<double> pressure_mmhg;  ///< left out: Valve::pressure_kpa's own
  SystolicMotion systole;
  int triangles = 650;  ///< aimed at; the nearest structured mesh is made
  /// A measured contour instead of the diameters, any frame. A planar one (a projection: the
  /// annulus under pressure is a saddle) is given the saddle height; 0 leaves it planar.
  std::optional<Points> annulus_mm;
  std::optional<Points> tips_mm;  ///< measured papillary attachments, required with annulus_mm
  std::string annulus_source, tips_source;  ///< files they come from, for the provenance
};

struct Proportions {
  double saddle_height_mm = 6.8;
  double anterior_height_mm = 23.5;
  double posterior_height_mm = 15.25;
  double lateral_height_mm = 14.25;
  double commissure_height_mm = 9.0;
};

/// The heights that are given, and for the others a human valve's of 29 x 39 mm (the defaults of
/// Proportions): A2 and P2 scale with the anteroposterior diameter that they close, the rest with
/// the transverse one.
Proportions proportions(const ParametricValve& dimensions, double ap_mm, double al_pm_mm);

/// Errors that point to names of dimension_table() ("/ap_mm", ...), "/triangles", "/annulus_mm" and "/tips_mm".
Errors check_dimensions(const ParametricValve& dimensions);

/// Errors as of check_dimensions(), or of the measured contour.
Expected<Valve> make_parametric_valve(const ParametricValve& dimensions);

}  // namespace coapt
