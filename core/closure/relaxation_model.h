// The closure model laid out for the kernels: moving nodes, faces, hinges and cables in blocks of
// sixteen that lie together on the leaflets; each node knows the corners of the faces around it and
// its springs.
#pragma once

#include <vector>

#include "core/closure/kernels/layout.h"
#include "core/closure/model.h"

namespace coapt {

template <class R>
struct RelaxationModel {
  int nodes = 0;             ///< with padding
  std::vector<int> node_of;  ///< [index in ClosureModel]
  std::vector<int> fixed;  ///< indices in ClosureModel of the nodes that do not move by themselves
  int moving_nodes = 0, moving_vertices = 0;
  std::vector<kernels::NodeBlock<R>> blocks;
  std::vector<kernels::IndexLane> corner_slots;
  std::vector<kernels::SpringSlot<R>> spring_slots;
  std::vector<kernels::CableBlock<R>> cables;
  std::vector<kernels::EndShare<R>> cable_ends;
  std::vector<kernels::FaceBlock<R>> faces;
  kernels::FaceLaw face_law = kernels::FaceLaw::None;
  kernels::SheetModuli<R> continuum;
  std::vector<kernels::ExponentialLane<R>> exponential;  ///< [block of faces], or none
  std::vector<kernels::HingeBlock<R>> hinges;
};

/// R is float or double.
template <class R>
RelaxationModel<R> make_relaxation_model(const ClosureModel& model);

}  // namespace coapt
