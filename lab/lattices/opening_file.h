// Openings of a lattice's plans, kept from run to run.
#pragma once

#include <string>

#include "search/plans/plan_evaluations.h"

namespace coapt {

/// JSON: the subject (plan_subject_of()) and, by plan_key(), [status, crossing, opening_area_mm2, projected_area_mm2, gradient_mmhg]. What else a
/// measure holds is not kept.
std::string write_openings(const std::string& subject, const KnownOpenings& openings);
/// Empty if `text` is not what write_openings() writes of this subject.
KnownOpenings read_openings(const std::string& subject, const std::string& text);

}  // namespace coapt
