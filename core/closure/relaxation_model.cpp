#include "core/closure/relaxation_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/closure/clusters.h"

namespace coapt {
namespace {

using kernels::blocks_for;
using kernels::kLanes;

template <class R>
void number_nodes(const ClosureModel& model, RelaxationModel<R>& laid) {
  const auto total = static_cast<int>(model.rest_mm.rows());
  std::vector<int> moving, branch_points;
  for (int i = 0; i < total; ++i) {
    if (model.fixed[i])
      laid.fixed.push_back(i);
    else
      (i < model.vertices ? moving : branch_points).push_back(i);
  }
  Points centres(moving.size(), 3);
  for (std::size_t i = 0; i < moving.size(); ++i) centres.row(i) = model.rest_mm.row(moving[i]);
  laid.moving_vertices = static_cast<int>(moving.size());
  laid.moving_nodes = static_cast<int>(moving.size() + branch_points.size());
  laid.node_of.assign(total, 0);
  int next = 0;
  for (const int i : cluster_order(centres)) laid.node_of[moving[i]] = next++;
  next = kLanes * blocks_for(moving.size());
  for (const int i : branch_points) laid.node_of[i] = next++;
  next = kLanes * (blocks_for(moving.size()) + blocks_for(branch_points.size()));
  laid.blocks.resize(next / kLanes);
  for (const int i : laid.fixed) laid.node_of[i] = next++;
  laid.nodes = next;
}

/// Node of each lane of the blocks, -1 for padding.
template <class R>
std::vector<int> nodes_of_lanes(const ClosureModel& model, const RelaxationModel<R>& laid) {
  std::vector<int> node_at(laid.blocks.size() * kLanes, -1);
  for (std::size_t i = 0; i < laid.node_of.size(); ++i)
    if (!model.fixed[i]) node_at[laid.node_of[i]] = static_cast<int>(i);
  return node_at;
}

template <class R>
void lay_springs(const ClosureModel& model, RelaxationModel<R>& laid) {
  std::vector<std::vector<std::pair<int, const Spring*>>> around(laid.node_of.size());
  for (const Spring& spring : model.springs) {
    around[spring.a].emplace_back(spring.b, &spring);
    around[spring.b].emplace_back(spring.a, &spring);
  }
  const std::vector<int> node_at = nodes_of_lanes(model, laid);
  for (std::size_t b = 0; b < laid.blocks.size(); ++b) {
    kernels::NodeBlock<R>& block = laid.blocks[b];
    block.first_spring = static_cast<int>(laid.spring_slots.size());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const int node = node_at[b * kLanes + lane];
      block.free.at[lane] = node < 0 ? R(0) : R(1);
      if (node >= 0) block.springs = std::max(block.springs, static_cast<int>(around[node].size()));
    }
    for (Index s = 0; s < block.springs; ++s) {
      kernels::SpringSlot<R>& slot = laid.spring_slots.emplace_back();
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const int node = node_at[b * kLanes + lane];
        slot.neighbour.at[lane] = kernels::offset_of<R>(static_cast<int>(b * kLanes + lane));
        if (node < 0 || s >= std::ssize(around[node])) continue;
        const auto& [neighbour, spring] = around[node][s];
        slot.neighbour.at[lane] = kernels::offset_of<R>(laid.node_of[neighbour]);
        slot.rest_mm.at[lane] = static_cast<R>(spring->rest_mm);
        slot.knee_mm.at[lane] = static_cast<R>((1.0 + spring->transition) * spring->rest_mm);
        slot.pre_n_per_mm.at[lane] = static_cast<R>(spring->pre_n_per_mm);
        slot.extra_n_per_mm.at[lane] = static_cast<R>(spring->post_n_per_mm - spring->pre_n_per_mm);
      }
    }
  }
}

