// What files are written of: what a closed valve looks like in some state.
#pragma once

#include <string>
#include <vector>

#include "core/closed/closed_valve.h"

namespace coapt {

/// The valve in one state, in its own frame.
struct ValveShape {
  Points vertices_mm;                               ///< |V| x 3
  Points heads_mm;                                  ///< |heads| x 3
  std::vector<Points> chorda_ends_mm;               ///< [chorda]: one row per segment: its far end
  std::vector<std::vector<double>> tension_n = {};  ///< [chorda][segment]; empty: there is none
  std::string doubt = {};                           ///< doubt_about() the closure that it is of
};

ValveShape closed_shape(const ClosedValve& exported);
ValveShape unstressed_shape(const Valve& valve);

/// From the state where the closure began to the closed one; empty if the motion was not kept.
std::vector<ValveShape> motion_shapes(const ClosedValve& exported);

/// Where a segment begins: at its papillary head or at the end of its parent.
Vec3 segment_start(const ValveShape& shape, const Chorda& chorda, std::size_t index_of_chorda,
                   std::size_t segment);

/// The mesh vertex that stands for an insertion where only vertices can hold a chorda: the heaviest of
/// its weights, which does not depend on the state.
int attached_vertex(const Valve& valve, const Insertion& insertion);

/// The shape with every insertion at its attached_vertex().
ValveShape attached_shape(const Valve& valve, ValveShape shape);

/// How far that moves the end of a chorda at most, mm.
double attachment_shift_mm(const Valve& valve, const ValveShape& shape);

}  // namespace coapt
