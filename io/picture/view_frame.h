// What the two drawings of a valve (atrial_view.h, section_view.h) have in common.
#pragma once

#include "io/picture/canvas.h"

namespace coapt {

struct ViewFrame {
  Box box;
  double pixels_per_mm = 12.0;
};

/// 10 mm, in the lower left corner.
void draw_scale_bar(const Canvas& canvas, const ViewFrame& frame);

/// Said in place of a drawing that would need points that are not there.
void draw_unknown(const Canvas& canvas, const ViewFrame& frame);

}  // namespace coapt
