// The narrowest passage of an open valve.
//
// Open leaflets are a funnel, whose axis leads from the annulus's centroid to that of the free edges. A plane across it cuts the
// leaflets in lines; where they end, at the free edges, straight chords join them to an outline. What flows passes either through
// the plane within the outline, or out sideways between the free edges above it, through strips that the chords of planes
// sweep: both together part atrium from ventricle, and the smallest such surface is the opening: of the annulus's own plane and
// of all planes from below the annulus to where the outline no longer surrounds the axis. Half the leaflets' thickness is
// taken off.
// Accuracy: the area within the outline is exact (free_area.h), the strips (a tenth of the whole or less) are known to a few
// per cent; planes are kPlane_mm apart, so that the smallest is read a little too large.
// Limits: planes across one axis; outlines are taken as star-shaped about it where strips are counted.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

struct FunnelPassage {
  double area_mm2 = 0.0;  ///< NaN where a union failed
  double depth_mm =
      0.0;  ///< of its plane below the annulus's centroid, along the axis; 0: the annulus's
  Vec3 axis = -Vec3::UnitZ();  ///< unit, from the annulus to the free edges
  /// Where that surface ends, closed: the leaflets' mid-surfaces in the plane, and their free edges above it; or the annulus.
  std::vector<Vec3> outline_mm;
};

/// @param open_mm |V| x 3, finite. @pre the valve is mitral.
FunnelPassage narrowest_passage(const Valve& valve, const Points& open_mm);

}  // namespace coapt
