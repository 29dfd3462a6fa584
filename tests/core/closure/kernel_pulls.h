// What the kernels make of membrane, bending and pressure, gathered by node.
#pragma once

#include <vector>

#include "core/closure/exponential.h"
#include "core/closure/kernels/kernels.h"
#include "core/closure/relaxation_model.h"

namespace coapt {

/// By node of the model; the fourth is the stiffness, N/mm.
template <class R>
std::vector<kernels::Quad<R>> pulls_of_faces(const ClosureModel& model, const Points& x,
                                             kernels::InstructionSet set) {
  const RelaxationModel<R> laid = make_relaxation_model<R>(model);
  const kernels::Kernels<R>& table = kernels::kernels<R>(set);
  std::vector<kernels::Quad<R>> at(laid.nodes), corners(48 * laid.faces.size() + 1);
  for (std::size_t i = 0; i < laid.node_of.size(); ++i)
    for (int k = 0; k < 3; ++k) at[laid.node_of[i]].at[k] = static_cast<R>(x(i, k));
  std::vector<kernels::HingePulls<R>> pulls(laid.hinges.size() + 1);
  kernels::HingeInput<R> hinges;
  hinges.blocks = laid.hinges.data();
  hinges.block_count = static_cast<int>(laid.hinges.size());
  hinges.x = at.data();
  hinges.pulls = pulls.data();
  table.turn_hinges(hinges);
  kernels::FaceInput<R> faces;
  faces.blocks = laid.faces.data();
  faces.block_count = static_cast<int>(laid.faces.size());
  faces.law = laid.face_law;
  faces.continuum = laid.continuum;
  faces.exponential = laid.exponential.data();
  faces.least_area_stretch2 = static_cast<R>(kLeastAreaStretch2);
  faces.hinges = pulls.data();
  faces.x = at.data();
  faces.corners = corners.data();
  table.pull_faces(faces);

  std::vector<kernels::Quad<R>> sums(at.size()), by_node;
  for (std::size_t b = 0; b < laid.faces.size(); ++b)
    for (std::size_t lane = 0; lane < kernels::kLanes; ++lane) {
      if (laid.faces[b].load_mpa.at[lane] == R(0) && laid.faces[b].least_mm4.at[lane] == R(0))
        continue;  // padding
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = laid.faces[b].node[k].at[lane] / kernels::offset_of<R>(1);
        for (int c = 0; c < 4; ++c)
          sums[node].at[c] += corners[(3 * b + k) * kernels::kLanes + lane].at[c];
      }
    }
  for (const int node : laid.node_of) by_node.push_back(sums[node]);
  return by_node;
}

}  // namespace coapt
