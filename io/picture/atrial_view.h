#pragma once

#include "core/closed/closed_valve.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// As the surgeon sees it: anterior up, anterolateral left. The leak in blue, its openings with their areas.
void draw_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed);

/// A valve in diastole, alike: `open.measure.leak` is its opening.
void draw_open_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open);

/// The largest scale at which the annulus with its labels fits into a box.
double atrial_scale(const Box& box, const ClosedValve& closed);

}  // namespace coapt
