// The studies of ischaemic regurgitation as figures 4.5 to 4.10 of the thesis, and one that it has not:
// the anchors around the annulus.
#pragma once

#include <string>
#include <vector>

#include "search/studies/anchor_summary.h"
#include "search/studies/geometry_studies.h"

namespace coapt {

const char* class_title(Displaced displaced);  ///< "Both muscles displaced"

/// Figure 4.5, and each height against the first one. `with_thesis`: the thesis's numbers as rings.
std::string annulus_svg(const AnnulusStudy& study, bool with_thesis = false);

/// Figure 4.10 for all anchors of the study: means of the regions of interest, below them their sd.
std::string anchors_histogram_svg(const ApproximationStudy& study);

/// Mean and sd of the regions over the anchor's place; `thesis` as levels, and as a point where an
/// anchor's `around` is above 0. Those of another protocol than the first one's are left out.
std::string anchor_scan_svg(const std::vector<AnchorSummary>& scan,
                            const std::vector<AnchorSummary>& thesis);

}  // namespace coapt
