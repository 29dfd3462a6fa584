#pragma once

#include "core/closed/closed_valve.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// Long-axis section through the saddle peak and mid-posterior: atrium up, anterior left; the leak in blue. Leaflets of
/// `before` stand behind in grey, cut by the same plane.
void draw_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
                       const ClosedValve* before = nullptr);

/// Of a valve in diastole, alike, without heights: `open.measure.leak` is its opening.
void draw_open_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open);

}  // namespace coapt
