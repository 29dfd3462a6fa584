// Annulus, papillary tips, landmarks and the sutures of a repair as Slicer's markups.
#pragma once

#include <string_view>

#include "io/exchange/exported_valve.h"
#include "io/exchange/markups.h"

namespace coapt {

Markup annulus_markup(const Valve& valve, const ValveShape& shape);

/// Where annulus and tips go under pressure, named "... under pressure"; none if they stay.
std::vector<Markup> pressed_markups(const Valve& valve);

/// Labelled by the heads' ids ("AL1", ...).
Markup papillary_markup(const Valve& valve, const ValveShape& shape);

/// Under SlicerHeart's labels, on the annulus: A saddle peak, P mid-posterior, ALC and PMC the commissures, AL
/// and PM the widest places along the line that joins them.
Markup landmark_markup(const Valve& valve, const ValveShape& shape);

/// How the names of ties begin.
inline constexpr std::string_view kTieMarkup = "tie: ";

/// What was sewn in: the ring (its line is the annulus's), neochordae, papillary sutures; each a markup.
std::vector<Markup> repair_markups(const ClosedValve& exported, const ValveShape& shape);

/// All of them.
std::vector<Markup> valve_markups(const ClosedValve& exported, const ValveShape& shape);

/// The annulus vertices of the landmarks in the order A, P, AL, PM, ALC, PMC.
std::array<int, 6> landmark_vertices(const Valve& valve);

}  // namespace coapt
