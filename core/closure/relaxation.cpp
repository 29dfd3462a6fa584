#include "core/closure/relaxation.h"

#include <algorithm>
#include <cmath>

#include "core/closure/contact_pairs.h"
#include "core/closure/relaxation_model.h"

namespace coapt {
namespace {

using kernels::kLanes;

// The guaranteed bound is half the sum of stiffness; contact and damping take a little more.
constexpr double kMassShare = 0.55;
// Annulus and tips are in place after as many steps as their longest way needs, but not fewer.
constexpr int kTravelSteps = 60;
constexpr double kLongestTravel_mm = 0.15;  // in one step
// Pairs are listed so far ahead that the list lasts about this many steps. It is renewed when a node has
// moved by the margin: two that move towards each other could then be closer than the margin allows
// for, but not through each other (pairs asleep are woken by the same rule); the last step has a list of
// its own that allows for everything.
constexpr double kListSteps = 12.0;
constexpr double kLeastMargin_mm = 0.04, kLargestMargin_mm = 0.5;
constexpr int kWindow_steps = 15;        // between two looks at how fast the moves shrink
constexpr double kSlowestShrink = 0.97;  // of moves from window to window, assumed at most
constexpr int kSampleInterval_steps = 5;

/// Everything of one relaxation that changes.
template <class R>
class Relaxation {
 public:
  Relaxation(const ClosureModel& model, const RelaxationSettings& settings, const Points& start)
      : model_(model),
        settings_(settings),
        kernels_(kernels::kernels<R>(settings.instructions)),
        laid_(make_relaxation_model<R>(model)),
        x_(static_cast<std::size_t>(laid_.nodes)),
        next_(x_.size()),
        force_(x_.size()),
        longest_move_mm_(settings.longest_move_mm) {
    contacts_.emplace_back(model, laid_.node_of, settings.contact, PairKind::VertexFace, kernels_);
    if (settings.contact.edges)
      contacts_.emplace_back(model, laid_.node_of, settings.contact, PairKind::EdgeEdge, kernels_);
    for (Eigen::Index i = 0; i < start.rows(); ++i)
      place(static_cast<std::size_t>(i), start.row(i));
  }

  /// Places the nodes that do not move by themselves.
  void place_fixed(double travelled) {
    travelled_ = travelled;
    for (const int i : laid_.fixed) {
      const Vec3 way = model_.target_mm.row(i) - model_.rest_mm.row(i);
      const Vec3 at = model_.rest_mm.row(i).transpose() + travelled * way;
      place(static_cast<std::size_t>(i), at);
    }
  }

  /// `fixed_move_mm`: how far fixed nodes have moved since the last step.
  kernels::StepSums step(double fixed_move_mm) {
    fixed_move_mm_ = fixed_move_mm;
    fixed_share_ += fixed_move_mm / fixed_margin_mm_;
    if (std::max(listed_share_, fixed_share_) >= 1.0) list();
    kernels_.pull_cables(laid_.cables.data(), static_cast<int>(laid_.cables.size()), x_.data(),
                         force_.data());
    pull_sheets();
    for (ContactPairs<R>& pairs : contacts_) pairs.push(x_, used_share_, force_);
    kernels::StepInput<R> input;
    input.x = x_.data();
    input.next = next_.data();
    input.force = force_.data();
    input.listed = listed_.data();
    input.blocks = laid_.blocks.data();
    input.slots = laid_.slots.data();
    input.block_count = static_cast<int>(laid_.blocks.size());
    input.keep = static_cast<R>(settings_.keep);
    input.longest_move_mm = static_cast<R>(settings_.longest_move_mm);
    input.mass_share = static_cast<R>(kMassShare);
    input.lookahead_mm = static_cast<R>(longest_move_mm_);
    const kernels::StepSums sums = kernels_.advance(input);
    longest_move_mm_ = std::sqrt(sums.longest_move2_mm2);
    listed_share_ = std::sqrt(sums.listed_share2);
    used_share_ += std::max(std::sqrt(sums.step_share2), fixed_move_mm / fixed_margin_mm_);
    x_.swap(next_);
    return sums;
  }

