// Landmarks that a person saw, on the annulus.
#pragma once

#include "core/valve/contour.h"
#include "core/valve/problem_list.h"
#include "core/valve/valve.h"
#include "io/mesh/skirt.h"

namespace coapt {

inline constexpr double kLandmarkReach_mm = 10.0;  ///< of a given landmark from the annulus

/// Those further away from the annulus, or no numbers: "/landmarks/saddle_peak_mm".
void check_given(const FramedSource& source, ProblemList& problems);

/// The arc of the contour that is nearest to a point.
double nearest_arc_mm(const ArcLength& contour, const Vec3& point_mm);

/// The station in [first, last] whose annulus point is nearest.
int nearest_station(const Skirt& skirt, const Vec3& point_mm, int first, int last);

/// What became of them: `taken`, of the skirt. One that moved by more than 4 mm is looked at; an error at more than 10, as of a saddle
/// peak behind.
Expected<std::vector<ImportDecision>> given_decisions(const GivenLandmarks& given,
                                                      const Skirt& skirt, const Landmarks& taken);

/// `change` of each that was given.
template <class Change>
void for_each_given(GivenLandmarks& given, const Change& change) {
  for (std::optional<Vec3>* place :
       {&given.anterolateral_commissure_mm, &given.posteromedial_commissure_mm,
        &given.saddle_peak_mm, &given.mid_posterior_mm})
    if (*place) **place = change(**place);
}

}  // namespace coapt
