#include "search/studies/orifice_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

std::vector<Configuration> apical(const std::vector<double>& by_mm) {
  std::vector<Configuration> configurations;
  for (const double by : by_mm)
    configurations.push_back(displacement(Displaced::Anterolateral, Vec3(0.0, 0.0, by)));
  return configurations;
}

/// Counts what it is told of.
struct Kept {
  std::map<ConfigurationKey, int> times;
  OrificeTableOptions options(int threads = 1) {
    OrificeTableOptions options;
    options.threads = threads;
    options.closure.membrane = Membrane::Springs;  // an open cone of them leaks
    options.keep = [this](const ConfigurationKey& key, const OrificeSample&) { ++times[key]; };
    return options;
  }
};

TEST(OrificeTable, ClosesEachConfigurationOnce) {
  Kept kept;
  OrificeTable table = small_table(kept.options());
  const std::vector<OrificeSample> first = table.at(apical({0.0, 1.0, 0.0, 1.0, 2.0}));
  EXPECT_EQ(table.closures(), 3 + 1) << "1 and 2 mm start from 0 and 3 mm";
  ASSERT_EQ(first.size(), 5u);
  EXPECT_EQ(first[0].area_mm2, first[2].area_mm2);
  EXPECT_EQ(first[1].area_mm2, first[3].area_mm2);
  EXPECT_NE(first[0].area_mm2, first[4].area_mm2);
  const std::vector<OrificeSample> again = table.at(apical({2.0, 3.0}));
  EXPECT_EQ(table.closures(), 4);
  EXPECT_EQ(again[0].area_mm2, first[4].area_mm2);
  EXPECT_EQ(kept.times.size(), 4u);
  for (const auto& [key, times] : kept.times) EXPECT_EQ(times, 1);
}

TEST(OrificeTable, WhatIsKnownIsNotClosedAgain) {
  Kept kept;
  OrificeTableOptions options = kept.options();
  const std::vector<Configuration> two = apical({0.0, 1.0});
  options.known[key_of(two[0])] = {12.5, 0.25, true};
  OrificeTable table = small_table(options);
  EXPECT_EQ(table.configurations(), 0) << "known, not asked";
  const std::vector<OrificeSample> samples = table.at(two);
  EXPECT_EQ(samples[0].area_mm2, 12.5);
  EXPECT_EQ(samples[0].sd_mm2, 0.25);
  EXPECT_EQ(table.closures(), 1 + 2) << "what 1 mm starts from is closed again";
  EXPECT_EQ(table.configurations(), 2);
  EXPECT_EQ(kept.times.count(key_of(two[0])), 0u);
  EXPECT_EQ(kept.times.count(key_of(two[1])), 1u);
}

TEST(OrificeTable, FindsWhatItKnowsAndNothingElse) {
  OrificeTable table = small_table({});
  const std::vector<Configuration> two = apical({0.0, 1.0});
  EXPECT_EQ(table.find(two[0]), nullptr);
  const OrificeSample sample = table.at({two.data(), 1}).front();
  ASSERT_NE(table.find(two[0]), nullptr);
  EXPECT_EQ(table.find(two[0])->area_mm2, sample.area_mm2);
  EXPECT_EQ(table.find(two[1]), nullptr);
}

TEST(OrificeTable, ConfigurationsWithinAMillionthAreOneAndTheRoundedOneIsClosed) {
  EXPECT_EQ(key_of(apical({1.0000004})[0]), key_of(apical({1.0})[0]));
  EXPECT_EQ(key_of(apical({-1e-7})[0]), key_of(apical({0.0})[0])) << "-0 is 0";
  EXPECT_NE(key_of(apical({1.000001})[0]), key_of(apical({1.0})[0]));
  OrificeTable exact = small_table({}), near = small_table({});
  EXPECT_EQ(exact.at(apical({1.0}))[0].area_mm2, near.at(apical({1.0000004}))[0].area_mm2);
  EXPECT_EQ(near.at(apical({1.0}))[0].area_mm2, exact.at(apical({1.0}))[0].area_mm2);
  EXPECT_EQ(near.closures(), 1 + 2);
}

TEST(OrificeTable, KeysTellAllFieldsApart) {
  Configuration changed;
  changed.change.ap_dilation_percent = 1.0;
  changed.change.annular_height_percent = 2.0;
  changed.change.anterolateral_mm = Vec3(3.0, 4.0, 5.0);
  changed.change.posteromedial_mm = Vec3(6.0, 7.0, 8.0);
  changed.ring_sizes_below = 9;
  EXPECT_EQ(key_of(changed), (ConfigurationKey{1'000'000, 2'000'000, 3'000'000, 4'000'000,
                                               5'000'000, 6'000'000, 7'000'000, 8'000'000, 9}));
}

