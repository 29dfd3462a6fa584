// The leak of a closed valve, and the opening of one in diastole, as the surface that is measured.
#pragma once

#include "core/closed/closed_valve.h"
#include "core/metrics/section.h"
#include "io/picture/canvas.h"
#include "io/picture/leaflet_paint.h"
#include "io/picture/section_map.h"

namespace coapt {

/// Seen from the atrium. @param share of the colour: less shows what lies below
void paint_openings(const Canvas& canvas, const Leak& leak, const AnnulusFrame& plane,
                    const Mapping& map, double share);

/// Their rims, over everything.
void draw_rims_of_openings(const Canvas& canvas, const Leak& leak, const AnnulusFrame& plane,
                           const Mapping& map);

/// Where a plane meets them.
void draw_opening_cuts(const Canvas& canvas, const Leak& leak, const SectionPlane& plane,
                       const SectionMap& map);

/// A pill with its area, led out of each opening towards the annulus, by turns anterior and posterior.
void label_openings(const Canvas& canvas, const ClosedValve& closed, const AnnulusFrame& plane,
                    const Mapping& map);

}  // namespace coapt
