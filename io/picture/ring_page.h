// A designed ring as a page and as a table of its dimensions.
#pragma once

#include <string>
#include <vector>

#include "search/rings/design_ring.h"

namespace coapt {

/// Of one size.
struct RingDimensions {
  double size_mm = 0.0;                           ///< width, which is the label
  double depth_mm = 0.0;                          ///< front's middle to back's middle, in the plane
  double circumference_mm = 0.0, area_mm2 = 0.0;  ///< of the contour; its area seen from above
  double height_mm = 0.0;                         ///< from its lowest point to its highest
  double saddle_mm = 0.0;                         ///< front's middle above the ends
  double p3_inset_mm = 0.0;                       ///< how far P3 is drawn in
};
RingDimensions dimensions_of(const RingTerms& terms, double size_mm);

/// All sizes, 24 to 40 mm, with a header.
std::string ring_dimensions_csv(const RingTerms& terms);

/// Shape, gain, verdicts by aetiology, findings beside what is published, dimensions: HTML without scripts.
std::string ring_page_html(const RingDesignResult& result, const std::string& made_for);

}  // namespace coapt