TEST(OrificeTable, ThreadsDoNotChangeABit) {
  const std::vector<Configuration> wanted = apical({0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 40.0});
  std::vector<std::vector<OrificeSample>> runs;
  for (const int threads : {1, 2}) {
    OrificeTableOptions options;
    options.threads = threads;
    options.closure.membrane = Membrane::Springs;
    runs.push_back(OrificeTable(small_valve(), options).at(wanted));
  }
  for (std::size_t i = 0; i + 1 < wanted.size(); ++i) {
    EXPECT_EQ(runs[0][i].area_mm2, runs[1][i].area_mm2);
    EXPECT_EQ(runs[0][i].sd_mm2, runs[1][i].sd_mm2);
    EXPECT_EQ(runs[0][i].trusted, runs[1][i].trusted);
    EXPECT_GT(runs[0][i].area_mm2, 0.0) << "an open cone leaks";
  }
}

TEST(OrificeTable, AnImpossibleConfigurationHasNoOrificeAndIsNotTrusted) {
  Kept kept;
  OrificeTable table = small_table(kept.options());
  const std::vector<OrificeSample> samples = table.at(apical({0.0, 42.0}));
  EXPECT_TRUE(std::isfinite(samples[0].area_mm2));
  EXPECT_TRUE(samples[0].trusted);
  EXPECT_TRUE(std::isnan(samples[1].area_mm2));
  EXPECT_FALSE(samples[1].trusted);
  EXPECT_EQ(table.untrusted(), 1);
  EXPECT_EQ(kept.times.size(), 2u) << "not tried again by a later run";
}

TEST(OrificeTable, CountsWhatWasAskedOnceAndNotWhatElseWasKnown) {
  const std::vector<Configuration> wanted = apical({1.0, 2.0, 3.0, 4.0});
  OrificeTableOptions options;
  for (const Configuration& known : wanted) options.known[key_of(known)] = {3.0, 0.0, false};
  options.known[key_of(wanted[1])].trusted = true;
  OrificeTable table = small_table(options);
  EXPECT_EQ(table.configurations(), 0);
  EXPECT_EQ(table.untrusted(), 0);
  for (int again = 0; again < 2; ++again) {
    table.at({wanted.data(), 2});
    EXPECT_EQ(table.configurations(), 2);
    EXPECT_EQ(table.untrusted(), 1);
  }
  for (int again = 0; again < 2; ++again) {
    ASSERT_NE(table.find(wanted[2]), nullptr);
    EXPECT_EQ(table.configurations(), 3) << "found is asked";
    EXPECT_EQ(table.untrusted(), 2);
  }
  EXPECT_EQ(table.find(apical({5.0})[0]), nullptr);
  EXPECT_EQ(table.configurations(), 3);
  EXPECT_EQ(table.closures(), 0);
}

TEST(OrificeTable, TellsOfProgressUpToTheBatchesEnd) {
  std::vector<std::pair<int, int>> told;
  OrificeTableOptions options;
  options.threads = 2;
  options.progress = [&](int done, int planned) { told.emplace_back(done, planned); };
  OrificeTable table = small_table(options);
  table.at(apical({0.0, 1.0, 1.0}));
  table.at(apical({1.0}));
  EXPECT_EQ(told, (std::vector<std::pair<int, int>>{{1, 3}, {2, 3}, {3, 3}}));
}

TEST(OrificeTable, WhatKeepThrowsComesOutAndEndsTheBatch) {
  for (const int threads : {1, 2}) {
    int told = 0;
    OrificeTableOptions options;
    options.threads = threads;
    options.keep = [&](const ConfigurationKey&, const OrificeSample&) {
      if (++told == 3) throw std::runtime_error("the disk is full");
    };
    OrificeTable table = small_table(options);
    std::vector<double> many;
    for (int i = 0; i < 60; ++i) many.push_back(0.05 * i);
    EXPECT_THROW(table.at(apical(many)), std::runtime_error);
    EXPECT_GE(told, 3);
    EXPECT_LE(told, 2 + threads) << "those in hand, and no other";
  }
}

TEST(OrificeTable, AfterAFailureNothingIsTakenForClosedThatIsNot) {
  bool full = true;
  OrificeTableOptions options;
  options.threads = 1;
  options.closure.membrane = Membrane::Springs;
  options.keep = [&](const ConfigurationKey&, const OrificeSample&) {
    if (full) throw std::runtime_error("the disk is full");
  };
  OrificeTable table = small_table(options);
  const std::vector<Configuration> two = apical({0.0, 1.0});
  EXPECT_THROW(table.at(two), std::runtime_error);
  EXPECT_EQ(table.find(two[1]), nullptr);
  full = false;
  EXPECT_GT(table.at(two)[1].area_mm2, 0.0);
}

}  // namespace
}  // namespace coapt
