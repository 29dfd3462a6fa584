// What is named in the view from the atrium.
#pragma once

#include "io/picture/canvas.h"
#include "io/picture/leaflet_paint.h"

namespace coapt {

/// Landmarks of the annulus, beside it.
void draw_landmarks(const Canvas& canvas, const Valve& valve, const AnnulusFrame& plane,
                    const Mapping& map, const Vec2& centre_px);

/// A1 to P3 just inside the annulus, where each segment hangs on it.
void draw_segment_names(const Canvas& canvas, const Valve& valve, const AnnulusFrame& plane,
                        const Mapping& map, const Vec2& centre_px);

}  // namespace coapt
