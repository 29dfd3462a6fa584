#include "core/closure/moving_valve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/closure/crossing.h"

namespace coapt {
namespace {

using kernels::kLanes;

// Pairs are listed so far ahead that the list lasts about this many steps. It is renewed when a
// node has moved by the margin: two that move towards each other could then be closer than the
// margin allows for, but not through each other (pairs asleep are woken by the same rule); the last
// step has a list of its own that allows for everything.
constexpr double kListSteps = 12.0;
constexpr double kArrived_mm = 1e-5;  // of single precision, 50 mm from the origin
constexpr double kLeastMargin_mm = 0.04, kLargestMargin_mm = 0.5;
// The slowest modes set the damping, and they are slower the finer the mesh: 1 - 0.94, 0.965 and
// 0.98 are best at 650, 2,600 and 10,400 triangles; 0.94 at 10,400 takes six times as many steps.
constexpr double kDampedTriangles = 650.0, kDampingPower = -0.4, kMostDamping = 0.2;

// The present stiffness changes slowly beside a step, and a factorisation costs as much as several.
constexpr int kRefreshSteps = 20;

double share_kept(const ClosureModel& model, const RelaxationSettings& settings, double damping) {
  if (settings.preconditioned) return 1.0 - std::min(kMostDamping, damping);
  const auto faces = static_cast<double>(model.faces.rows());
  return 1.0 - std::min(kMostDamping, damping * std::pow(faces / kDampedTriangles, kDampingPower));
}

double margin_mm(double move_mm) {
  return std::clamp(kListSteps * move_mm, kLeastMargin_mm, kLargestMargin_mm);
}

template <class R>
RelaxationLayout<R> layout_for(const ClosureModel& model, const RelaxationSettings& settings) {
  if constexpr (std::is_same_v<R, float>)
    if (settings.layout != nullptr) return *settings.layout;
  return lay_out<R>(model, settings.contact, settings.instructions);
}

}  // namespace

template <class R>
MovingValve<R>::MovingValve(const ClosureModel& model, const RelaxationSettings& settings,
                            const Points& start)
    : model_(model),
      settings_(settings),
      damping_(settings.damping),
      kernels_(kernels::kernels<R>(settings.instructions)),
      start_mm_(start),
      layout_(layout_for<R>(model, settings)),
      x_(layout_.laid.nodes),
      next_(x_.size()),
      force_(x_.size()),
      corners_(3 * kLanes * layout_.laid.faces.size() + 1),
      hinge_pulls_(layout_.laid.hinges.size() + 1),
      longest_move_mm_(settings.longest_move_mm) {
  if (settings.contact.edges) guard(model.edges);
  if (settings.preconditioned) {
    laplacian_ = std::make_unique<StiffnessLaplacian<R>>(layout_.laid);
    sums_.resize(layout_.laid.blocks.size() * kLanes);
  }
  for (Index i = 0; i < start.rows(); ++i) place(i, start.row(i));
}

template <class R>
void MovingValve<R>::place_fixed(double travelled) {
  travelled_ = travelled;
  for (const int i : layout_.laid.fixed) {
    const Vec3 way = model_.target_mm.row(i) - start_mm_.row(i);
    const Vec3 at = start_mm_.row(i).transpose() + travelled * way;
    place(i, at);
  }
}

template <class R>
double MovingValve<R>::way_to_targets_mm() const {
  double longest2 = 0.0;
  for (const int i : layout_.laid.fixed)
    longest2 = std::max(longest2, (model_.target_mm.row(i).transpose() - at(i)).squaredNorm());
  return longest2 > kArrived_mm * kArrived_mm ? std::sqrt(longest2) : 0.0;
}

template <class R>
double MovingValve<R>::approach_targets(double longest_mm) {
  const double way_mm = way_to_targets_mm();
  if (way_mm == 0.0) return 0.0;
  const double share = std::min(1.0, longest_mm / way_mm);
  for (const int i : layout_.laid.fixed) {
    const Vec3 from = at(i);
    place(i, from + share * (model_.target_mm.row(i).transpose() - from));
  }
  return share * way_mm;
}

template <class R>
void MovingValve<R>::load(double pressure_mpa) {
  for (kernels::FaceBlock<R>& block : layout_.laid.faces)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      if (block.least_mm4.at[lane] > R(0))
        block.load_mpa.at[lane] = static_cast<R>(pressure_mpa / 6.0);
}

template <class R>
Vec3 MovingValve<R>::position(const std::vector<NodeShare>& shares) const {
  Vec3 mean = Vec3::Zero();
  for (const NodeShare& share : shares) mean += share.weight * at(share.node);
  return mean;
}

template <class R>
void MovingValve<R>::pull(const std::vector<NodeShare>& shares, const Vec3& force_n,
                          double stiffness_n_per_mm) {
  for (const NodeShare& share : shares) {
    kernels::Quad<R>& q = force_[layout_.laid.node_of[share.node]];
    for (int k = 0; k < 3; ++k) q.at[k] += static_cast<R>(share.weight * force_n[k]);
    q.at[3] += static_cast<R>(share.weight * stiffness_n_per_mm);
  }
}

template <class R>
void MovingValve<R>::draw(const Points& to_mm, double stiffness_n_per_mm, double largest_n) {
  for (Index i = 0; i < to_mm.rows(); ++i) {
    if (model_.fixed[i]) continue;
    const Vec3 way = to_mm.row(i).transpose() - at(i);
    const double spring = std::min(stiffness_n_per_mm, largest_n / std::max(way.norm(), 1e-12));
    kernels::Quad<R>& force = force_[layout_.laid.node_of[i]];
    for (int k = 0; k < 3; ++k) force.at[k] += static_cast<R>(spring * way[k]);
    force.at[3] += static_cast<R>(spring);
  }
}

template <class R>
void MovingValve<R>::step(double fixed_move_mm) {
  fixed_move_mm_ = fixed_move_mm;
  fixed_share_ += fixed_move_mm / fixed_margin_mm_;
  used_share_ += fixed_move_mm / fixed_margin_mm_;  // they have moved already
  if (std::max(listed_share_, fixed_share_) >= 1.0) list();
  pull_chordae();
  pull_faces();
  if (layout_.parted.empty()) layout_.faces.push(x_, used_share_, force_);
  for (ContactPairs<R>& pairs : layout_.parted) pairs.push(x_, used_share_, force_);
  if (edges_) edges_->push(x_, used_share_, force_);
  kernels::StepInput<R> input;
  input.x = x_.data();
  input.next = next_.data();
  input.force = force_.data();
  input.listed = listed_.data();
  input.blocks = layout_.laid.blocks.data();
  input.corners = corners_.data();
  input.corner_slots = layout_.laid.corner_slots.data();
  input.spring_slots = layout_.laid.spring_slots.data();
  input.block_count = static_cast<int>(layout_.laid.blocks.size());
  input.keep = static_cast<R>(share_kept(model_, settings_, damping_));
  input.longest_move_mm = static_cast<R>(settings_.longest_move_mm);
  input.mass_share = static_cast<R>(settings_.mass_share);
  input.lookahead_mm = static_cast<R>(longest_move_mm_);
  const kernels::StepSums sums = laplacian_ ? move_together(input) : kernels_.advance(input);
  longest_move_mm_ = std::sqrt(sums.longest_move2_mm2);
  listed_share_ = std::sqrt(sums.listed_share2);
  used_share_ += std::sqrt(sums.step_share2);
  force2_n2_ = sums.force2_n2;
  x_.swap(next_);
}

/// kernels::advance, with the Laplacian's inverse in place of each node's own.
template <class R>
kernels::StepSums MovingValve<R>::move_together(kernels::StepInput<R>& input) {
  const auto longest2 = input.longest_move_mm * input.longest_move_mm;
  const auto per_mass = R(1) / input.mass_share;
  input.sums = sums_.data();
  input.mass_share = std::numeric_limits<R>::infinity();
  kernels::StepSums sums = kernels_.advance(input);
  if (steps_to_refresh_-- == 0) {
    laplacian_->refresh(corners_, sums_);
    steps_to_refresh_ = kRefreshSteps - 1;
  }
  laplacian_->solve(sums_);
  R move2 = 0, step_share2 = 0, listed_share2 = 0;
  for (std::size_t node = 0; node < sums_.size(); ++node) {
    kernels::NodeBlock<R>& block = layout_.laid.blocks[node / kLanes];
    const std::size_t lane = node % kLanes;
    if (block.free.at[lane] == R(0)) continue;
    R v[3], v2 = 0, moved2 = 0;
    for (int k = 0; k < 3; ++k) {
      v[k] = block.velocity[k].at[lane] + per_mass * sums_[node].at[k];
      v2 += v[k] * v[k];
    }
    const R shorten = v2 > longest2 ? std::sqrt(longest2 / v2) : R(1);
    for (int k = 0; k < 3; ++k) {
      block.velocity[k].at[lane] = v[k] *= shorten;
      next_[node].at[k] = x_[node].at[k] + v[k];
      const R moved = next_[node].at[k] - listed_[node].at[k];
      moved2 += moved * moved;
    }
    v2 = std::min(v2, longest2);
    const R per_margin2 = R(1) / (listed_[node].at[3] * listed_[node].at[3]);
    move2 = std::max(move2, v2);
    step_share2 = std::max(step_share2, per_margin2 * v2);
    listed_share2 = std::max(listed_share2, per_margin2 * moved2);
  }
  sums.longest_move2_mm2 = static_cast<double>(move2);
  sums.step_share2 = static_cast<double>(step_share2);
  sums.listed_share2 = static_cast<double>(listed_share2);
  return sums;
}

template <class R>
void MovingValve<R>::list() {
  listed_ = x_;
  for (std::size_t b = 0; b < layout_.laid.blocks.size(); ++b) {
    const kernels::NodeBlock<R>& block = layout_.laid.blocks[b];
    double move2 = 0.0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      double v2 = 0.0;
      for (const auto& v : block.velocity) v2 += static_cast<double>(v.at[lane] * v.at[lane]);
      move2 = std::max(move2, v2);
    }
    const double margin = margin_mm(started_ ? std::sqrt(move2) : longest_move_mm_);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      listed_[b * kLanes + lane].at[3] = static_cast<R>(margin);
  }
  fixed_margin_mm_ = margin_mm(started_ ? fixed_move_mm_ : longest_move_mm_);
  for (std::size_t i = layout_.laid.blocks.size() * kLanes; i < listed_.size(); ++i)
    listed_[i].at[3] = static_cast<R>(fixed_margin_mm_);
  started_ = true;
  listed_share_ = fixed_share_ = used_share_ = 0.0;
  if (layout_.parted.empty()) layout_.faces.list(listed_);
  for (ContactPairs<R>& pairs : layout_.parted) pairs.list(listed_);
  if (edges_) edges_->list(listed_);
}