  /// Lists the pairs that are near; each block of nodes has a margin that goes with its speed.
  void list() {
    listed_ = x_;
    for (std::size_t b = 0; b < laid_.blocks.size(); ++b) {
      const kernels::NodeBlock<R>& block = laid_.blocks[b];
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
    for (std::size_t i = laid_.blocks.size() * kLanes; i < listed_.size(); ++i)
      listed_[i].at[3] = static_cast<R>(fixed_margin_mm_);
    started_ = true;
    listed_share_ = fixed_share_ = used_share_ = 0.0;
    for (ContactPairs<R>& pairs : contacts_) pairs.list(listed_);
  }

  /// Fixed nodes to the last bit where the model has them.
  Points positions() const {
    Points x(model_.rest_mm.rows(), 3);
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      for (int k = 0; k < 3; ++k)
        x(i, k) = static_cast<double>(
            x_[static_cast<std::size_t>(laid_.node_of[static_cast<std::size_t>(i)])].at[k]);
    if (travelled_ == 1.0)
      for (const int i : laid_.fixed) x.row(i) = model_.target_mm.row(i);
    return x;
  }

  double residual(const kernels::StepSums& sums) const {
    const double force = std::sqrt(sums.force2_n2 / std::max(1, laid_.moving_nodes));
    const double load = std::sqrt(sums.pressure2_n2 / std::max(1, laid_.moving_vertices));
    return load > 0.0 ? force / load : force;
  }

 private:
  void pull_sheets() {
    kernels::SheetInput<R> input;
    input.blocks = laid_.sheets.data();
    input.block_count = static_cast<int>(laid_.sheets.size());
    input.law = laid_.sheet_law;
    input.lookahead_mm = static_cast<R>(longest_move_mm_);
    input.x = x_.data();
    input.force = force_.data();
    kernels_.pull_sheets(input);
  }

  void place(std::size_t i, const Vec3& p) {
    const auto node = static_cast<std::size_t>(laid_.node_of[i]);
    for (int k = 0; k < 3; ++k) x_[node].at[k] = next_[node].at[k] = static_cast<R>(p[k]);
  }

  const ClosureModel& model_;
  const RelaxationSettings& settings_;
  const kernels::Kernels<R>& kernels_;
  RelaxationModel<R> laid_;
  static double margin_mm(double move_mm) {
    return std::clamp(kListSteps * move_mm, kLeastMargin_mm, kLargestMargin_mm);
  }

  std::vector<kernels::Quad<R>> x_, next_, force_;
  std::vector<kernels::Quad<R>> listed_;  // where nodes were when pairs were listed, and margins
  std::vector<ContactPairs<R>> contacts_;
  double travelled_ = 0.0;
  bool started_ = false;
  // Shares of the margins that nodes have used up since pairs were listed: as the crow flies, at most on
  // the way, and the fixed nodes.
  double listed_share_ = 1.0, used_share_ = 0.0, fixed_share_ = 1.0;
  double fixed_margin_mm_ = 1.0, fixed_move_mm_ = 0.0;
  double longest_move_mm_ = 0.0;  // in the last step
};

double longest_way_mm(const ClosureModel& model) {
  return (model.target_mm - model.rest_mm).rowwise().norm().maxCoeff();
}

}  // namespace

template <class R>
ClosureRun relax(const ClosureModel& model, const RelaxationSettings& settings,
                 const Points* start) {
  Relaxation<R> state(model, settings, start ? *start : model.rest_mm);
  const int travel =
      start ? 1
            : std::max(kTravelSteps, static_cast<int>(longest_way_mm(model) / kLongestTravel_mm));
  const double fixed_move = longest_way_mm(model) / travel;
  ClosureRun result;
  Points before = start ? *start : model.rest_mm;
  double last_way = 0.0;
  bool settled = false;  // in the last look; the step after it is taken with a fresh list
  while (result.steps < settings.max_steps) {
    ++result.steps;
    const bool travelling = result.steps <= travel;
    if (travelling) state.place_fixed(static_cast<double>(result.steps) / travel);
    if (settled) state.list();
    result.residual = state.residual(state.step(travelling ? fixed_move : 0.0));
    if (settled && result.residual <= settings.residual_tolerance) {
      result.status = ClosureStatus::Converged;
      break;
    }
    settled = false;
    if (result.steps % kWindow_steps != 0) continue;
    const Points x = state.positions();
    if (!std::isfinite(result.residual) || lost(x)) {
      result.status = ClosureStatus::Diverged;
      break;
    }
    const double way =
        std::sqrt((x - before).topRows(model.vertices).squaredNorm() / model.vertices);
    const double shrink =
        last_way > 0.0 ? std::min(kSlowestShrink, way / last_way) : kSlowestShrink;
    const double left = way * shrink / (1.0 - shrink);
    last_way = way;
    before = x;
    settled = result.steps >= travel + kWindow_steps &&
              result.residual <= settings.residual_tolerance && left <= settings.way_tolerance_mm;
  }
  result.x_mm = state.positions();
  if (result.status != ClosureStatus::Converged) return result;
  result.samples_mm.push_back(result.x_mm.topRows(model.vertices));
  for (int s = 1; s < settings.samples; ++s) {
    for (int k = 0; k < kSampleInterval_steps; ++k, ++result.steps) state.step(0.0);
    result.samples_mm.push_back(state.positions().topRows(model.vertices));
  }
  return result;
}
template ClosureRun relax<float>(const ClosureModel&, const RelaxationSettings&, const Points*);
template ClosureRun relax<double>(const ClosureModel&, const RelaxationSettings&, const Points*);

}  // namespace coapt
