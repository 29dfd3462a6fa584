#pragma once

#include <vector>

#include "core/closed/closed_valve.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// Long-axis section through the saddle peak and mid-posterior: atrium up, anterior left. Leaflets of
/// `before` stand behind in grey, cut by the same plane.
void draw_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
                       const ClosedValve* before = nullptr);

/// Of a valve in diastole, alike: where the plane meets its narrowest passage, that line.
void draw_open_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open,
                            const std::vector<Vec3>& passage_mm);

}  // namespace coapt