/// Each node's corners, in the order of the faces in their blocks.
template <class R>
void lay_corners(const ClosureModel& model, const std::vector<int>& face_order,
                 RelaxationModel<R>& laid) {
  std::vector<std::vector<int>> corners(laid.node_of.size());
  for (std::size_t at = 0; at < face_order.size(); ++at)
    for (std::size_t k = 0; k < 3; ++k)
      corners[model.faces(face_order[at], k)].push_back(
          static_cast<int>((at / kLanes * 3 + k) * kLanes + at % kLanes));
  const int none = static_cast<int>(3 * kLanes * laid.faces.size());
  const std::vector<int> node_at = nodes_of_lanes(model, laid);
  for (std::size_t b = 0; b < laid.blocks.size(); ++b) {
    kernels::NodeBlock<R>& block = laid.blocks[b];
    block.first_corner = static_cast<int>(laid.corner_slots.size());
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      if (const int node = node_at[b * kLanes + lane]; node >= 0)
        block.corners = std::max(block.corners, static_cast<int>(corners[node].size()));
    for (Index s = 0; s < block.corners; ++s) {
      kernels::IndexLane& slot = laid.corner_slots.emplace_back();
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const int node = node_at[b * kLanes + lane];
        const bool has = node >= 0 && s < std::ssize(corners[node]);
        slot.at[lane] = kernels::offset_of<R>(has ? corners[node][s] : none);
      }
    }
  }
}

/// Offsets of the hinges' pulls by their edges, the lower vertex first.
using HingeOffsets = std::map<std::pair<int, int>, int>;

template <class R>
HingeOffsets lay_hinges(const ClosureModel& model, RelaxationModel<R>& laid) {
  Points centres(model.hinges.size(), 3);
  for (std::size_t h = 0; h < model.hinges.size(); ++h) {
    const auto& [a, b, c, d] = model.hinges[h].node;
    centres.row(h) = 0.5 * (model.rest_mm.row(a) + model.rest_mm.row(b));
  }
  HingeOffsets offsets;
  laid.hinges.resize(blocks_for(model.hinges.size()));
  std::size_t next = 0;
  for (const int i : cluster_order(centres)) {
    const Hinge& hinge = model.hinges[i];
    kernels::HingeBlock<R>& block = laid.hinges[next / kLanes];
    const std::size_t lane = next % kLanes;
    offsets[std::minmax(hinge.node[0], hinge.node[1])] =
        kernels::pull_offset_of<R>(static_cast<int>(next++));
    for (std::size_t k = 0; k < 4; ++k)
      block.node[k].at[lane] = kernels::offset_of<R>(laid.node_of[hinge.node[k]]);
    block.stiffness_n_mm.at[lane] = static_cast<R>(hinge.stiffness_n_mm);
    block.rest.at[lane] = static_cast<R>(hinge.rest);
    for (std::size_t k = 0; k < 2; ++k)
      block.least_mm4[k].at[lane] = static_cast<R>(hinge.least_mm4[k]);
  }
  return offsets;
}

template <class R>
void lay_membrane(const Sheet& sheet, std::size_t lane, kernels::FaceBlock<R>& block) {
  for (int k = 0; k < 2; ++k) {
    block.along[k].at[lane] = static_cast<R>(sheet.per_mm(k, 0));
    block.across[k].at[lane] = static_cast<R>(sheet.per_mm(k, 1));
  }
  block.volume_mm3.at[lane] = static_cast<R>(sheet.volume_mm3);
}

template <class R>
void lay_law(const ClosureModel& model, RelaxationModel<R>& laid) {
  const auto real = [](double value) { return static_cast<R>(value); };
  const auto fibres = [&](const Fibres& f) {
    return kernels::SheetFibres<R>{real(f.straight), real(f.mpa)};
  };
  const SheetLaw& law = model.law;
  laid.continuum = {real(law.along_mpa),     real(law.across_mpa),
                    real(law.coupling_mpa),  real(law.shear_mpa),
                    fibres(law.along),       fibres(law.across),
                    fibres(law.diagonal),    real(law.squeezed_mpa),
                    real(law.squeezed_area), real(kLeastAreaStretch * kLeastAreaStretch)};
  laid.face_law = !model.sheets.empty()               ? kernels::FaceLaw::Continuum
                  : !model.exponential_sheets.empty() ? kernels::FaceLaw::Exponential
                                                      : kernels::FaceLaw::None;
}

