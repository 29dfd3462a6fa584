// The continuous minimal cut on a band of voxels: the u in [0, 1], given where cells are fixed, of the least sum |C grad u| voxel^2,
// where C are the shares of the faces that are free. Its value is the area of the smallest surface that parts the cells fixed at 1 from
// those fixed at 0 (Strang 1983, Math Program 26:123; Appleton and Talbot 2006, TPAMI 28:106): convex, so that there is one value.
//
// Solved by the primal-dual iteration of Chambolle and Pock (2011, J Math Imaging Vis 40:120). u gives an upper bound of the value, the
// flow that is dual to it a lower one; both are of the voxels, whose own error is another.
#pragma once

#include "lab/leak/free_shares.h"

namespace coapt {

/// Arrays over a band, by index.
struct CutState {
  std::vector<float> side;  ///< u: 0 ventricle, 1 atrium
  AxisFields flow;          ///< through each face over its free area, a vector of length 1 at most
};

struct CutStop {
  int iterations = 1500;
  double gap_mm2 = 0.02;     ///< between the bounds, or
  double gap_share = 0.002;  ///< of the upper one
};

struct MinimalCut {
  CutState state;
  double primal_mm2 = 0.0, dual_mm2 = 0.0;  ///< bounds: dual <= value <= primal
  int iterations = 0;
};

/// @param start fixed cells keep their side; flow of size 0 in each axis: none
MinimalCut minimal_cut(const VoxelBand& band, const AxisFields& shares, CutState start,
                       const CutStop& stop);

/// C grad u of each cell, by index: the cut's area per voxel^2 in that cell, towards the atrium.
std::vector<Eigen::Vector3f> cut_density(const VoxelBand& band, const AxisFields& shares,
                                         const std::vector<float>& side);

}  // namespace coapt
