#include "core/closure/relaxation_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/closure/clusters.h"

namespace coapt {
namespace {

using kernels::blocks_for;
using kernels::kLanes;

/// A neighbour of a node in the order of the faces around it.
struct FanEntry {
  int neighbour = 0;
  bool spring = true;  ///< false where a closed fan comes back to its first neighbour
  bool face = false;   ///< a face lies between the entry before and this one
};

/// [vertex]: its neighbours, counter-clockwise, fan by fan.
std::vector<std::vector<FanEntry>> fans(const ClosureModel& model) {
  std::vector<std::vector<std::pair<int, int>>> sides(model.vertices);
  for (Index f = 0; f < model.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k)
      sides[model.faces(f, k)].emplace_back(model.faces(f, (k + 1) % 3),
                                            model.faces(f, (k + 2) % 3));
  std::vector<std::vector<FanEntry>> all(sides.size());
  for (std::size_t v = 0; v < sides.size(); ++v) {
    auto& left = sides[v];
    while (!left.empty()) {
      // An open fan starts at the neighbour that no face of the fan leads to.
      auto first = std::find_if(left.begin(), left.end(), [&](const auto& side) {
        return std::none_of(left.begin(), left.end(),
                            [&](const auto& other) { return other.second == side.first; });
      });
      if (first == left.end()) first = left.begin();
      const int start = first->first;
      all[v].push_back({start, true, false});
      for (int at = start;;) {
        const auto next = std::find_if(left.begin(), left.end(),
                                       [&](const auto& side) { return side.first == at; });
        if (next == left.end()) break;
        at = next->second;
        left.erase(next);
        all[v].push_back({at, at != start, true});
      }
    }
  }
  return all;
}

/// Springs by their ends; they are in ascending order of these.
class SpringsBetween {
 public:
  explicit SpringsBetween(const ClosureModel& model)
      : springs_(model.springs), first_(model.vertices + 1) {
    std::size_t next = 0;
    for (Index v = 0; v < std::ssize(first_); ++v) {
      while (next < springs_.size() && springs_[next].a < v) ++next;
      first_[v] = next;
    }
  }
  const Spring& operator()(int i, int j) const {
    const auto [a, b] = std::minmax(i, j);
    std::size_t at = first_[a];
    while (springs_[at].b != b) ++at;
    return springs_[at];
  }

 private:
  const std::vector<Spring>& springs_;
  std::vector<std::size_t> first_;
};

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

template <class R>
void lay_springs(const ClosureModel& model, RelaxationModel<R>& laid) {
  const auto around = fans(model);
  const SpringsBetween spring_between(model);
  std::vector<int> vertex_at(laid.blocks.size() * kLanes, -1);
  for (int v = 0; v < static_cast<int>(model.rest_mm.rows()); ++v)
    if (!model.fixed[v]) vertex_at[laid.node_of[v]] = v;
  for (std::size_t b = 0; b < laid.blocks.size(); ++b) {
    kernels::NodeBlock<R>& block = laid.blocks[b];
    block.first_slot = static_cast<int>(laid.slots.size());
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const int v = vertex_at[b * kLanes + lane];
      block.free.at[lane] = v < 0 ? R(0) : R(1);
      if (v >= 0 && v < model.vertices)
        block.slots = std::max(block.slots, static_cast<int>(around[v].size()));
    }
    for (Index s = 0; s < block.slots; ++s) {
      kernels::FanSlot<R> slot;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        slot.neighbour.at[lane] = static_cast<int>(b * kLanes + lane);
        const int v = vertex_at[b * kLanes + lane];
        if (v < 0 || v >= model.vertices || s >= std::ssize(around[v])) continue;
        const FanEntry& entry = around[v][s];
        slot.neighbour.at[lane] = laid.node_of[entry.neighbour];
        if (entry.face) slot.load_mpa.at[lane] = static_cast<R>(model.pressure_mpa / 6.0);
        if (!entry.spring || model.springs.empty()) continue;
        const Spring& spring = spring_between(v, entry.neighbour);
        slot.rest_mm.at[lane] = static_cast<R>(spring.rest_mm);
        slot.knee_mm.at[lane] = static_cast<R>((1.0 + spring.transition) * spring.rest_mm);
        slot.pre_n_per_mm.at[lane] = static_cast<R>(spring.pre_n_per_mm);
        slot.extra_n_per_mm.at[lane] = static_cast<R>(spring.post_n_per_mm - spring.pre_n_per_mm);
      }
      laid.slots.push_back(slot);
    }
  }
}

