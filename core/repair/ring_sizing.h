// Which ring fits a valve, and how much smaller than that an annulus was made.
//
// Surgeons lay a sizer on the anterior leaflet and take the one whose surface it covers (Carpentier, Adams, Filsoufi, Reconstructive Valve
// Surgery, chapter 8). The sizer of a 3 : 4 ring is as tall as the leaflet where the ring's anteroposterior diameter is. Their second measure,
// the distance of the trigones, is not used: in made valves it is drawn apart from the leaflets, and in 16 population valves it would ask for
// rings of 21 to 44 mm.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// AP over transverse of a healthy annulus: 29 / 39 (PMC7368231), and of classic rings.
inline constexpr double kHealthyProportion = 0.75;

/// Of the unstressed anterior leaflet, mm: from the saddle peak to that vertex of A2 which is farthest from the annulus. 0 without A2.
double anterior_height_mm(const Valve& valve);

/// Transverse size, mm, of the 3 : 4 ring as tall as the anterior leaflet; not wider than the annulus, which no ring stretches.
double true_ring_size_mm(const Valve& valve);

/// How far below the true size of `before` an annulus was made, in sizes of 2 mm: that of a 3 : 4 ring of its area counts. 0 if it is not below.
double ring_sizes_below(const Valve& before, const Valve& repaired);

/// Whether a ring of that true width is wider than the annulus, which no ring stretches, by more than half a size: the size next to the annulus fits.
bool is_too_wide(const Valve& valve, double width_mm);

}  // namespace coapt
