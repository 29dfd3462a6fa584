#include "search/studies/approximation_study.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "search/perturbation.h"
#include "search/plans/objective.h"
#include "search/studies/geometry_studies.h"

namespace coapt {
namespace {

constexpr double kCoarse_mm = 1.0,
                 kFine_mm = 0.25;      // steps to the anchor; the grid's, the suture's
constexpr double kLargestShare = 0.5;  // of the way to the anchor (core/repair/limits.h)
constexpr int kOptimumPoints = 9;      // of the region, to choose a suture length by
constexpr double kOptimumStep_mm = 4.0;
constexpr double kMostMovement_mm = 15.0;  // of a papillary muscle that is accepted (Optimum)

/// Between muscle and anchor; knows how far it has looked.
struct Walk {
  Approximation found;
  Vec3 anchor_mm = Vec3::Zero();
  double moved_mm = 0.0, step_mm = kCoarse_mm;
  double least_mm2 = std::numeric_limits<double>::infinity(), least_at_mm = 0.0;
  bool ended = false;

  Vec3 position_mm(double moved) const {
    const Vec3 way = anchor_mm - found.displaced_mm;
    return found.displaced_mm + moved / way.norm() * way;
  }
  double most_mm() const { return kLargestShare * (anchor_mm - found.displaced_mm).norm(); }
};

/// Places of the region of interest around a position. In the posteromedial muscle's axes: outwards
/// is x, posterior -y, apical -z.
std::vector<Vec3> region_around(const Vec3& position_mm, const Vec3& anchor_mm,
                                const std::vector<Perturbation>& nodes) {
  const Vec3 mirror(1.0, -1.0, -1.0);
  std::vector<Vec3> places;
  for (const Perturbation& node : nodes)
    places.push_back(
        disturbed_tip(position_mm.cwiseProduct(mirror), anchor_mm.cwiseProduct(mirror), 1.0, node)
            .cwiseProduct(mirror));
  return places;
}

/// Calls advance(item) for all that have not ended, closing what they ask for between rounds.
template <class Item, class Advance>
void in_rounds(OrificeField& field, std::vector<Item>& items, const Advance& advance) {
  do {
    field.close_wanted();
    for (Item& item : items)
      if (!item.ended) advance(item);
  } while (field.anything_wanted());
}

/// As far to the anchor as needed: by coarse steps to the first place below 5 mm2 (or as far as
/// allowed), then by fine ones from the coarse one before.
void walk_on(OrificeField& field, Walk& walk) {
  while (!walk.ended) {
    const std::optional<double> area =
        field.at(walk.found.displaced, walk.position_mm(walk.moved_mm));
    if (!area) return;
    if (*area < walk.least_mm2) {
      walk.least_mm2 = *area;
      walk.least_at_mm = walk.moved_mm;
    }
    if (*area < kMildLeak_mm2 && walk.step_mm == kCoarse_mm && walk.moved_mm > 0.0) {
      walk.moved_mm += kFine_mm - kCoarse_mm;
      walk.step_mm = kFine_mm;
      continue;
    }
    walk.found.repaired = *area < kMildLeak_mm2;
    if (walk.moved_mm + walk.step_mm > walk.most_mm()) walk.step_mm = kFine_mm;
    walk.ended = walk.found.repaired || walk.moved_mm + walk.step_mm > walk.most_mm();
    if (!walk.ended) walk.moved_mm += walk.step_mm;
  }
  if (!walk.found.repaired) walk.moved_mm = walk.least_at_mm;
}

/// What a planner would choose: where mean + sd over a few points of the region, and the price of
/// the movement, are lowest. By coarse steps first, then halving them around the best.
void choose_optimum(OrificeField& field, Walk& walk, const std::vector<Perturbation>& nodes) {
  const double most = std::min(walk.most_mm(), kMostMovement_mm);
  const double muscles = walk.found.displaced == Displaced::Both ? 2.0 : 1.0;
  double lowest = std::numeric_limits<double>::infinity(), best = 0.0;
  bool known = true;
  const auto consider = [&](double moved) {
    if (moved < 0.0 || moved > most) return;
    double sum = 0.0, squares = 0.0;
    for (const Vec3& place : region_around(walk.position_mm(moved), walk.anchor_mm, nodes)) {
      const std::optional<double> area = field.at(walk.found.displaced, place);
      known &= area.has_value();
      sum += area.value_or(0.0);
      squares += area.value_or(0.0) * area.value_or(0.0);
    }
    const double n = static_cast<double>(nodes.size()), mean = sum / n;
    const double score = mean + std::sqrt(std::max(0.0, squares / n - mean * mean)) +
                         muscles * movement_price(moved);
    if (!(score < lowest || (score == lowest && moved < best))) return;  // nor if it is NaN
    lowest = score;
    best = moved;
  };
  for (double moved = 0.0; moved <= most; moved += kOptimumStep_mm) consider(moved);
  for (double step = 0.5 * kOptimumStep_mm; known && step >= kCoarse_mm; step *= 0.5) {
    const double middle = best;
    consider(middle - step);
    consider(middle + step);
  }
  if (!known) return;
  walk.moved_mm = best;
  walk.ended = true;
}

RegionOrifice measure_region(const std::vector<double>& area_mm2,
                             const std::vector<Perturbation>& nodes, double suture_mm) {
  const Eigen::Index n = std::ssize(area_mm2);
  const Eigen::VectorXd area = Eigen::Map<const Eigen::VectorXd>(area_mm2.data(), n);
  RegionOrifice region;
  region.mean_mm2 = area.mean();
  region.sd_mm2 = std::sqrt((area.array() - region.mean_mm2).square().mean());
  region.worst_mm2 = area.maxCoeff();
  region.leaking_share =
      static_cast<double>((area.array() > kMildLeak_mm2).count()) / static_cast<double>(n);
  Eigen::MatrixXd offset(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Perturbation& node = nodes[i];
    offset.row(i) << node.length_mm, node.outwards_deg, node.posterior_deg;
  }
  offset.rowwise() -= offset.colwise().mean().eval();
  const Vec3 slope = offset.colPivHouseholderQr().solve((area.array() - region.mean_mm2).matrix());
  const auto sd_along = [n](const Eigen::VectorXd& part) {
    return std::sqrt(part.squaredNorm() / static_cast<double>(n));
  };
  region.length_slope_mm2_per_mm = slope(0);
  region.swing_slope_mm2_per_mm = slope.tail(2).norm() * 180.0 / (std::numbers::pi * suture_mm);
  region.length_sd_mm2 = sd_along(offset.col(0) * slope(0));
  region.angle_sd_mm2 = sd_along(offset.rightCols(2) * slope.tail(2));
  return region;
}

/// Displaced configurations that leak, each to each anchor.
std::vector<Walk> begin_walks(OrificeTable& table, const std::vector<AnchorSite>& anchors,
                              const ApproximationOptions& options) {
  const int nodes = 1 + static_cast<int>(kMostDisplacement_mm / options.displacement_step_mm);
  std::vector<Walk> walks;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k) {
    const DisplacementGrid grid =
        displacement_grid(table, kDisplaced[k], nodes, options.displacement_step_mm);
    for (std::size_t i = 0; i < grid.area_mm2.size(); ++i) {
      if (!(grid.area_mm2[i] > options.least_mm2)) continue;
      for (std::size_t a = 0; a < anchors.size(); ++a) {
        Walk walk;
        walk.found.displaced = kDisplaced[k];
        walk.found.displaced_mm = grid.displacement_mm(i);
        walk.found.displaced_area_mm2 = grid.area_mm2[i];
        walk.found.anchor = a;
        walk.anchor_mm = anchors[a].at_mm[k];
        walks.push_back(walk);
      }
    }
  }
  return walks;
}

}  // namespace