/// Faces next to each other share blocks.
std::vector<int> sheet_order(const ClosureModel& model, const std::vector<Sheet>& sheets) {
  Points centres(sheets.size(), 3);
  for (std::size_t f = 0; f < sheets.size(); ++f)
    centres.row(f) = model.rest_mm(sheets[f].node, Eigen::all).colwise().mean();
  return cluster_order(centres);
}

/// Block: SheetBlock or ExponentialBlock.
template <class R, class Block>
void lay_sheet(const Sheet& sheet, const RelaxationModel<R>& laid, Block& block, std::size_t lane) {
  for (std::size_t k = 0; k < 3; ++k) block.node[k].at[lane] = laid.node_of[sheet.node[k]];
  for (int k = 0; k < 2; ++k) {
    block.along[k].at[lane] = static_cast<R>(sheet.per_mm(k, 0));
    block.across[k].at[lane] = static_cast<R>(sheet.per_mm(k, 1));
  }
  block.volume_mm3.at[lane] = static_cast<R>(sheet.volume_mm3);
}

template <class R>
void lay_sheets(const ClosureModel& model, RelaxationModel<R>& laid) {
  const auto real = [](double value) { return static_cast<R>(value); };
  const auto fibres = [&](const Fibres& f) {
    return kernels::SheetFibres<R>{real(f.straight), real(f.mpa)};
  };
  const SheetLaw& law = model.law;
  laid.sheet_law = {real(law.along_mpa), real(law.across_mpa), real(law.coupling_mpa),
                    real(law.shear_mpa), fibres(law.along),    fibres(law.across),
                    fibres(law.diagonal)};
  const std::vector<Sheet>& faces = model.sheets;
  laid.sheets.resize(blocks_for(faces.size()));
  std::size_t next = 0;
  for (const int f : sheet_order(model, faces)) {
    lay_sheet(faces[f], laid, laid.sheets[next / kLanes], next % kLanes);
    ++next;
  }
}

template <class R>
void lay_exponential_sheets(const ClosureModel& model, RelaxationModel<R>& laid) {
  std::vector<Sheet> faces;
  for (const ExponentialSheet& sheet : model.exponential_sheets) faces.push_back(sheet.sheet);
  laid.exponential_sheets.resize(blocks_for(faces.size()));
  std::size_t next = 0;
  for (const int f : sheet_order(model, faces)) {
    kernels::ExponentialBlock<R>& block = laid.exponential_sheets[next / kLanes];
    const std::size_t lane = next++ % kLanes;
    lay_sheet(faces[f], laid, block, lane);
    const ExponentialLaw& law = model.exponential_sheets[f].law;
    block.c0_mpa.at[lane] = static_cast<R>(law.c0_mpa);
    block.c1_mpa.at[lane] = static_cast<R>(law.c1_mpa);
    block.c2.at[lane] = static_cast<R>(law.c2);
    block.steepest.at[lane] = static_cast<R>(std::sqrt(kSteepest / law.c2));
  }
}

template <class R>
void lay_hinges(const ClosureModel& model, RelaxationModel<R>& laid) {
  Points centres(model.hinges.size(), 3);
  for (std::size_t h = 0; h < model.hinges.size(); ++h) {
    const auto& [a, b, c, d] = model.hinges[h].node;
    centres.row(h) = 0.5 * (model.rest_mm.row(a) + model.rest_mm.row(b));
  }
  laid.hinges.resize(blocks_for(model.hinges.size()));
  std::size_t next = 0;
  for (const int i : cluster_order(centres)) {
    const Hinge& hinge = model.hinges[i];
    kernels::HingeBlock<R>& block = laid.hinges[next / kLanes];
    const std::size_t lane = next++ % kLanes;
    for (std::size_t k = 0; k < 4; ++k) block.node[k].at[lane] = laid.node_of[hinge.node[k]];
    block.stiffness_n_mm.at[lane] = static_cast<R>(hinge.stiffness_n_mm);
    block.rest.at[lane] = static_cast<R>(hinge.rest);
    block.least_mm4.at[lane] = static_cast<R>(hinge.least_mm4);
  }
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
      block.start.at[lane] = laid.node_of[cable.start];
      for (const NodeShare& share : cable.end)
        laid.cable_ends.push_back({laid.node_of[share.node], static_cast<R>(share.weight)});
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
  lay_sheets(model, laid);
  lay_hinges(model, laid);
  lay_exponential_sheets(model, laid);
  lay_cables(model, laid);
  return laid;
}
template RelaxationModel<float> make_relaxation_model(const ClosureModel&);
template RelaxationModel<double> make_relaxation_model(const ClosureModel&);

}  // namespace coapt
