#include "search/plans/disturbance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "core/repair/apply_plan.h"
#include "core/valve/annulus_frame.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const Vec3 kSaddlePeak(0.0, 14.0, 0.0);  // of the small valve

const Disturbance& disturbance(int index) {
  return disturbances().at(static_cast<std::size_t>(index));
}

std::tuple<double, double, double> place(const Perturbation& node) {
  return {node.length_mm, node.outwards_deg, node.posterior_deg};
}

const std::tuple<double, double, double> kMiddle = {0.0, 0.0, 0.0};

/// Both muscles at one node.
Disturbance both(const Perturbation& node) { return {node, node}; }
Disturbance remodelling(const Vec3& further_mm) { return {{}, {}, further_mm}; }

RepairPlan suture(double length_mm) {
  return {{PapillaryApproximation{
      .side = Side::Anterolateral, .anchor = Anchor::SaddlePeak, .suture_length_mm = length_mm}}};
}

TEST(Disturbances, AreTheRegionTheSlicesTheIndependentNodesRemodellingAndDisease) {
  EXPECT_EQ(std::ssize(disturbances()), kDisturbances);
  int next = 0;
  for (const DisturbanceSet& set :
       {kRegion, kAnterolateralAlone, kPosteromedialAlone, kIndependent, kRemodelling, kDisease}) {
    EXPECT_EQ(set.first, next);
    next = set.first + set.count;
  }
  EXPECT_EQ(next, kDisturbances);
  for (int d = 0; d < kDisturbances; ++d) {
    const bool remodels = d >= kRemodelling.first;
    EXPECT_EQ(disturbance(d).remodelling_mm.norm() > 0.0, remodels);
    EXPECT_EQ(region_share(disturbance(d)) == 0.0, remodels || d == 0) << d;
  }
}

TEST(Disturbances, OfTheRegionTakeBothMusclesToOneNodeInTheRegionsOrder) {
  const std::vector<Perturbation> region = region_of_interest();
  for (int d = 0; d < kRegion.count; ++d) {
    EXPECT_EQ(place(disturbance(d).anterolateral), place(region[static_cast<std::size_t>(d)]));
    EXPECT_EQ(place(disturbance(d).posteromedial), place(region[static_cast<std::size_t>(d)]));
  }
}

TEST(Disturbances, RegionNodeFindsEachNodeByItsPlace) {
  std::set<int> found;
  for (int l = 0; l < kRegionLengths; ++l)
    for (int o = 0; o < kRegionAngles; ++o)
      for (int p = 0; p < kRegionAngles; ++p) {
        const int node = region_node(l, o, p);
        EXPECT_EQ(place(disturbance(node).anterolateral),
                  std::tuple(0.25 * (l - 4), 1.0 * (o - 5), 1.0 * (p - 5)));
        found.insert(node);
      }
  EXPECT_EQ(found.size(), 1089u);
  EXPECT_EQ(region_node(4, 5, 5), 0);
}

TEST(Disturbances, SliceNodeFindsEachNodeOfOneMuscleAlone) {
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    const bool left = side == Side::Anterolateral;
    const DisturbanceSet set = left ? kAnterolateralAlone : kPosteromedialAlone;
    std::set<int> found;
    for (int l = 0; l < kRegionLengths; ++l)
      for (int o = 0; o < kRegionAngles; ++o) {
        const int node = slice_node(side, l, o);
        const Disturbance& d = disturbance(node);
        EXPECT_EQ(place(left ? d.anterolateral : d.posteromedial),
                  std::tuple(0.25 * (l - 4), 1.0 * (o - 5), 0.0));
        EXPECT_EQ(place(left ? d.posteromedial : d.anterolateral), kMiddle);
        if (node == 0) continue;
        EXPECT_GE(node, set.first);
        EXPECT_LT(node, set.first + set.count);
        found.insert(node);
      }
    EXPECT_EQ(std::ssize(found), set.count);
    EXPECT_EQ(slice_node(side, 4, 5), 0);
  }
}

