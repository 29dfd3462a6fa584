// Preconditioner of a relaxation on a fine mesh: a graph Laplacian of the leaflets' present stiffness.
//
// A relaxation that divides each force by its node's own stiffness moves a soft mode of the whole leaflet as slowly as the
// mesh is fine: 10,400 triangles take eight times the steps of 650. The Laplacian has the same stiffness at its nodes and
// couples neighbours, so that steps hardly depend on the mesh. Its weights are those whose row sums are the stiffness that
// the kernels bound for each corner of a face, so that its largest eigenvalue keeps their bound. What is no membrane (cables,
// contact) is on the diagonal.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "core/closure/relaxation_model.h"

namespace coapt {

template <class R>
class StiffnessLaplacian {
 public:
  explicit StiffnessLaplacian(const RelaxationModel<R>& laid);

  /// Factorises it anew.
  /// @param corners  of faces, with their stiffness, N/mm, as fourth (kernels::FaceInput).
  /// @param nodes  [moving node], with all of theirs.
  void refresh(const std::vector<kernels::Quad<R>>& corners,
               const std::vector<kernels::Quad<R>>& nodes);

  /// @param nodes  [moving node], forces, N; replaced by the moves that balance them, mm.
  /// @pre It was refreshed.
  void solve(std::vector<kernels::Quad<R>>& nodes);

 private:
  /// A side of a face: corners at its ends and across it, entries of the matrix for the ends and both; -1 for fixed nodes.
  struct Side {
    int corner[3];
    int end[2], both;
  };
  void lay_matrix(const RelaxationModel<R>& laid);
  void lay_factor();

  std::vector<int> row_of_;    ///< [node], -1 for padding
  std::vector<int> diagonal_;  ///< [row], entries of the matrix
  std::vector<Side> sides_;
  Eigen::SparseMatrix<double> matrix_;  ///< its lower triangle
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  // The factor by columns below its diagonal, in single precision, and the rows in its order.
  std::vector<int> place_;  ///< [node], -1 for padding
  std::vector<int> first_, below_, entry_;
  std::vector<float> value_, inverse_;
  std::vector<kernels::Quad<float>> solved_;
};

}  // namespace coapt
