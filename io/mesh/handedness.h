// Whether a valve whose papillary tips nobody has seen is a mirror image.
//
// Leaflets and annulus of a mirror image look like a valve. What tells: places that are named after their side (A1 and A3, a commissure),
// else, where the files state the patient's axes, how the valve lies in them. Echo states axes of its own by the same words, so a
// valve that lies as no heart does proves nothing: it is to be looked at.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

/// @param frame where the valve made of the source lies in its axes. Errors: named sides that lie the other way round.
Expected<ImportDecision> judged_handedness(const ImportSource& source, const PatientFrame& frame);

}  // namespace coapt
