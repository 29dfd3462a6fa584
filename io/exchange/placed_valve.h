// A closed valve where it lies in the patient, for files that are laid over the images it came from.
#pragma once

#include "core/closed/closed_valve.h"

namespace coapt {

/// All of it in the patient's coordinates, with the areas and lengths measured before; a valve whose
/// frame is not known as it is.
ClosedValve in_patient_frame(const ClosedValve& closed);

}  // namespace coapt
