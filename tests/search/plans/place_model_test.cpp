#include "search/plans/place_model.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt {
namespace {

Eigen::VectorXd at(double x, double y) { return Eigen::Vector2d(x, y); }

double bowl(const Eigen::VectorXd& place) { return place.squaredNorm() - 3.0 * place[0]; }

PlaceModel model_of_bowl() {
  std::vector<Eigen::VectorXd> places;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) places.push_back(at(i, j));
  Eigen::VectorXd values(25);
  for (Eigen::Index i = 0; i < 25; ++i) values[i] = bowl(places[i]);
  return {places, values, 3.0};
}

TEST(PlaceModel, ExpectsASmoothFunctionBetweenWhatItWasTold) {
  const PlaceModel model = model_of_bowl();
  for (const auto& place : {at(0.5, 0.5), at(-1.5, 0.5), at(1.0, 1.0)}) {
    EXPECT_NEAR(model.at(place).mean, bowl(place), 0.1);
    EXPECT_LT(model.at(place).sd, 0.5);
  }
}

TEST(PlaceModel, FarAwayItExpectsTheMeanAndSaysThatItDoesNotKnow) {
  const PlaceModel model = model_of_bowl();
  EXPECT_NEAR(model.at(at(60.0, 60.0)).mean, 4.0, 1e-6);
  EXPECT_GT(model.at(at(60.0, 60.0)).sd, 2.0);
  EXPECT_GT(model.at(at(3.5, 3.5)).sd, model.at(at(1.5, 1.5)).sd);
}

TEST(PlaceModel, OfOneValueOrOfEqualOnesExpectsIt) {
  EXPECT_DOUBLE_EQ(PlaceModel({at(0, 0)}, Eigen::VectorXd::Constant(1, 3.0), 1.0).at(at(1, 1)).mean,
                   3.0);
  const PlaceModel equal({at(0, 0), at(1, 0), at(0, 1)}, Eigen::VectorXd::Constant(3, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(equal.at(at(0.3, 0.3)).mean, 3.0);
  EXPECT_LT(equal.at(at(0.3, 0.3)).sd, 0.2);
  EXPECT_GT(equal.at(at(9.0, 9.0)).sd, 0.4) << "three equal values are no certainty";
}

}  // namespace
}  // namespace coapt