ApproximationStudy study_approximation(OrificeTable& table, Protocol protocol,
                                       const std::vector<AnchorSite>& anchors,
                                       const ApproximationOptions& options) {
  std::vector<Perturbation> nodes = region_of_interest();
  const std::vector<Perturbation> few(nodes.begin(), nodes.begin() + kOptimumPoints);
  nodes.resize(std::min(nodes.size(), static_cast<std::size_t>(options.region_points)));
  OrificeField field(table, protocol);
  std::vector<Walk> walks = begin_walks(table, anchors, options);
  in_rounds(field, walks, [&](Walk& walk) {
    if (protocol == Protocol::Optimum)
      choose_optimum(field, walk, few);
    else
      walk_on(field, walk);
  });
  for (Walk& walk : walks) walk.ended = false;
  in_rounds(field, walks, [&](Walk& walk) {
    Approximation& found = walk.found;
    found.position_mm = walk.position_mm(walk.moved_mm);
    const std::optional<double> there = field.at(found.displaced, found.position_mm);
    std::vector<double> areas;
    int outside = 0;
    for (const Vec3& place : region_around(found.position_mm, walk.anchor_mm, nodes)) {
      if (const std::optional<double> area = field.at(found.displaced, place))
        areas.push_back(*area);
      if (protocol == Protocol::LookupClamped && OrificeField::outside_grid(place)) ++outside;
    }
    if (!there || areas.size() < nodes.size()) return;
    walk.ended = true;
    found.movement_mm = walk.moved_mm;
    found.suture_mm = (walk.anchor_mm - found.position_mm).norm();
    found.area_mm2 = *there;
    found.repaired = *there < kMildLeak_mm2;
    found.region = measure_region(areas, nodes, found.suture_mm);
    found.region.clamped_share = static_cast<double>(outside) / static_cast<double>(nodes.size());
  });
  ApproximationStudy study{protocol, anchors, options, {}};
  for (const Walk& walk : walks) study.approximations.push_back(walk.found);
  return study;
}

}  // namespace coapt
