// What the images show, as given or judged: leaflets open or closed, and how thick the tissue is.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

struct JudgedState {
  bool closed = false;  ///< how the import goes on
  std::vector<ImportDecision> decisions;
};

/// Lengths must be millimetres. Open, and nothing told, where leaflets or annulus are not fit to be looked at.
/// @param thickness of thick leaflets
JudgedState judged_state(const ImportSource& source, const ImportOptions& options,
                         const std::vector<MeasuredThickness>& thickness);

/// Of the tissue, in mm. Errors: "/thickness_measured" of sheets. @param own_mm unless the options say otherwise
Expected<double> tissue_thickness(const ImportOptions& options,
                                  const std::vector<MeasuredThickness>& measured, double own_mm,
                                  std::vector<ImportDecision>& decisions);

}  // namespace coapt