template <class R>
Points MovingValve<R>::positions() const {
  Points x(model_.rest_mm.rows(), 3);
  for (Index i = 0; i < x.rows(); ++i)
    for (int k = 0; k < 3; ++k) x(i, k) = static_cast<double>(x_[layout_.laid.node_of[i]].at[k]);
  if (travelled_ == 1.0)
    for (const int i : layout_.laid.fixed) x.row(i) = model_.target_mm.row(i);
  return x;
}

template <class R>
double MovingValve<R>::residual() const {
  Points pressure = Points::Zero(model_.rest_mm.rows(), 3);
  add_pressure_forces(model_, positions(), pressure);
  double pressure2 = 0.0;
  for (int v = 0; v < model_.vertices; ++v)
    if (!model_.fixed[v]) pressure2 += pressure.row(v).squaredNorm();
  const double force = std::sqrt(force2_n2_ / std::max(1, layout_.laid.moving_nodes));
  const double load = std::sqrt(pressure2 / std::max(1, layout_.laid.moving_vertices));
  return load > 0.0 ? force / load : force;
}

template <class R>
std::vector<std::pair<int, int>> MovingValve<R>::crossings() {
  const Points x = positions();
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [f, g] : layout_.faces.straddling(x_))
    if (edge_pierces(model_.faces, x, f, g) || edge_pierces(model_.faces, x, g, f))
      pairs.push_back(std::minmax(f, g));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

