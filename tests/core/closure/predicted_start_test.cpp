#include "core/closure/predicted_start.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/closure/closure.h"
#include "core/valve/remodel.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

using Parameters = std::vector<Eigen::VectorXd>;

Eigen::VectorXd at(double a, double b) { return Eigen::Vector2d(a, b); }

/// The middle and both ends of two axes.
Parameters cross() { return {at(0, 0), at(1, 0), at(-1, 0), at(0, 2), at(0, -2)}; }

const Faces kTwoFaces = (Faces(2, 3) << 0, 1, 2, 3, 4, 5).finished();

/// Two parallel triangles, of which the upper one lies `height_mm` above the other.
ClosureResult two_faces(double height_mm) {
  ClosureResult closure;
  closure.status = ClosureStatus::Converged;
  closure.closed_mm.resize(6, 3);
  closure.closed_mm << 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, height_mm, 2, 1, height_mm, 1, 2, height_mm;
  closure.branch_points_mm = {Points::Constant(1, 3, height_mm)};
  return closure;
}

TEST(LinearShares, AreExactForWhatIsLinearAndAddUpToOne) {
  const Parameters places = cross();
  for (const Eigen::VectorXd& wanted : {at(0.3, -0.7), at(-2.0, 1.0), at(0, 0), at(1, 0)}) {
    const std::vector<double> shares = linear_shares(places, wanted);
    Eigen::VectorXd reached = at(0, 0);
    double sum = 0.0, value = 0.0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      reached += shares[j] * places[j];
      sum += shares[j];
      value += shares[j] * (3.0 - 2.0 * places[j][0] + 0.5 * places[j][1]);
    }
    EXPECT_NEAR((reached - wanted).norm(), 0.0, 1e-12);
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(value, 3.0 - 2.0 * wanted[0] + 0.5 * wanted[1], 1e-12);
  }
}

TEST(LinearShares, OfOnePairAreKnownByHand) {
  EXPECT_EQ(linear_shares(Parameters{at(0, 0)}, at(1, 1)), std::vector<double>{1.0});
  const std::vector<double> opposite = linear_shares(Parameters{at(0, 0), at(1, 1)}, at(-1, -1));
  EXPECT_NEAR(opposite[0], 2.0, 1e-12);
  EXPECT_NEAR(opposite[1], -1.0, 1e-12);
}

TEST(LinearShares, LeaveOutADirectionThatNoClosureHas) {
  const std::vector<double> shares = linear_shares(Parameters{at(0, 0), at(2, 0)}, at(1, 5));
  EXPECT_NEAR(shares[0], 0.5, 1e-12);
  EXPECT_NEAR(shares[1], 0.5, 1e-12);
}

TEST(PredictedStart, IsTheSharesMeanWithTheGuardsOfAll) {
  ClosureResult low = two_faces(1.0), high = two_faces(3.0);
  low.guarded_faces = {0};
  high.guarded_faces = {0, 1};
  const auto start =
      predicted_start(kTwoFaces, std::vector<ClosureShare>{{&low, 0.5}, {&high, 0.5}});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->closed_mm, two_faces(2.0).closed_mm);
  EXPECT_EQ(start->branch_points_mm[0], two_faces(2.0).branch_points_mm[0]);
  EXPECT_EQ(start->guarded_faces, (std::vector<int>{0, 1}));
  EXPECT_TRUE(start->predicted);
}

TEST(PredictedStart, IsNoneOfWhatIsNotTrustedOrOfAnotherMesh) {
  const ClosureResult good = two_faces(1.0);
  const auto with = [&good](const ClosureResult* other) {
    return predicted_start(kTwoFaces, std::vector<ClosureShare>{{&good, 0.5}, {other, 0.5}});
  };
  EXPECT_TRUE(with(&good));
  EXPECT_FALSE(with(nullptr));
  ClosureResult bad = good;
  bad.status = ClosureStatus::StepLimit;
  EXPECT_FALSE(with(&bad));
  bad = good;
  bad.crossing = true;
  EXPECT_FALSE(with(&bad));
  bad = good;
  bad.closed_mm.conservativeResize(5, 3);
  EXPECT_FALSE(with(&bad));
  bad = good;
  bad.branch_points_mm.clear();
  EXPECT_FALSE(with(&bad));
  EXPECT_FALSE(predicted_start(kTwoFaces, {}));
}

TEST(PredictedStart, IsNoneWhereItsLeafletsCross) {
  ClosureResult upright = two_faces(1.0);  // the second face, upright above and below the first
  upright.closed_mm.bottomRows(3) << 1, 1, 2, 1.5, 1, 2, 1, 1, 1;
  ClosureResult below = upright;
  below.closed_mm.bottomRows(3).col(2) << -1, -1, -2;
  const auto mean = [&](double share) {
    return predicted_start(kTwoFaces,
                           std::vector<ClosureShare>{{&upright, share}, {&below, 1.0 - share}});
  };
  EXPECT_TRUE(mean(1.0));
  EXPECT_TRUE(mean(0.0));
  EXPECT_FALSE(mean(0.5)) << "the lower corner is at -0.5, the others at 0.5";
}

Valve displaced(const Valve& valve, double apical_mm) {
  Remodelling change;
  change.anterolateral_mm = change.posteromedial_mm = Vec3(0, 0, apical_mm);
  return *remodel(valve, change);
}

TEST(PredictedStart, LeadsToTheSameEndInFewerStepsThanOneNeighbour) {
  const Valve& valve = shared_preset("human-normal", 300);
  const Valve wanted = displaced(valve, 0.5);
  const ClosureResult near = close_valve(valve),
                      far = close_valve(displaced(valve, 1.0), {}, &near);
  const auto start =
      predicted_start(valve.faces, std::vector<ClosureShare>{{&near, 0.5}, {&far, 0.5}});
  ASSERT_TRUE(start);
  const ClosureResult warm = close_valve(wanted, {}, &near);
  const ClosureResult predicted = close_valve(wanted, {}, &*start);
  EXPECT_EQ(predicted.attempts[0].how, "float, from a prediction");
  EXPECT_EQ(predicted.status, ClosureStatus::Converged);
  EXPECT_FALSE(predicted.crossing);
  EXPECT_FALSE(predicted.predicted);
  EXPECT_LT(predicted.steps, warm.steps);
  const double rms = std::sqrt((predicted.closed_mm - warm.closed_mm).squaredNorm() /
                               static_cast<double>(warm.closed_mm.rows()));
  EXPECT_LT(rms, 0.05);
}

}  // namespace
}  // namespace coapt
