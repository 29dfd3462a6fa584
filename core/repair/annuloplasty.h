// Rings. The annulus under pressure takes the ring's shape; nothing else moves, and the frame
// stays.
//
// The fibrous, intertrigonal part of the annulus hardly yields and the posterior part is drawn in:
// in the annulus's plane the ring's anterior midpoint lies where the saddle peak is. The ring's own
// plane lies in the annulus's mean plane.
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/repair/rings.h"
#include "core/valve/problem_list.h"

namespace coapt {

/// Whether the step can be done on this valve; lists why not.
bool check_annuloplasty(const Annuloplasty& step, const Valve& valve, const std::string& path,
                        ProblemList& problems);

/// Name and terms of a shape: lists what is wrong.
bool check_designed_shape(const DesignedShape& shape, const std::string& path,
                          ProblemList& problems);

/// The annulus takes the ring's contour, evenly sutured: between saddle peak and mid-posterior, on
/// either side, each annulus vertex goes to the same share of the ring's arc.
void suture_contour(const Points& contour_mm, Valve& valve);
void suture_ring(const RingShape& ring, double size_mm, Valve& valve);

/// Sutures a catalogue or designed ring; an own ring shrinks the annulus towards the saddle peak's projection on the mean
/// plane. @pre check_annuloplasty().
void apply_annuloplasty(const Annuloplasty& step, Valve& valve);

}  // namespace coapt
