// Papillary approximation: a suture from the papillary muscle to the annulus (thesis 4.2.3).
#pragma once

#include <string>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

/// Suture lengths that a muscle at this distance from its anchor can take: within kSutureMm, not
/// slack, not below half the distance.
Range suture_range_mm(double distance_mm);

/// From the muscle's mean tip to the anchor; 0 if that side has no heads.
double anchor_distance_mm(const Valve& valve, const PapillaryApproximation& step);

/// Whether the step can be done on this valve (its ring in place already); lists why not.
bool check_approximation(const PapillaryApproximation& step, const Valve& valve,
                         const std::string& path, ProblemList& problems);

/// Moves all heads of the side by one vector, until their mean tip is the suture's length from the
/// anchor.
/// @pre check_approximation().
void apply_approximation(const PapillaryApproximation& step, Valve& valve);

/// The suture of the papillary muscle on that side, or null.
const PapillaryApproximation* suture_of(const RepairPlan& plan, Side side);

/// Papillary muscles that get a suture.
int sutured_muscles(const RepairPlan& plan);

}  // namespace coapt
