// The way back from a valve's own frame to the images that it was made from: rings, sutures and closed
// leaflets lie on them only in the patient's coordinates.
#pragma once

#include "core/valve/valve.h"

namespace coapt {

/// LPS, mm. Points n x 3.
Points to_patient(const PatientFrame& frame, const Points& points_mm);
Vec3 to_patient(const PatientFrame& frame, const Vec3& point_mm);

/// The way there: from the patient's coordinates into the valve's own frame.
Points from_patient(const PatientFrame& frame, const Points& points_mm);

/// The same valve in the patient's coordinates, its frame the identity; a valve without one as it is.
/// For writing only: validate() wants valves in their own frame.
Valve in_patient_frame(Valve valve);

/// Whether the valve's coordinates are the patient's already.
bool lies_in_patient_frame(const Valve& valve);

}  // namespace coapt