template <class R>
void MovingValve<R>::guard(const std::vector<std::array<int, 2>>& edges) {
  edges_.emplace(model_, layout_.laid.node_of, settings_.contact, PairKind::EdgeEdge, kernels_,
                 edges);
  listed_share_ = 1.0;
}

template <class R>
void MovingValve<R>::return_to(const Moment& moment) {
  x_ = next_ = moment.x;
  layout_.laid.blocks = moment.blocks;
  longest_move_mm_ = moment.longest_move_mm;
  travelled_ = moment.travelled;
  listed_share_ = 1.0;
}

template <class R>
void MovingValve<R>::pull_chordae() {
  kernels::CableInput<R> input;
  input.blocks = layout_.laid.cables.data();
  input.block_count = static_cast<int>(layout_.laid.cables.size());
  input.shares = layout_.laid.cable_ends.data();
  input.x = x_.data();
  input.force = force_.data();
  kernels_.pull_cables(input);
}

template <class R>
void MovingValve<R>::pull_faces() {
  kernels::HingeInput<R> hinges;
  hinges.blocks = layout_.laid.hinges.data();
  hinges.block_count = static_cast<int>(layout_.laid.hinges.size());
  hinges.x = x_.data();
  hinges.pulls = hinge_pulls_.data();
  kernels_.turn_hinges(hinges);
  kernels::FaceInput<R> faces;
  faces.blocks = layout_.laid.faces.data();
  faces.block_count = static_cast<int>(layout_.laid.faces.size());
  faces.law = layout_.laid.face_law;
  faces.continuum = layout_.laid.continuum;
  faces.lookahead_mm = static_cast<R>(longest_move_mm_);
  faces.exponential = layout_.laid.exponential.data();
  faces.least_area_stretch2 = static_cast<R>(kLeastAreaStretch2);
  faces.hinges = hinge_pulls_.data();
  faces.x = x_.data();
  faces.corners = corners_.data();
  kernels_.pull_faces(faces);
}

template <class R>
Vec3 MovingValve<R>::at(Index i) const {
  const kernels::Quad<R>& q = x_[layout_.laid.node_of[i]];
  return Vec3(q.at[0], q.at[1], q.at[2]);
}

template <class R>
void MovingValve<R>::place(Index i, const Vec3& p) {
  const int node = layout_.laid.node_of[i];
  for (int k = 0; k < 3; ++k) x_[node].at[k] = next_[node].at[k] = static_cast<R>(p[k]);
}

template class MovingValve<float>;
template class MovingValve<double>;

}  // namespace coapt
