#include "core/valve/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace coapt {

Eigen::Matrix3d principal_axes(const Points& centred) {
  return eigensystem(centred.transpose() * centred).vectors;
}

Eigensystem eigensystem(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace coapt
