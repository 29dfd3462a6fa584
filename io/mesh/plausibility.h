// What an import doubts, whatever the format: one list of checks of what was given and of the valve made of it. Ranges are those of
// adults and children, sick ones included; what lies outside is looked at, not refused.
#pragma once

#include "core/valve/problem_list.h"
#include "io/mesh/import_frame.h"
#include "io/mesh/skirt.h"

namespace coapt {

/// What is wrong with a contour of which one point lies far from the arc between its neighbours, which is of the contour's radius
/// however far apart they lie; empty if none does.
/// @param loop closed, n x 3, as given, in any unit
std::string stray_point(const Points& loop);

/// A contour that was traced over a part of the annulus, or twice round: errors at "/annulus_mm"; one with a gap that may be none:
/// to be looked at. @param annulus_mm as given, lengths in millimetres
Expected<std::vector<ImportDecision>> contour_checks(const Points& annulus_mm);

/// Shells that are more than 1.4 times as thick along one direction as across it, whichever way they face: the spacing of the voxels is
/// another one along that axis. `leaflets` are their mid-surfaces.
std::vector<ImportDecision> thickness_checks(const std::vector<TriangleMesh>& leaflets,
                                             const std::vector<MeasuredThickness>& thickness);

/// Of open leaflets: how far what was given and the valve are apart, both ways.
struct TwoWayDistance {
  double to_sheets_rms_mm = 0.0, to_sheets_max_mm = 0.0;      ///< of all vertices of the valve
  double from_sheets_rms_mm = 0.0, from_sheets_max_mm = 0.0;  ///< of those of the sheets
};
TwoWayDistance two_way_distance(const std::vector<TriangleMesh>& sheets, const Valve& valve,
                                const ClosureBudget& budget);
bool is_far(const TwoWayDistance& apart);

/// Only what is out of range. @param closed the leaflets were imaged closed
std::vector<ImportDecision> valve_checks(const FramedSource& source, const Skirt& skirt,
                                         const Valve& valve, bool closed);

}  // namespace coapt