/// Faces next to each other share blocks.
template <class R>
void lay_faces(const ClosureModel& model, const HingeOffsets& hinges, RelaxationModel<R>& laid) {
  Points centres(model.faces.rows(), 3);
  for (Index f = 0; f < model.faces.rows(); ++f)
    centres.row(f) = model.rest_mm(model.faces.row(f), Eigen::all).colwise().mean();
  laid.faces.resize(blocks_for(model.faces.rows()));
  lay_law(model, laid);
  if (laid.face_law == kernels::FaceLaw::Exponential) laid.exponential.resize(laid.faces.size());
  const int no_hinge = kernels::pull_offset_of<R>(static_cast<int>(kLanes * laid.hinges.size()));
  const std::vector<int> order = cluster_order(centres);
  for (std::size_t at = 0; at < order.size(); ++at) {
    const int f = order[at];
    const std::size_t lane = at % kLanes;
    kernels::FaceBlock<R>& block = laid.faces[at / kLanes];
    for (int k = 0; k < 3; ++k) {
      const int from = model.faces(f, k), to = model.faces(f, (k + 1) % 3);
      block.node[k].at[lane] = kernels::offset_of<R>(laid.node_of[from]);
      const auto hinge = hinges.find(std::minmax(from, to));
      block.hinge[k].at[lane] = hinge == hinges.end() ? no_hinge : hinge->second;
    }
    block.least_mm4.at[lane] = static_cast<R>(least_mm4(model.rest_mm, model.faces, f));
    block.load_mpa.at[lane] = static_cast<R>(load_mpa(model, f) / 6.0);
    if (laid.face_law == kernels::FaceLaw::Continuum) lay_membrane(model.sheets[f], lane, block);
    if (laid.face_law != kernels::FaceLaw::Exponential) continue;
    const ExponentialSheet& tissue = model.exponential_sheets[f];
    lay_membrane(tissue.sheet, lane, block);
    kernels::ExponentialLane<R>& law = laid.exponential[at / kLanes];
    law.c0_mpa.at[lane] = static_cast<R>(tissue.law.c0_mpa);
    law.c1_mpa.at[lane] = static_cast<R>(tissue.law.c1_mpa);
    law.c2.at[lane] = static_cast<R>(tissue.law.c2);
    law.steepest.at[lane] = static_cast<R>(std::sqrt(kSteepest / tissue.law.c2));
  }
  lay_corners(model, order, laid);
}

template <class R>
void lay_cables(const ClosureModel& model, RelaxationModel<R>& laid) {
  laid.cables.resize(blocks_for(model.cables.size()));
  for (std::size_t c = 0; c < laid.cables.size() * kLanes; ++c) {
    kernels::CableBlock<R>& block = laid.cables[c / kLanes];
    const std::size_t lane = c % kLanes;
    block.first_share[lane] = static_cast<int>(laid.cable_ends.size());
    if (c < model.cables.size()) {
      const Cable& cable = model.cables[c];
      block.start.at[lane] = kernels::offset_of<R>(laid.node_of[cable.start]);
      for (const NodeShare& share : cable.end)
        laid.cable_ends.push_back(
            {kernels::offset_of<R>(laid.node_of[share.node]), static_cast<R>(share.weight)});
      block.rest_mm.at[lane] = static_cast<R>(cable.rest_mm);
      block.stiffness_n_per_mm.at[lane] = static_cast<R>(cable.stiffness_n_per_mm);
    }
    block.first_share[lane + 1] = static_cast<int>(laid.cable_ends.size());
  }
}

}  // namespace

template <class R>
RelaxationModel<R> make_relaxation_model(const ClosureModel& model) {
  RelaxationModel<R> laid;
  number_nodes(model, laid);
  lay_springs(model, laid);
  lay_faces(model, lay_hinges(model, laid), laid);
  lay_cables(model, laid);
  return laid;
}
template RelaxationModel<float> make_relaxation_model(const ClosureModel&);
template RelaxationModel<double> make_relaxation_model(const ClosureModel&);

}  // namespace coapt
