// Rings. The annulus under pressure takes the ring's shape; nothing else moves, and the frame
// stays.
//
// The fibrous, intertrigonal part of the annulus hardly yields and the posterior part is drawn in:
// in the annulus's plane the ring's anterior midpoint lies where the saddle peak is. The ring's own
// plane lies in the annulus's mean plane.
#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

/// The named shape, or null.
const RingShape* find_ring(const std::vector<RingShape>& catalogue, const std::string& name);

/// True transverse width of a catalogue ring.
double ring_width_mm(const RingShape& ring, double size_mm);

/// 720 points, counter-clockwise from the posteromedial end: x posteromedial, y anterior, z atrial.
/// The generic annulus contour with the ring's width, depth (ap_over_transverse of the width) and
/// saddle: an assumption that stands for any closed, rigid ring; no manufacturer's drawing.
Points ring_contour_mm(const RingShape& ring, double size_mm);

/// Whether the step can be done on this valve; lists why not.
bool check_annuloplasty(const Annuloplasty& step, const Valve& valve,
                        const std::vector<RingShape>& catalogue, const std::string& path,
                        ProblemList& problems);

/// Catalogue rings are sutured evenly: between saddle peak and mid-posterior, on either side, each
/// annulus vertex goes to the same share of the ring's arc. Shape "own" shrinks towards the saddle
/// peak's projection on the mean plane. @pre check_annuloplasty().
void apply_annuloplasty(const Annuloplasty& step, const std::vector<RingShape>& catalogue,
                        Valve& valve);

}  // namespace coapt
