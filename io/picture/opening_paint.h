// Where a closed valve is open, in the atrial view.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/metrics/orifice.h"
#include "io/picture/canvas.h"
#include "io/picture/leaflet_paint.h"

namespace coapt {

/// Neighbouring sections without contact, on the plane of the view: the nearest points of both sides.
struct GapStrip {
  std::vector<Vec2> anterior, posterior;
};

/// Where the sides are apart and the view hides it.
std::vector<GapStrip> hidden_gaps(const ClosedValve& closed, const OrificeView& view);

/// What the view shows open, solid.
void paint_orifices(const Canvas& canvas, const OrificeView& view, const Mapping& map);

/// Seen through the tissue over them.
void paint_hidden_gaps(const Canvas& canvas, const std::vector<GapStrip>& gaps, const Mapping& map);

/// A pill with its area, led out of each orifice towards the annulus, by turns anterior and posterior; another for the
/// gap, where it is more than the view shows.
void label_openings(const Canvas& canvas, const ClosedValve& closed, const OrificeView& view,
                    const std::vector<GapStrip>& gaps, const Mapping& map);

}  // namespace coapt
