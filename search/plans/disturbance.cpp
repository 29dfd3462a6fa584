#include "search/plans/disturbance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "core/repair/approximation.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/remodel.h"
#include "search/latin_hypercube.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr int kRayLength_mm = 6;  // as far as the thesis displaces tips (4.2.2)

// Of the posteromedial muscle's nodes: of the seeds 1 to 10,000 the one that leaves no node with
// itself and correlates lengths, angles and sizes of both muscles' errors least (0.06; a cyclic
// order: 0.8, since nodes come in opposite pairs). If it or the region's order changes, errors may
// be linked.
constexpr std::uint64_t kShuffleSeed = 3370;

int index_of(const Perturbation& node) {
  const int length = static_cast<int>(std::lround(node.length_mm / kLengthStep_mm)) + 4;
  const int outwards = static_cast<int>(std::lround(node.outwards_deg)) + 5;
  const int posterior = static_cast<int>(std::lround(node.posterior_deg)) + 5;
  return (length * kRegionAngles + outwards) * kRegionAngles + posterior;
}

Perturbation slice_at(int cell) {
  return {kLengthStep_mm * (cell / kRegionAngles - 4), 1.0 * (cell % kRegionAngles - 5), 0.0};
}

/// The numbers 1 to `count`, shuffled.
std::vector<int> shuffled(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1);
  std::mt19937_64 engine(kShuffleSeed);
  for (int left = count; left > 1; --left)
    std::swap(numbers[left - 1], numbers[static_cast<int>(left * random_share(engine))]);
  return numbers;
}

struct Ray {
  const char* name;
  Vec3 direction;  // outwards, posterior, apical
};
const std::array<Ray, 4> kRays = {Ray{"apical", Vec3(0, 0, 1)}, Ray{"outwards", Vec3(1, 0, 0)},
                                  Ray{"posterior", Vec3(0, 1, 0)},
                                  Ray{"all three", Vec3(1, 1, 1).normalized()}};

constexpr int kCourses = 8;

/// As disturbance.h has it, after `mm` of the posteromedial tip.
Disturbance disease_at(int course, double mm) {
  constexpr double kSpread = 0.5;                               // sd over mean: 3.4 / 6.8
  constexpr double kGrowth = 4.9 / 6.5, kGrowthSd = 2.7 / 6.5;  // mm a mm
  constexpr double kShare = 0.5, kShareSd = 0.29;               // uniform from 0 to 1
  const auto sign = [course](int bits) {  // the product of some of the three main factors
    double product = 1.0;
    for (int bit = 0; bit < 3; ++bit)
      if ((bits >> bit & 1) != 0) product *= (course >> bit & 1) != 0 ? 1.0 : -1.0;
    return product;
  };
  const Vec3 way = Vec3(8.0 * (1.0 + kSpread * sign(1)), 8.0 * (1.0 + kSpread * sign(2)),
                        5.0 * (1.0 + kSpread * sign(4)))
                       .normalized();
  return {{}, {}, mm * way, kShare + kShareSd * sign(3), mm * (kGrowth + kGrowthSd * sign(5))};
}

constexpr double kShift_mm = 1.5, kTurn_deg = 5.0, kNeochorda_mm = 1.0, kTornShare = 0.25;
constexpr std::uint64_t kSewingSeed = 1;

/// A Latin hypercube.
std::vector<SewingError> sewing_errors(int count) {
  std::vector<SewingError> errors;
  for (const std::vector<double>& share : latin_hypercube(count, 5, kSewingSeed)) {
    const auto within = [&share](int factor, double most) {
      return (2.0 * share[factor] - 1.0) * most;
    };
    errors.push_back({within(0, kShift_mm), within(1, kShift_mm), within(2, kTurn_deg),
                      share[3] < kTornShare ? share[3] / kTornShare : -1.0,
                      within(4, kNeochorda_mm)});
  }
  return errors;
}

std::vector<Disturbance> make_disturbances() {
  std::vector<Disturbance> all;
  const std::vector<Perturbation> region = region_of_interest();
  for (const Perturbation& node : region) all.push_back({node, node});
  constexpr int kMiddle = kRegionLengths * kRegionAngles / 2;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial})
    for (int cell = 0; cell < kRegionLengths * kRegionAngles; ++cell) {
      if (cell == kMiddle) continue;
      const bool anterolateral = side == Side::Anterolateral;
      all.push_back({anterolateral ? slice_at(cell) : Perturbation{},
                     anterolateral ? Perturbation{} : slice_at(cell)});
    }
  const std::vector<int> partners = shuffled(kIndependent.count);
  const std::vector<SewingError> sewing = sewing_errors(kIndependent.count);
  for (std::size_t k = 0; k < partners.size(); ++k)
    all.push_back({.anterolateral = region[k + 1],
                   .posteromedial = region[partners[k]],
                   .sewing = sewing[k]});
  for (const Ray& ray : kRays)
    for (int mm = 1; mm <= kRayLength_mm; ++mm) all.push_back({{}, {}, mm * ray.direction});
  for (int course = 0; course < kCourses; ++course)
    for (int step = 1; step <= kCourseSteps; ++step)
      all.push_back(disease_at(course, step * kCourseStep_mm));
  assert(std::ssize(all) == kDisturbances);
  return all;
}

