// Points of the leaflets by name: from leaflet coordinates to the mesh and back.
#pragma once

#include "core/valve/leaflet_coordinates.h"

namespace coapt {

/// A point of one leaflet. `along` runs from the anterolateral commissure (0) to the posteromedial
/// one (1), 0.5 at the saddle peak or mid-posterior; `height` from the annulus (0) to the free edge
/// (1).
struct LeafletPoint {
  Leaflet leaflet = Leaflet::Posterior;
  double along = 0.5;
  double height = 1.0;
};

/// `around` of a point: the anterior leaflet is walked clockwise, the posterior one
/// counter-clockwise.
double around(const LeafletPoint& point);

/// The point of the mesh nearest in leaflet coordinates.
Insertion locate(const Valve& valve, const LeafletCoordinates& coordinates,
                 const LeafletPoint& point);

/// Where it lies in the unstressed shape.
Vec3 rest_position_mm(const Valve& valve, const LeafletCoordinates& coordinates,
                      const LeafletPoint& point);

/// The other way round: where an insertion lies.
LeafletPoint leaflet_point(const Valve& valve, const LeafletCoordinates& coordinates,
                           const Insertion& insertion);

/// LeafletPoint::along of a segment's middle. @pre it has faces
double middle_along(const Valve& valve, const LeafletCoordinates& coordinates, Segment segment);

/// The point at LeafletCoordinates::around, any number of turns.
LeafletPoint leaflet_point(double around, double height);

}  // namespace coapt
