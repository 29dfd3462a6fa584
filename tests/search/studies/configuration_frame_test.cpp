#include "search/studies/configuration_frame.h"

#include <gtest/gtest.h>

#include <random>

#include "search/studies/orifice_table.h"
#include "tests/scenes/small_preset.h"
#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

/// Both tips, one after the other.
Eigen::VectorXd tips(const Configuration& configuration) {
  Eigen::VectorXd all(6);
  all << configuration.change.anterolateral_mm, configuration.change.posteromedial_mm;
  return all;
}

bool on_lattice(const Configuration& configuration) {
  const Eigen::VectorXd steps = tips(configuration) / kFrameStep_mm;
  return (steps - steps.array().round().matrix()).norm() < 1e-9;
}

TEST(ConfigurationFrame, IsNoneOnTheLattice) {
  EXPECT_TRUE(predicted_from(displacement(Displaced::Both, Vec3::Zero())).empty());
  EXPECT_TRUE(predicted_from(displacement(Displaced::Both, Vec3(3.0, 6.0, -3.0))).empty());
  EXPECT_TRUE(predicted_from(displacement(Displaced::Posteromedial, Vec3(0.0, 6.0, 3.0))).empty());
}

TEST(ConfigurationFrame, IsTheConfigurationsMeanOfLatticePoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mm(-6.0, 6.0);
  for (int i = 0; i < 200; ++i) {
    const Displaced displaced = kDisplaced[i % 3];
    Configuration wanted = displacement(displaced, Vec3(mm(random), mm(random), mm(random)), 2);
    wanted.change.ap_dilation_percent = 10.0;
    if (i % 2 == 1) wanted.change.posteromedial_mm = Vec3(mm(random), mm(random), mm(random));
    const std::vector<ConfigurationShare> shares = predicted_from(wanted);
    ASSERT_LE(shares.size(), 7u);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(6);
    double sum = 0.0;
    for (const auto& [corner, share] : shares) {
      EXPECT_TRUE(on_lattice(corner));
      EXPECT_LT((tips(corner) - tips(wanted)).cwiseAbs().maxCoeff(), kFrameStep_mm);
      EXPECT_EQ(corner.ring_sizes_below, 2);
      EXPECT_EQ(corner.change.ap_dilation_percent, 10.0);
      EXPECT_GT(share, 0.0);
      mean += share * tips(corner);
      sum += share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
    EXPECT_LT((mean - tips(wanted)).norm(), 1e-4);
  }
}

TEST(ConfigurationFrame, OfMusclesDisplacedAlikeDisplacesThemAlike) {
  for (const auto& [corner, share] : predicted_from(displacement(Displaced::Both, Vec3(1, 2, 4))))
    EXPECT_EQ(corner.change.anterolateral_mm, corner.change.posteromedial_mm);
  // 1/3, 2/3 and 1/3 of a cell: along the second axis first.
  const auto shares = predicted_from(displacement(Displaced::Anterolateral, Vec3(1, 2, 4)));
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_EQ(tips(shares[0].configuration).head<3>(), Vec3(0, 0, 3));
  EXPECT_EQ(tips(shares[1].configuration).head<3>(), Vec3(0, 3, 3));
  EXPECT_EQ(tips(shares[2].configuration).head<3>(), Vec3(3, 3, 6));
  for (const auto& share : shares) EXPECT_NEAR(share.share, 1.0 / 3.0, 1e-12);
}

TEST(ConfigurationFrame, IsClosedWhereNobodyHasAskedForItAndTheAnswerDoesNotDependOnThat) {
  const Configuration between = displacement(Displaced::Anterolateral, Vec3(0.0, 0.0, 1.0));
  OrificeTable alone = small_table({});
  const OrificeSample sample = alone.at({&between, 1}).front();
  EXPECT_EQ(alone.closures(), 3) << "0 and 3 mm, too";
  EXPECT_EQ(alone.configurations(), 1);
  OrificeTable together = small_table({});
  std::vector<Configuration> all;
  for (const double by : {3.0, 2.0, 0.0, 1.0})
    all.push_back(displacement(Displaced::Anterolateral, Vec3(0.0, 0.0, by)));
  EXPECT_EQ(together.at(all).back().area_mm2, sample.area_mm2);
  EXPECT_EQ(together.closures(), 4);
}

TEST(ConfigurationFrame, IsClosedAgainWhereOnlyItsOrificeIsKnown) {
  const Configuration between = displacement(Displaced::Anterolateral, Vec3(0.0, 0.0, 1.0));
  OrificeTable fresh = small_table({});
  const OrificeSample sample = fresh.at({&between, 1}).front();
  OrificeTableOptions options;
  int kept = 0;
  options.keep = [&](const ConfigurationKey&, const OrificeSample&) { ++kept; };
  for (const double by : {0.0, 3.0})
    options.known[key_of(displacement(Displaced::Anterolateral, Vec3(0.0, 0.0, by)))] = {7.0, 0.0,
                                                                                         true};
  OrificeTable resumed = small_table(options);
  EXPECT_EQ(resumed.at({&between, 1}).front().area_mm2, sample.area_mm2);
  EXPECT_EQ(kept, 1) << "known ones stay as they are";
  EXPECT_EQ(resumed.known(), 0) << "nobody asked for them";
}

// Of a valve whose scallops are all held: others may end in two ways (docs/experiments.md).
TEST(ConfigurationFrame, AColdStartEndsWhereThePredictedOneDoes) {
  OrificeTableOptions options;
  options.closure.samples = 1;
  OrificeTable table(shared_preset("human-functional-mr"), options);
  EXPECT_EQ(table.check_starts().closures, 0);
  std::vector<Configuration> wanted;
  for (int by = 0; by <= 6; ++by)
    wanted.push_back(displacement(Displaced::Both, Vec3(0.0, 0.0, by)));
  table.at(wanted);
  const StartCheck check = table.check_starts();
  EXPECT_EQ(check.closures, 4) << "1, 2, 4 and 5 mm";
  EXPECT_EQ(check.elsewhere, 0);
  EXPECT_LT(check.leak_difference_max_mm2, 0.5);
  EXPECT_EQ(table.closures(), 7) << "nothing counts them";
}

}  // namespace
}  // namespace coapt
