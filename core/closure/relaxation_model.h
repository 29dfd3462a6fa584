// The closure model laid out for the kernels: moving nodes in blocks of sixteen that lie together
// on the leaflets, springs as fans around their nodes, sheets, cables.
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
  std::vector<kernels::FanSlot<R>> slots;
  std::vector<kernels::CableBlock<R>> cables;
  std::vector<kernels::EndShare<R>> cable_ends;
  std::vector<kernels::SheetBlock<R>> sheets;
  kernels::SheetModuli<R> sheet_law;
  std::vector<kernels::HingeBlock<R>> hinges;
  std::vector<kernels::ExponentialBlock<R>> exponential_sheets;
};

/// R is float or double.
template <class R>
RelaxationModel<R> make_relaxation_model(const ClosureModel& model);

}  // namespace coapt
