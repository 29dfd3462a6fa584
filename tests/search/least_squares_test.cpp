#include "search/least_squares.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coapt {
namespace {

using Point = Eigen::VectorXd;
using Residual = std::function<Point(const Point&)>;

Point point(std::initializer_list<double> values) {
  Point made(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), made.data());
  return made;
}

/// At several points; fails where one lies outside the cube.
ResidualsAt at_points(const Residual& residual, int* evaluations = nullptr) {
  return [=](const std::vector<Point>& points) {
    std::vector<Point> all;
    for (const Point& p : points) {
      EXPECT_TRUE(p.minCoeff() >= 0.0 && p.maxCoeff() <= 1.0) << p.transpose();
      all.push_back(residual(p));
    }
    if (evaluations != nullptr) *evaluations += static_cast<int>(points.size());
    return all;
  };
}

/// 3 residuals of 2 axes, zero at (0.4, 0.7).
Point linear(const Point& x) {
  const double u = x(0) - 0.4, v = x(1) - 0.7;
  return point({3.0 * u + v, u - 2.0 * v, u + v});
}

TEST(LeastSquares, SolvesALinearProblemInAFewRounds) {
  LeastSquaresOptions options;
  options.most_rounds = 6;
  const LeastSquaresFit fit = fit_least_squares(at_points(linear), point({0.1, 0.1}), options);
  EXPECT_NEAR(fit.point(0), 0.4, 1e-3);
  EXPECT_NEAR(fit.point(1), 0.7, 1e-3);
  EXPECT_NEAR(fit.cost, linear(fit.point).squaredNorm(), 1e-15);
}

TEST(LeastSquares, AnOptimumOutsideTheCubeEndsAtTheFace) {
  // At x = 1: (y - 1.1)^2 + (y - 0.6)^2 is least at y = 0.85.
  const Residual residual = [](const Point& x) {
    return point({x(0) - 1.5 + x(1) - 0.6, x(1) - 0.6});
  };
  const LeastSquaresFit fit = fit_least_squares(at_points(residual), point({0.2, 0.2}));
  EXPECT_EQ(fit.point(0), 1.0);
  EXPECT_NEAR(fit.point(1), 0.85, 5e-3);
  EXPECT_NEAR(fit.cost, 0.125, 1e-3);
}

TEST(LeastSquares, ACornerIsFoundAndAStartInOneIsLeft) {
  const Residual out = [](const Point& x) { return point({x(0) + 1.0, x(1) - 3.0, x(2) + 0.5}); };
  EXPECT_EQ(fit_least_squares(at_points(out), point({0.5, 0.5, 0.5})).point,
            point({0.0, 1.0, 0.0}));
  const LeastSquaresFit inwards = fit_least_squares(at_points(linear), point({1.0, 0.0}));
  EXPECT_NEAR((inwards.point - point({0.4, 0.7})).norm(), 0.0, 1e-3);
}

TEST(LeastSquares, FollowsRosenbrocksValley) {
  // Minimum at (1, 1) of the usual axes, which run over -1.5 to 1.5 here.
  const Residual residual = [](const Point& x) {
    const double u = 3.0 * x(0) - 1.5, v = 3.0 * x(1) - 1.5;
    return point({10.0 * (v - u * u), 1.0 - u});
  };
  LeastSquaresOptions options;
  options.most_rounds = 300;
  options.least_difference = 1e-6;
  const LeastSquaresFit fit =
      fit_least_squares(at_points(residual), point({0.1, 5.0 / 6.0}), options);
  EXPECT_LT(fit.cost, 1e-3);
  EXPECT_NEAR(fit.point(0), 2.5 / 3.0, 0.02);
}

TEST(LeastSquares, StopsWhenProgressSaysNo) {
  LeastSquaresOptions options;
  std::vector<double> costs;
  options.progress = [&](int round, double cost) {
    EXPECT_EQ(round, static_cast<int>(costs.size()) + 1);
    costs.push_back(cost);
    return round < 2;
  };
  const LeastSquaresFit fit = fit_least_squares(at_points(linear), point({0.0, 0.0}), options);
  EXPECT_EQ(fit.rounds, 2);
  ASSERT_EQ(costs.size(), 2u);
  EXPECT_LE(costs[1], costs[0]) << "never worse";
  EXPECT_EQ(fit.cost, costs[1]);
}

TEST(LeastSquares, WithoutRoundsTheStartIsTheAnswer) {
  LeastSquaresOptions options;
  options.most_rounds = 0;
  int evaluations = 0;
  const LeastSquaresFit fit =
      fit_least_squares(at_points(linear, &evaluations), point({0.5, 0.5}), options);
  EXPECT_EQ(evaluations, 1);
  EXPECT_EQ(fit.point, point({0.5, 0.5}));
  EXPECT_NEAR(fit.cost, linear(fit.point).squaredNorm(), 0.0);
}

TEST(LeastSquares, EndsWhenDifferencesGetShort) {
  // Nothing is better than the start: 0.06, 0.036, 0.0216, 0.01296, then below 0.01.
  const LeastSquaresFit fit =
      fit_least_squares(at_points([](const Point&) { return point({1.0}); }), point({0.5}));
  EXPECT_EQ(fit.rounds, 4);
  EXPECT_EQ(fit.point, point({0.5}));
}

TEST(LeastSquares, NoStepIsLongerThanAllowed) {
  LeastSquaresOptions options;
  options.most_step = 0.05;
  options.difference = 0.02;
  options.most_rounds = 1;
  const LeastSquaresFit fit = fit_least_squares(at_points(linear), point({0.0, 0.0}), options);
  EXPECT_LE(fit.point.cwiseAbs().maxCoeff(), 0.05 + 1e-15);
  EXPECT_GT(fit.point.norm(), 0.0);
}

TEST(LeastSquares, GivesTheSameBitsAgain) {
  const LeastSquaresFit one = fit_least_squares(at_points(linear), point({0.1, 0.9}));
  const LeastSquaresFit two = fit_least_squares(at_points(linear), point({0.1, 0.9}));
  EXPECT_EQ(one.point, two.point);
  EXPECT_EQ(one.cost, two.cost);
  EXPECT_EQ(one.rounds, two.rounds);
}

}  // namespace
}  // namespace coapt
