// What flow leaves of the pressure on each face of open leaflets.
//
// Blood that comes from the atrium speeds up where the funnel of the leaflets narrows, and its pressure falls (Bernoulli, steady,
// the ventricle at rest): of the whole difference 1 - (jet / here)^2 acts where a loop of equal leaflet height spans an area
// `here`, and nothing does behind the narrowest loop, the throat, where the jet has left the leaflets. The jet is smaller than the
// throat: kContraction. A loop's area is that of its area vector, half the sum of r x dr: of leaflets that are tied together, of all
// holes.
// The difference itself is rho / 2 (Q / A)^2, A the jet's area behind a throat without half a thickness along its loop.
#pragma once

#include <vector>

#include "core/valve/leaflet_coordinates.h"

namespace coapt {

struct FlowLoad {
  std::vector<double> share;  ///< |F|, of the difference of pressure, 0 to 1
  double jet_mm2 = 0.0;       ///< of the jet behind the throat, above 0
};

/// @param heights |V|, LeafletCoordinates::height. @param open_mm |V| x 3. @pre the valve is mitral.
FlowLoad flow_load(const Valve& valve, const std::vector<double>& heights, const Points& open_mm);

/// Difference of pressure that drives a flow through an opening without losses.
double bernoulli_mmhg(double flow_ml_s, double area_mm2);

}  // namespace coapt
