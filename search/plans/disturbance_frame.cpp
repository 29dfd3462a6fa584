#include "search/plans/disturbance_frame.h"

#include <algorithm>
#include <cmath>

#include "core/closure/predicted_start.h"

namespace coapt {
namespace {

// Pairs of opposite nodes of the region: three span its axes, eight its quadratic forms, too.
constexpr int kSpanning = 6, kLinear = 8, kQuadratic = 16;
constexpr double kDegree_mm = 0.5;  // of a tip's swing, 28 mm from its anchor
constexpr double kSpanned = 1e-6;   // error of parameters, mm or mm2
// Shares are multiples of it, which add up to 1 exactly and are the same whatever the last bits of the
// fit are.
constexpr double kShareStep = 0x1p-20;

/// Of one muscle's error: how far its tip goes, mm.
Vec3 parameters_of(const Perturbation& node) {
  return {node.length_mm, kDegree_mm * node.outwards_deg, kDegree_mm * node.posterior_deg};
}

Eigen::VectorXd parameters_of(int disturbance) {
  const Disturbance& d = disturbances()[disturbance];
  Eigen::VectorXd parameters(9);
  parameters << parameters_of(d.anterolateral), parameters_of(d.posteromedial), d.remodelling_mm;
  return parameters;
}

/// With the products of any two.
Eigen::VectorXd with_products(const Eigen::VectorXd& parameters) {
  const Index n = parameters.size();
  Eigen::VectorXd all(n + n * (n + 1) / 2);
  all.head(n) = parameters;
  Index next = n;
  for (Index i = 0; i < n; ++i)
    for (Index j = i; j < n; ++j) all[next++] = parameters[i] * parameters[j];
  return all;
}

enum class Fit { Linear, Quadratic };

/// Of the closures in `frame`, the first being the one that the rest is counted from.
std::vector<FrameShare> shares_of(int disturbance, const std::vector<int>& frame, Fit fit) {
  const auto place = [fit](int d) {
    return fit == Fit::Linear ? parameters_of(d) : with_products(parameters_of(d));
  };
  std::vector<Eigen::VectorXd> places;
  for (const int d : frame) places.push_back(place(d));
  const Eigen::VectorXd wanted = place(disturbance);
  const std::vector<double> shares = linear_shares(places, wanted);
  Eigen::VectorXd reached = Eigen::VectorXd::Zero(wanted.size());
  std::vector<FrameShare> result;
  double first = 1.0;
  for (std::size_t j = 0; j < frame.size(); ++j) {
    reached += shares[j] * places[j];
    const double share = std::round(shares[j] / kShareStep) * kShareStep;
    if (j == 0 || share == 0.0) continue;
    result.push_back({frame[j], share});
    first -= share;
  }
  if (first != 0.0) result.insert(result.begin(), {frame[0], first});
  if ((reached - wanted).lpNorm<Eigen::Infinity>() > kSpanned) return {};
  return result;
}

std::vector<int> first_nodes(int count) {
  std::vector<int> nodes(count + 1);
  for (int d = 0; d <= count; ++d) nodes[d] = d;
  return nodes;
}

std::vector<FrameShare> region_shares(int d) {
  if (d > kQuadratic) return shares_of(d, first_nodes(kQuadratic), Fit::Quadratic);
  const int nodes = d > kLinear ? kLinear : std::min(d - 1, kSpanning);
  return shares_of(d, first_nodes(nodes), Fit::Linear);
}

/// Of one muscle alone: the ends of both axes, then of the diagonals, not quite at the border.
std::vector<int> slice_frame(Side side) {
  constexpr int kLength = 3, kAngle = 4;  // from the middle of 4 and 5
  constexpr int kMiddle = kRegionLengths / 2, kMiddleAngle = kRegionAngles / 2;
  std::vector<int> nodes = {0};
  for (const auto& [length, angle] :
       {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}})
    nodes.push_back(slice_node(side, kMiddle + kLength * length, kMiddleAngle + kAngle * angle));
  return nodes;
}

std::vector<FrameShare> slice_shares(int d, Side side) {
  constexpr int kAxes = 5;  // the plan as planned and the ends of two axes
  const std::vector<int> frame = slice_frame(side);
  const auto own = std::find(frame.begin(), frame.end(), d);
  if (own == frame.end()) return shares_of(d, frame, Fit::Quadratic);
  const auto before = std::min<std::ptrdiff_t>(own - frame.begin(), kAxes);
  return shares_of(d, {frame.begin(), frame.begin() + before}, Fit::Linear);
}

/// From the two before it on its ray or course.
template <class Way>
std::vector<FrameShare> shares_along(const std::vector<Way>& ways, int d) {
  for (const Way& way : ways)
    for (std::size_t step = 2; step < way.indices.size(); ++step)
      if (way.indices[step] == d)
        return shares_of(d, {way.indices[step - 2], way.indices[step - 1]}, Fit::Linear);
  return {};
}

bool is_in(const DisturbanceSet& set, int d) { return d >= set.first && d < set.first + set.count; }

std::vector<FrameShare> make_shares(int d) {
  if (d == 0) return {};
  if (is_in(kRegion, d)) return region_shares(d);
  if (is_in(kAnterolateralAlone, d)) return slice_shares(d, Side::Anterolateral);
  if (is_in(kPosteromedialAlone, d)) return slice_shares(d, Side::Posteromedial);
  if (is_in(kIndependent, d)) return {};  // ring and neochordae err, too, which no frame spans
  return is_in(kRemodelling, d) ? shares_along(remodelling_rays(), d)
                                : shares_along(disease_courses(), d);
}

struct Frame {
  std::vector<std::vector<FrameShare>> shares;
  std::vector<int> levels;
  std::vector<bool> inside;
};

const Frame& frame() {
  static const Frame all = [] {
    Frame made{{}, std::vector<int>(kDisturbances, -1), std::vector<bool>(kDisturbances, false)};
    for (int d = 0; d < kDisturbances; ++d) made.shares.push_back(make_shares(d));
    const auto level = [&made](const auto& self, int d) -> int {
      if (made.levels[d] >= 0) return made.levels[d];
      int highest = 0;
      for (const FrameShare& part : made.shares[d])
        highest = std::max(highest, self(self, part.disturbance));
      return made.levels[d] = d == 0 ? 0 : highest + 1;
    };
    for (int d = 0; d < kDisturbances; ++d) {
      level(level, d);
      for (const FrameShare& part : made.shares[d]) made.inside[part.disturbance] = true;
    }
    return made;
  }();
  return all;
}

}  // namespace

const std::vector<FrameShare>& predicted_from(int disturbance) {
  return frame().shares[disturbance];
}

int frame_level(int disturbance) { return frame().levels[disturbance]; }

bool in_frame(int disturbance) { return frame().inside[disturbance]; }

}  // namespace coapt
