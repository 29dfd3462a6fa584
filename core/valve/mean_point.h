#pragma once

#include "core/valve/types.h"

namespace coapt {

/// Mean of the rows, with the same bits by every compiler: the frames of annulus and ring hang on its last digit, and the order
/// in which Eigen 3.4 adds up `points.colwise().mean()` depends on the compiler. @pre at least one row
Vec3 mean_point(const Points& points);

}  // namespace coapt