TEST(Disturbances, IndependentNodesAreThoseOfTheRegionOnceForEachMuscle) {
  std::set<std::tuple<double, double, double>> first_64, left, right;
  for (int k = 0; k < kIndependent.count; ++k) {
    first_64.insert(place(disturbance(1 + k).anterolateral));
    const Disturbance& d = disturbance(kIndependent.first + k);
    left.insert(place(d.anterolateral));
    right.insert(place(d.posteromedial));
    EXPECT_NE(place(d.anterolateral), place(d.posteromedial));
  }
  EXPECT_EQ(left, first_64);
  EXPECT_EQ(right, first_64);
  EXPECT_EQ(first_64.size(), 64u);
}

Vec3 units(const Perturbation& node) {
  return {node.length_mm, node.outwards_deg / 5.0, node.posterior_deg / 5.0};
}

TEST(Disturbances, IndependentErrorsOfTheTwoMusclesAreUncorrelated) {
  // Over all nodes both means are 0 and both spreads the same.
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  Vec3 square = Vec3::Zero();
  double sizes = 0.0, size = 0.0, size_square = 0.0;
  for (int k = 0; k < kIndependent.count; ++k) {
    const Disturbance& d = disturbance(kIndependent.first + k);
    const Vec3 left = units(d.anterolateral), right = units(d.posteromedial);
    product += left * right.transpose();
    square += left.cwiseAbs2();
    sizes += left.squaredNorm() * right.squaredNorm() / kIndependent.count;
    size += left.squaredNorm() / kIndependent.count;
    size_square += left.squaredNorm() * left.squaredNorm() / kIndependent.count;
  }
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_LT(std::abs(product(a, b)) / std::sqrt(square[a] * square[b]), 0.1) << a << b;
  EXPECT_LT(std::abs(sizes - size * size) / (size_square - size * size), 0.1);
}