/// How much of the pull of the ring's torn suture is lost at each vertex of the annulus: all at it, none at its neighbours.
std::vector<double> torn_shares(const Valve& repaired, double torn_out) {
  const std::size_t size = repaired.annulus.size();
  std::size_t first = 0;
  while (repaired.annulus[first] != repaired.landmarks.saddle_peak) ++first;
  std::vector<double> around(size);  // way from the saddle peak
  double length = 0.0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t i = (first + k) % size;
    around[i] = length;
    length += (repaired.annulus_mm.row((i + 1) % size) - repaired.annulus_mm.row(i)).norm();
  }
  for (double& place : around) {
    const double apart = std::abs(place / length - torn_out);
    const double spacings = kRingSutureCount * std::min(apart, 1.0 - apart);
    place = spacings < 1.0 ? 0.5 + 0.5 * std::cos(std::numbers::pi * spacings) : 0.0;
  }
  return around;
}

/// Of a valve whose annulus a ring holds; `before` had none.
void missew(const Valve& before, const SewingError& error, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const std::vector<double> torn = error.torn_out < 0.0
                                       ? std::vector<double>(valve.annulus.size(), 0.0)
                                       : torn_shares(valve, error.torn_out);
  const double turn = error.turn_deg * std::numbers::pi / 180.0;
  for (std::size_t i = 0; i < torn.size(); ++i) {
    const Vec3 sewn = into_frame(frame, valve.annulus_mm.row(i));
    const Vec3 off(
        std::cos(turn) * sewn.x() - std::sin(turn) * sewn.y() + error.shift_transverse_mm,
        std::sin(turn) * sewn.x() + std::cos(turn) * sewn.y() + error.shift_anterior_mm, sewn.z());
    const Vec3 free = before.annulus_mm.row(i);
    valve.annulus_mm.row(i) = (1.0 - torn[i]) * out_of_frame(frame, off) + torn[i] * free;
  }
}

double share_of(const Perturbation& node) {
  return std::max({std::abs(node.length_mm) / kRegionLength_mm,
                   std::abs(node.outwards_deg) / kRegionAngle_deg,
                   std::abs(node.posterior_deg) / kRegionAngle_deg});
}

}  // namespace

const std::vector<Disturbance>& disturbances() {
  static const std::vector<Disturbance> all = make_disturbances();
  return all;
}

double region_share(const Disturbance& disturbance) {
  return std::max(share_of(disturbance.anterolateral), share_of(disturbance.posteromedial));
}

int region_node(int length, int outwards, int posterior) {
  static const std::vector<int> by_place = [] {
    std::vector<int> places(kRegion.count);
    for (int k = 0; k < kRegion.count; ++k) places[index_of(disturbances()[k].anterolateral)] = k;
    return places;
  }();
  return by_place[(length * kRegionAngles + outwards) * kRegionAngles + posterior];
}

int slice_node(Side side, int length, int outwards) {
  const int cell = length * kRegionAngles + outwards, middle = kRegionLengths * kRegionAngles / 2;
  if (cell == middle) return 0;
  const DisturbanceSet set =
      side == Side::Anterolateral ? kAnterolateralAlone : kPosteromedialAlone;
  return set.first + cell - (cell > middle ? 1 : 0);
}

const std::vector<RemodellingRay>& remodelling_rays() {
  static const std::vector<RemodellingRay> rays = [] {
    std::vector<RemodellingRay> all;
    int next = kRemodelling.first;
    for (const Ray& ray : kRays) {
      all.push_back({ray.name, {0}});
      for (int mm = 1; mm <= kRayLength_mm; ++mm) all.back().indices.push_back(next++);
    }
    return all;
  }();
  return rays;
}

const std::vector<DiseaseCourse>& disease_courses() {
  static const std::vector<DiseaseCourse> courses = [] {
    std::vector<DiseaseCourse> all;
    int next = kDisease.first;
    for (int course = 0; course < kCourses; ++course) {
      all.push_back({{0}});
      for (int step = 1; step <= kCourseSteps; ++step) all.back().indices.push_back(next++);
    }
    return all;
  }();
  return courses;
}

Valve disturb(const Valve& before, const Valve& repaired, const RepairPlan& plan,
              const Disturbance& disturbance) {
  Valve valve = repaired;
  const bool ring = has_step<Annuloplasty>(plan);
  if (!ring && disturbance.annular_growth_mm > 0.0)
    grow_annulus(disturbance.annular_growth_mm, valve);
  if (ring && disturbance.sewing != SewingError{}) missew(before, disturbance.sewing, valve);
  for (Chorda& chorda : valve.chordae)
    if (chorda.kind == ChordaKind::Neochorda)
      chorda.segments.front().rest_length_mm += disturbance.sewing.neochorda_mm;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const bool anterolateral = side == Side::Anterolateral;
    const PapillaryApproximation* suture = suture_of(plan, side);
    const Vec3 anchor = anchor_mm(
        repaired, suture != nullptr
                      ? *suture
                      : PapillaryApproximation{.side = side, .anchor = Anchor::IpsilateralTrigone});
    const double outwards = anterolateral ? -1.0 : 1.0;
    const Vec3 tip = papillary_tip_mm(repaired, side);
    const Perturbation& node =
        anterolateral ? disturbance.anterolateral : disturbance.posteromedial;
    Vec3 moved = disturbed_tip(tip, anchor, outwards, node);
    const double reach = (moved - anchor).norm();
    const Vec3 further =
        (anterolateral ? disturbance.anterolateral_share : 1.0) * disturbance.remodelling_mm;
    moved += Vec3(outwards * further.x(), -further.y(), -further.z());
    const double now = (moved - anchor).norm();
    if (suture != nullptr && now > reach) moved = anchor + reach / now * (moved - anchor);
    for (PapillaryHead& head : valve.heads)
      if (head.side == side) head.tip_mm += moved - tip;
  }
  return valve;
}

}  // namespace coapt
