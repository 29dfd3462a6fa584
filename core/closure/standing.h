// How far a closure is to be trusted, in words: said once, for every file, picture and message that shows one.
#pragma once

#include <string>

#include "core/closure/closure_result.h"

namespace coapt {

/// "UNRELIABLE: not converged, leaflets cross"; empty for a closure that is to be trusted. ASCII of at most 60 letters, which
/// the header of an STL file has room for.
std::string doubt_about(const ClosureResult& closure);
std::string doubt_about(ClosureStatus status, bool crossing);

/// "converged", "step_limit", "diverged", or "crossing" whatever else it is.
std::string closure_name(const ClosureResult& closure);

}  // namespace coapt