TEST(Disturbances, RemodellingGoesOneToSixMillimetresAlongFourRays) {
  const std::vector<Vec3> directions = {
      {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, Vec3::Ones() / std::sqrt(3)};
  ASSERT_EQ(remodelling_rays().size(), 4u);
  std::set<int> used;
  for (std::size_t ray = 0; ray < 4; ++ray) {
    const std::vector<int>& indices = remodelling_rays()[ray].indices;
    ASSERT_EQ(indices.size(), 7u);
    EXPECT_EQ(indices[0], 0);
    for (std::size_t mm = 0; mm <= 6; ++mm) {
      const Vec3 further = disturbance(indices[mm]).remodelling_mm;
      EXPECT_NEAR((further - static_cast<double>(mm) * directions[ray]).norm(), 0.0, 1e-12);
      if (mm > 0) used.insert(indices[mm]);
    }
  }
  EXPECT_EQ(std::ssize(used), kRemodelling.count);
}

TEST(Disturbances, CoursesOfDiseaseHaveTheMeansAndSpreadsOfTheirSource) {
  ASSERT_EQ(disease_courses().size(), 8u);
  double growth = 0.0, growth2 = 0.0, share = 0.0, share2 = 0.0;
  std::set<int> used;
  for (const DiseaseCourse& course : disease_courses()) {
    ASSERT_EQ(course.indices.size(), 4u);
    EXPECT_EQ(course.indices[0], 0);
    const Disturbance& first = disturbance(course.indices[1]);
    for (std::size_t step = 1; step <= 3; ++step) {
      const Disturbance& d = disturbance(course.indices[step]);
      const double times = static_cast<double>(step);
      EXPECT_NEAR(d.remodelling_mm.norm(), kCourseStep_mm * times, 1e-12);
      EXPECT_NEAR((d.remodelling_mm - times * first.remodelling_mm).norm(), 0.0, 1e-12);
      EXPECT_NEAR(d.annular_growth_mm, times * first.annular_growth_mm, 1e-12);
      EXPECT_EQ(d.anterolateral_share, first.anterolateral_share);
      EXPECT_GT(d.remodelling_mm.minCoeff(), 0.0);
      used.insert(course.indices[step]);
    }
    const double a_mm = first.annular_growth_mm / kCourseStep_mm;
    growth += a_mm / 8.0;
    growth2 += a_mm * a_mm / 8.0;
    share += first.anterolateral_share / 8.0;
    share2 += first.anterolateral_share * first.anterolateral_share / 8.0;
  }
  EXPECT_EQ(std::ssize(used), kDisease.count);
  EXPECT_NEAR(growth, 4.9 / 6.5, 1e-12);  // Tibayan 2003
  EXPECT_NEAR(std::sqrt(growth2 - growth * growth), 2.7 / 6.5, 1e-12);
  EXPECT_NEAR(share, 0.5, 1e-12);
  EXPECT_NEAR(std::sqrt(share2 - share * share), 0.29, 1e-12);
}

TEST(Disturbances, TheirShareIsHowFarTheWorseMuscleGoesToTheBorder) {
  EXPECT_EQ(region_share({}), 0.0);
  EXPECT_EQ(region_share(both({-1.0, 0.0, 0.0})), 1.0);
  EXPECT_EQ(region_share(both({0.25, -2.0, 1.0})), 0.4);
  EXPECT_EQ(region_share({{0.25, 0.0, 0.0}, {0.0, 0.0, 3.0}}), 0.6);
  EXPECT_EQ(region_share(remodelling({6.0, 0.0, 0.0})), 0.0);
}

TEST(Disturb, TipsMoveOnASphereAboutTheSuturesAnchor) {
  const Valve valve = *apply_plan(small_valve(), suture(29.0));
  const Valve disturbed = disturb(valve, valve, suture(29.0), both({0.5, 3.0, -4.0}));
  const Vec3 before = valve.heads[0].tip_mm - kSaddlePeak;
  const Vec3 after = disturbed.heads[0].tip_mm - kSaddlePeak;
  EXPECT_NEAR(after.norm(), 29.5, 1e-12);
  const double angle = std::acos(before.dot(after) / (before.norm() * after.norm()));
  EXPECT_NEAR(angle * 180.0 / std::numbers::pi, 5.0, 1e-9);  // 3, 4, 5
}

TEST(Disturb, WithoutASutureTheMuscleSwingsAboutItsTrigone) {
  const Valve valve = small_valve();
  const Valve disturbed = disturb(valve, valve, {}, both({-1.0, 0.0, 5.0}));
  const Vec3 anchor = valve.annulus_mm.row(1);
  EXPECT_NEAR((disturbed.heads[1].tip_mm - anchor).norm(),
              (valve.heads[1].tip_mm - anchor).norm() - 1.0, 1e-12);
}

TEST(Disturb, BothMusclesGoOutwardsAndBackwardsTogether) {
  // The small valve is symmetric about x = 0.
  const Valve valve = small_valve();
  const Valve outwards = disturb(valve, valve, {}, both({0.0, 5.0, 0.0}));
  EXPECT_LT(outwards.heads[0].tip_mm.x(), valve.heads[0].tip_mm.x() - 1.0);
  EXPECT_GT(outwards.heads[1].tip_mm.x(), valve.heads[1].tip_mm.x() + 1.0);
  const Valve disturbed = disturb(valve, valve, {}, both({0.25, 2.0, 3.0}));
  const Vec3 left = disturbed.heads[0].tip_mm, right = disturbed.heads[1].tip_mm;
  EXPECT_NEAR((Vec3(-left.x(), left.y(), left.z()) - right).norm(), 0.0, 1e-12);
  EXPECT_LT(disturb(valve, valve, {}, both({0.0, 0.0, 5.0})).heads[0].tip_mm.y(),
            valve.heads[0].tip_mm.y() - 1.0);
}

TEST(Disturb, TheUndisturbedNodeChangesNothingAndOneMuscleAloneLeavesTheOther) {
  const Valve valve = small_valve();
  const Valve same = disturb(valve, valve, {}, disturbance(0));
  const Valve right = disturb(valve, valve, {},
                              disturbance(slice_node(Side::Posteromedial, kRegionLengths - 1, 0)));
  for (std::size_t h = 0; h < valve.heads.size(); ++h)
    EXPECT_NEAR((same.heads[h].tip_mm - valve.heads[h].tip_mm).norm(), 0.0, 1e-12);
  EXPECT_NEAR((right.heads[0].tip_mm - valve.heads[0].tip_mm).norm(), 0.0, 1e-12);
  EXPECT_GT((right.heads[1].tip_mm - valve.heads[1].tip_mm).norm(), 2.0);
}

TEST(Disturb, HeadsOfOneMuscleMoveAsOne) {
  Valve valve = small_valve();
  PapillaryHead second = valve.heads[0];
  second.id = "AL2";
  second.tip_mm += Vec3(3.0, 1.0, -2.0);
  valve.heads.push_back(second);
  const Valve disturbed = disturb(valve, valve, {}, both({1.0, 4.0, -2.0}));
  const Vec3 moved = disturbed.heads[0].tip_mm - valve.heads[0].tip_mm;
  EXPECT_GT(moved.norm(), 1.0);
  EXPECT_NEAR((disturbed.heads[2].tip_mm - second.tip_mm - moved).norm(), 0.0, 1e-12);
}

TEST(Disturb, AnUnsuturedMuscleFollowsTheVentricle) {
  const Valve valve = small_valve();
  const Valve further = disturb(valve, valve, {}, remodelling({1.0, 2.0, 3.0}));
  const Vec3 left = further.heads[0].tip_mm - valve.heads[0].tip_mm;
  const Vec3 right = further.heads[1].tip_mm - valve.heads[1].tip_mm;
  EXPECT_NEAR((left - Vec3(-1.0, -2.0, -3.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((right - Vec3(1.0, -2.0, -3.0)).norm(), 0.0, 1e-12);
}

TEST(Disturb, DiseaseWidensAnAnnulusThatNoRingHolds) {
  const Valve valve = small_valve();
  Disturbance disease = remodelling({2.0, 0.0, 0.0});
  disease.anterolateral_share = 0.5;
  disease.annular_growth_mm = 1.5;
  const Valve further = disturb(valve, valve, {}, disease);
  EXPECT_NEAR(ap_diameter_mm(further), ap_diameter_mm(valve) + 1.5, 0.02);
  EXPECT_NEAR(further.heads[0].tip_mm.x(), valve.heads[0].tip_mm.x() - 1.0, 1e-12);
  EXPECT_NEAR(further.heads[1].tip_mm.x(), valve.heads[1].tip_mm.x() + 2.0, 1e-12);
  const RepairPlan ring{{Annuloplasty{OwnRing{0}}}};
  const Valve repaired = *apply_plan(valve, ring);
  EXPECT_EQ(disturb(valve, repaired, ring, disease).annulus_mm, repaired.annulus_mm);
}

TEST(Disturbances, IndependentNodesSewWithAllErrorsAndTearASutureOutOfAQuarter) {
  int torn = 0;
  double shift = 0.0, turn = 0.0, neochorda = 0.0;
  for (int k = 0; k < kIndependent.count; ++k) {
    const SewingError& error = disturbance(kIndependent.first + k).sewing;
    torn += error.torn_out >= 0.0;
    shift = std::max(shift, std::hypot(error.shift_transverse_mm, error.shift_anterior_mm));
    turn = std::max(turn, std::abs(error.turn_deg));
    neochorda = std::max(neochorda, std::abs(error.neochorda_mm));
  }
  EXPECT_EQ(torn, kIndependent.count / 4);
  EXPECT_GT(shift, 1.2);
  EXPECT_LE(shift, 1.5 * std::sqrt(2.0));
  EXPECT_NEAR(turn, 5.0, 0.2);
  EXPECT_NEAR(neochorda, 1.0, 0.05);
  EXPECT_EQ(disturbance(kIndependent.first - 1).sewing, SewingError{});
}

TEST(Disturb, ARingIsSewnOffItsPlaceAndTurned) {
  const Valve valve = small_valve();
  const RepairPlan ring{{Annuloplasty{OwnRing{2}}}};
  const Valve repaired = *apply_plan(valve, ring);
  Disturbance error;
  error.sewing = {.shift_transverse_mm = 1.0, .shift_anterior_mm = -0.5, .turn_deg = 90.0};
  const AnnulusFrame frame = annulus_frame(repaired, AnnulusAxis::SaddlePeak);
  const Valve sewn = disturb(valve, repaired, ring, error);
  for (Index i = 0; i < sewn.annulus_mm.rows(); ++i) {
    const Vec3 was = into_frame(frame, repaired.annulus_mm.row(i));
    const Vec3 is = into_frame(frame, sewn.annulus_mm.row(i));
    EXPECT_NEAR((is - Vec3(1.0 - was.y(), was.x() - 0.5, was.z())).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(disturb(valve, valve, {}, error).annulus_mm, valve.annulus_mm) << "no ring, no error";
}

TEST(Disturb, WhereASutureTearsOutTheAnnulusGoesBack) {
  const Valve valve = small_valve();
  const RepairPlan ring{{Annuloplasty{OwnRing{2}}}};
  const Valve repaired = *apply_plan(valve, ring);
  Disturbance error;
  error.sewing.torn_out = 0.0;  // at the saddle peak
  const Valve torn = disturb(valve, repaired, ring, error);
  for (std::size_t i = 0; i < torn.annulus.size(); ++i) {
    const bool peak = torn.annulus[i] == torn.landmarks.saddle_peak;
    const Points& expected = peak ? valve.annulus_mm : repaired.annulus_mm;  // an eighth apart
    EXPECT_NEAR((torn.annulus_mm.row(i) - expected.row(i)).norm(), 0.0, 1e-9) << i;
  }
}

TEST(Disturb, NeochordaeAreTiedTooLong) {
  const Valve valve = small_valve();
  const RepairPlan plan{{Neochorda{"AL1", {Leaflet::Posterior, 0.5, 0.9}, 25.0}}};
  const Expected<Valve> repaired = apply_plan(valve, plan);
  ASSERT_TRUE(repaired);
  Disturbance error;
  error.sewing.neochorda_mm = 0.75;
  const Valve tied = disturb(valve, *repaired, plan, error);
  for (std::size_t c = 0; c < tied.chordae.size(); ++c) {
    const bool neochorda = tied.chordae[c].kind == ChordaKind::Neochorda;
    EXPECT_DOUBLE_EQ(tied.chordae[c].segments[0].rest_length_mm,
                     repaired->chordae[c].segments[0].rest_length_mm + (neochorda ? 0.75 : 0.0));
  }
}

TEST(Disturb, ATautSutureHolds) {
  const Valve valve = *apply_plan(small_valve(), suture(29.0));
  for (const RemodellingRay& ray : remodelling_rays())
    for (std::size_t mm = 1; mm <= 6; ++mm) {
      const Disturbance& d = disturbance(ray.indices[mm]);
      const Valve further = disturb(valve, valve, suture(29.0), d);
      const Vec3 free = valve.heads[0].tip_mm +
                        Vec3(-d.remodelling_mm.x(), -d.remodelling_mm.y(), -d.remodelling_mm.z());
      ASSERT_GT((free - kSaddlePeak).norm(), 29.0) << "it would lengthen the suture";
      const Vec3 held = kSaddlePeak + 29.0 * (free - kSaddlePeak).normalized();
      EXPECT_NEAR((further.heads[0].tip_mm - held).norm(), 0.0, 1e-9);
      EXPECT_NEAR((further.heads[1].tip_mm - valve.heads[1].tip_mm).norm(), static_cast<double>(mm),
                  1e-12);
    }
}

TEST(Disturb, ASutureTiedLongHoldsAtItsLengthAndDoesNotPush) {
  const Valve valve = *apply_plan(small_valve(), suture(29.0));
  Disturbance tied_long = both({1.0, 0.0, 0.0});
  tied_long.remodelling_mm = Vec3(0.0, 0.0, 6.0);
  EXPECT_NEAR((disturb(valve, valve, suture(29.0), tied_long).heads[0].tip_mm - kSaddlePeak).norm(),
              30.0, 1e-9);
  const Valve nearer = disturb(valve, valve, suture(29.0), remodelling({0.0, 0.0, -3.0}));
  EXPECT_NEAR((nearer.heads[0].tip_mm - valve.heads[0].tip_mm - Vec3(0.0, 0.0, 3.0)).norm(), 0.0,
              1e-12);
}

}  // namespace
}  // namespace coapt
