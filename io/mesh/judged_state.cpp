#include "io/mesh/judged_state.h"

#include <algorithm>

#include "core/valve/contour.h"
#include "core/valve/number_text.h"
#include "io/mesh/imaged_state.h"
#include "io/mesh/import_sheets.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

// In the mean over a leaflet, by which segmentations of 1 mm voxels measure 2 mm. Assumed.
constexpr Range kUsualThicknessMm = {0.5, 4.0};

/// Why a thickness is to be looked at, with a semicolon before it; empty: it is usual.
std::string doubt_of(double thickness_mm) {
  if (thickness_mm >= kUsualThicknessMm.min && thickness_mm <= kUsualThicknessMm.max) return "";
  return "; " + significant(thickness_mm, 2) + " mm is unusual, leaflets are " +
         significant(kUsualThicknessMm.min, 2) + " to " + significant(kUsualThicknessMm.max, 2) +
         " mm thick";
}

/// Whether what is looked at is there; into_import_frame() names what is not.
bool can_be_judged(const ImportSource& source) {
  return source.annulus_mm.rows() >= 3 &&
         is_circumference_mm(ArcLength(source.annulus_mm).total_mm()) && is_sound(source.leaflets);
}

}  // namespace

JudgedState judged_state(const ImportSource& source, const ImportOptions& options,
                         const std::vector<MeasuredThickness>& thickness) {
  if (!can_be_judged(source)) return {};
  double thickness_mm = Tissue{}.thickness_mm;
  for (const MeasuredThickness& of : thickness) thickness_mm = std::max(thickness_mm, of.mean_mm);
  const StateSigns signs =
      imaged_state(source.leaflets, source.annulus_mm, thickness_mm, options.budget);
  const std::string seen = "they leave " + significant(100.0 * signs.uncovered_share, 2) +
                           " % of the annular area uncovered";
  const char* looks = signs.state == ImagedState::Closed       ? "closed"
                      : signs.state == ImagedState::HalfClosed ? "half closed"
                                                               : "open";
  if (options.closed) {
    const bool agrees = *options.closed == (signs.state == ImagedState::Closed);
    return {*options.closed,
            {{"state",
              std::string(*options.closed ? "closed" : "open") + ", as given" +
                  (agrees ? "" : std::string("; the leaflets look ") + looks),
              seen, !agrees}}};
  }
  if (signs.state == ImagedState::Open) return {false, {{"state", "imaged open", seen}}};
  if (signs.state == ImagedState::HalfClosed)
    return {false,
            {{"state", "imaged half closed, interpreted as open",
              seen + "; 12 to 25 % is ambiguous, and stretched tissue is treated as unstressed",
              true}}};
  if (!options.chordae_seed)
    return {false,
            {{"state",
              "the leaflets look closed but are interpreted as open, because chordae were given",
              seen + "; the open shape is derived only with --chordae synthesise", true}}};
  if (source.leaflets.size() != 2)
    return {
        false,
        {{"state",
          "the leaflets look closed but are interpreted as open, because they form one skirt",
          seen + "; the open shape is derived only from an anterior and a posterior sheet", true}}};
  return {true, {{"state", "imaged closed", seen + ", and at most 12 % means closed", true}}};
}

Expected<double> tissue_thickness(const ImportOptions& options,
                                  const std::vector<MeasuredThickness>& measured, double own_mm,
                                  std::vector<ImportDecision>& decisions) {
  double mean_mm = 0.0;
  std::string doubt;
  for (const MeasuredThickness& of : measured) {
    mean_mm += of.mean_mm / static_cast<double>(measured.size());
    if (doubt.empty()) doubt = doubt_of(of.mean_mm);
  }
  if (options.thickness_measured) {
    if (measured.empty())
      return Error{
          ErrorCode::MissingField, "/thickness_measured",
          "requires thick leaflets; these are sheets, so specify a thickness in millimetres"};
    decisions.push_back(
        {"thickness", significant(mean_mm, 2) + " mm", "as measured" + doubt, true});
    return mean_mm;
  }
  if (options.thickness_mm) {
    doubt = doubt_of(*options.thickness_mm);
    decisions.push_back({"thickness", significant(*options.thickness_mm, 3) + " mm",
                         "as given" + doubt, !doubt.empty()});
    return *options.thickness_mm;
  }
  if (!measured.empty())
    decisions.push_back({"thickness",
                         "the tissue thickness remains " + significant(own_mm, 2) +
                             " mm; the shells measure " + significant(mean_mm, 2) + " mm",
                         "segmentation thickens leaflets by about a voxel (--thickness measured "
                         "uses the measured value)" +
                             doubt,
                         !doubt.empty()});
  return own_mm;
}

}  // namespace coapt
