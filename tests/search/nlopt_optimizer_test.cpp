#include "search/nlopt_optimizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace coapt {
namespace {

BoundedProblem square_problem() {
  return {{0.0, 0.0}, {10.0, 10.0}, {5.0, 5.0}, {2.0, 2.0}, 0.01, 200};
}

TEST(Minimise, FindsTheMinimumOfAParaboloidAndStaysWithinBounds) {
  double lowest = std::numeric_limits<double>::infinity();
  std::vector<double> at;
  minimise(
      square_problem(),
      [&](const std::vector<double>& x) -> std::optional<double> {
        EXPECT_GE(std::min(x[0], x[1]), 0.0);
        EXPECT_LE(std::max(x[0], x[1]), 10.0);
        const double value = std::pow(x[0] - 7.0, 2) + 2.0 * std::pow(x[1] + 1.0, 2);
        if (value < lowest) {
          lowest = value;
          at = x;
        }
        return value;
      },
      1);
  EXPECT_NEAR(at[0], 7.0, 0.05);
  EXPECT_NEAR(at[1], 0.0, 0.05);  // its minimum lies outside
}

TEST(Minimise, WorksInOneDimension) {
  double lowest = 1e9;
  minimise(
      {{0.0}, {10.0}, {5.0}, {2.0}, 0.01, 50},
      [&](const std::vector<double>& x) -> std::optional<double> {
        lowest = std::min(lowest, std::abs(x[0] - 3.0));
        return std::pow(x[0] - 3.0, 2);
      },
      1);
  EXPECT_LT(lowest, 0.05);
}

TEST(Minimise, TakesRangesThatAreShorterThanTheFirstStep) {
  for (const double range : {0.0, 0.5, 3.0}) {
    int calls = 0;
    double lowest = 1e9;
    minimise(
        {{1.0, 0.0}, {1.0 + range, 10.0}, {1.0, 5.0}, {2.0, 2.0}, 0.01, 100},
        [&](const std::vector<double>& x) -> std::optional<double> {
          ++calls;
          const double value = std::pow(x[0] - 1.0 - range, 2) + std::pow(x[1] - 3.0, 2);
          lowest = std::min(lowest, value);
          return value;
        },
        1);
    EXPECT_GT(calls, 5) << range;
    EXPECT_LT(lowest, 0.01) << range;
  }
}

TEST(Minimise, EndsOnAPlateauWithoutAnException) {
  int calls = 0;
  minimise(
      square_problem(),
      [&](const std::vector<double>&) -> std::optional<double> {
        ++calls;
        return 1.0;
      },
      1);
  EXPECT_GT(calls, 0);
  EXPECT_LE(calls, 200);
}

TEST(Minimise, StopsWhenTold) {
  int calls = 0;
  minimise(
      square_problem(),
      [&](const std::vector<double>& x) -> std::optional<double> {
        if (++calls == 4) return std::nullopt;
        return x[0];
      },
      1);
  EXPECT_EQ(calls, 4);
}

TEST(Minimise, HandsTheCallersExceptionOn) {
  EXPECT_THROW(minimise(
                   square_problem(),
                   [](const std::vector<double>&) -> std::optional<double> {
                     throw std::runtime_error("from the caller");
                   },
                   1),
               std::runtime_error);
}

}  // namespace
}  // namespace coapt
