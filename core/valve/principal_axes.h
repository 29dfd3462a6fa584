// The axes along which a cloud of points spreads least, more and most.
#pragma once

#include <Eigen/Core>

#include "core/valve/types.h"

namespace coapt {

/// Unit vectors in columns, by rising spread; their signs, and the hand of all three, mean nothing.
/// @param centred [n x 3], less their centre
Eigen::Matrix3d principal_axes(const Points& centred);

/// The same of any symmetric matrix, with its eigenvalues.
struct Eigensystem {
  Vec3 values;
  Eigen::Matrix3d vectors;
};
Eigensystem eigensystem(const Eigen::Matrix3d& symmetric);

}  // namespace coapt
