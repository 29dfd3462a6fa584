#include "farm/work/orifice_work.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "farm/work/closure_options_json.h"
#include "io/json/subject.h"
#include "io/json/valve_json.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

/// On the lattice and off it, not to be made (its annulus turns inside out), and one of these twice.
std::vector<Configuration> asked_configurations() {
  std::vector<Configuration> all;
  for (const Vec3& by : {Vec3(0, 0, 0), Vec3(3, 0, 3), Vec3(1.25, 0.5, 4.7), Vec3(0, 1e-6, 0)})
    all.push_back(displacement(Displaced::Anterolateral, by));
  all.push_back(displacement(Displaced::Both, Vec3(2.0, 1.0, 0.0), 2));
  all.emplace_back().change.ap_dilation_percent = 12.3456789;
  all.emplace_back().change.ap_dilation_percent = -100.0;
  all.push_back(all[2]);
  return all;
}

std::vector<ConfigurationKey> keys_of(const std::vector<Configuration>& configurations) {
  std::vector<ConfigurationKey> keys;
  for (const Configuration& configuration : configurations) keys.push_back(key_of(configuration));
  return keys;
}

void expect_same(const OrificeSample& a, const OrificeSample& b) {
  const auto bits = [](double value) {
    return std::isnan(value) ? 0 : std::bit_cast<std::uint64_t>(value);
  };
  EXPECT_EQ(bits(a.area_mm2), bits(b.area_mm2));
  EXPECT_EQ(bits(a.sd_mm2), bits(b.sd_mm2));
  EXPECT_EQ(a.trusted, b.trusted);
}

TEST(OrificeWork, GivesTheTablesBitsInAnyPartsOnAnyThreads) {
  const Valve valve = small_valve();
  const std::vector<Configuration> asked = asked_configurations();
  OrificeTable table(valve, {});
  const std::vector<OrificeSample> expected = table.at(asked);
  EXPECT_TRUE(std::isnan(expected[6].area_mm2));

  const auto request = orifice_request(valve, {}, keys_of(asked));
  ASSERT_TRUE(request);
  for (const int at_once : {8, 3}) {
    const Expected<Work> work = open_work(*request);
    ASSERT_TRUE(work);
    ASSERT_EQ(work->items, 8);
    std::string bytes;
    for (int first = 0; first < 8; first += at_once)
      bytes += work->compute(first, std::min(at_once, 8 - first), 1 + first % 2);
    const auto samples = orifice_answers(bytes, asked.size());
    ASSERT_TRUE(samples);
    for (std::size_t i = 0; i < asked.size(); ++i) expect_same((*samples)[i], expected[i]);
    EXPECT_EQ(work->compute(2, 2, 1), bytes.substr(2 * 17, 2 * 17)) << "computed again";
  }
}

TEST(OrificeWork, ATaskIsASixteenthOfTheRunFrom64To256ItemsOfASmallValve) {
  for (const auto& [items, task_items] :
       {std::pair(8, 64), {576, 64}, {1'600, 100}, {8'000, 256}}) {
    const std::vector<ConfigurationKey> keys(items);
    const Expected<Work> work = open_work(*orifice_request(small_valve(), {}, keys));
    ASSERT_TRUE(work);
    EXPECT_EQ(work->task_items, task_items) << items << " items";
  }
}

TEST(OrificeWork, OfTheThesissMethodHasItsMeanAndSd) {
  ClosureOptions closure;
  closure.method = Method::Thesis;
  closure.membrane = Membrane::Springs;
  closure.samples = 3;
  closure.max_steps = 2000;
  const std::vector<Configuration> asked = {asked_configurations()[2]};
  OrificeTableOptions options;
  options.closure = closure;
  OrificeTable table(small_valve(), options);
  const auto request = orifice_request(small_valve(), closure, keys_of(asked));
  ASSERT_TRUE(request);
  const Expected<Work> work = open_work(*request);
  ASSERT_TRUE(work);
  expect_same(orifice_answers(work->compute(0, 1, 1), 1)->front(), table.at(asked).front());
}

TEST(OrificeWork, ATableThatClosesElsewhereKnowsKeepsAndCountsTheSame) {
  const std::vector<Configuration> asked = asked_configurations();
  OrificeTable here(small_valve(), {});
  const std::vector<OrificeSample> expected = here.at(asked);

  int calls = 0, kept = 0;
  OrificeTableOptions options;
  options.known[key_of(asked[0])] = expected[0];
  options.keep = [&](const ConfigurationKey&, const OrificeSample&) { ++kept; };
  options.close_elsewhere = [&](const std::vector<ConfigurationKey>& keys, const auto&) {
    ++calls;
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    const Expected<Work> work = open_work(*orifice_request(small_valve(), {}, keys));
    return *orifice_answers(work->compute(0, static_cast<int>(keys.size()), 1), keys.size());
  };
  OrificeTable there(small_valve(), options);
  for (int again = 0; again < 2; ++again) {
    const std::vector<OrificeSample> samples = there.at(asked);
    for (std::size_t i = 0; i < asked.size(); ++i) expect_same(samples[i], expected[i]);
  }
  EXPECT_EQ(calls, 1) << "all of a batch at once, nothing twice";
  EXPECT_EQ(kept, 6) << "of seven, one was known";
  EXPECT_EQ(there.closures(), 6);
  EXPECT_EQ(there.known(), 1);
  EXPECT_EQ(there.configurations(), here.configurations());
  EXPECT_EQ(there.untrusted(), here.untrusted());
  const StartCheck a = here.check_starts(), b = there.check_starts();
  EXPECT_EQ(a.closures, b.closures);
  EXPECT_EQ(a.leak_difference_max_mm2, b.leak_difference_max_mm2);
}

TEST(OrificeWork, WorksOfOneValveShareWhatTheyCloseAndGiveTheSameBits) {
  const auto keys = keys_of(asked_configurations());
  ClosureOptions other;
  other.speed = 0.9;
  const auto open = make_work_opener();
  OrificeTables tables;
  for (const ClosureOptions& closure : {ClosureOptions{}, other}) {
    const auto first = orifice_request(small_valve(), closure, {keys[1], keys[2]});
    const auto second = orifice_request(small_valve(), closure, {keys[3], keys[2], keys[4]});
    EXPECT_EQ(open(*first)->compute(0, 2, 1), open_work(*first)->compute(0, 2, 1));
    EXPECT_EQ(open(*second)->compute(0, 3, 1), open_work(*second)->compute(0, 3, 1));
    ASSERT_TRUE(open_orifice_work(*first, &tables)->compute(0, 2, 1) != "");
    const auto shared = tables.of(subject_of(small_valve(), closure));
    const int closures = shared->table->closures();
    ASSERT_TRUE(open_orifice_work(*second, &tables)->compute(1, 1, 1) != "");
    EXPECT_EQ(shared->table->closures(), closures) << "the second one is known";
    const Expected<Work> stopped = open_orifice_work(*second, &tables);
    *stopped->stop = true;
    EXPECT_THROW(stopped->compute(0, 3, 1), WorkStopped);
    EXPECT_EQ(shared->table, nullptr) << "nothing is kept that may be unfinished";
  }
}

TEST(OrificeWork, AStoppedComputationHasNoAnswerAndTheNextOneHasTheRightOne) {
  const auto request = orifice_request(small_valve(), {}, keys_of(asked_configurations()));
  const Expected<Work> work = open_work(*request), other = open_work(*request);
  *work->stop = true;
  EXPECT_THROW(work->compute(0, 8, 1), WorkStopped);
  *work->stop = false;
  EXPECT_EQ(work->compute(0, 8, 1), other->compute(0, 8, 1));
}

TEST(OrificeWork, AValveComesBackBitForBit) {
  for (const std::string name : {"human-functional-mr", "porcine-thesis"}) {
    Valve valve = small_preset(name);
    valve.rest_mm(1, 1) += 1e-9 / 3.0;
    valve.pressure_kpa = std::nextafter(valve.pressure_kpa, 0.0);
    for (double& coordinate : valve.annulus_mm.reshaped())
      if (coordinate == 0.0) coordinate = -0.0;
    const Expected<Valve> back = read_valve(write_valve(valve));
    ASSERT_TRUE(back) << back.errors().front().message;
    EXPECT_EQ(subject_of(*back, {}), subject_of(valve, {}));
  }
}

TEST(OrificeWork, OptionsOfTheClosureComeBackBitForBit) {
  ClosureOptions options;
  options.method = Method::Thesis;
  options.membrane = Membrane::Springs;
  options.residual_tolerance = std::nextafter(0.1, 1.0);
  options.way_tolerance_mm = 1.0 / 3.0;
  options.max_steps = 12345;
  options.contact_pressure_mpa = 0.0;
  options.speed = 0.7;
  options.damping_per_ms = 0.1;
  options.samples = 5;
  options.edge_contact = true;
  options.self_contact = SelfContact::NotAnterior;
  const Json json = *closure_options_json(options);
  ProblemList problems;
  const ClosureOptions back = read_closure_options({json, problems});
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(subject_of(small_valve(), back), subject_of(small_valve(), options));
}

TEST(OrificeWork, WhatCannotBeSentIsRefused) {
  ClosureOptions with_motion, with_budget, no_number;
  with_motion.motion = true;
  with_budget.budget.vertex_steps = 1e6;
  no_number.speed = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [options, path] :
       {std::pair{with_motion, "/motion"}, {with_budget, "/budget"}, {no_number, "/speed"}}) {
    const auto request = orifice_request(small_valve(), options, {});
    ASSERT_FALSE(request);
    EXPECT_EQ(request.errors().front().path, path);
  }
}

TEST(OrificeWork, EveryProblemOfARequestHasItsPlace) {
  WorkRequest request = *orifice_request(small_valve(), {}, {ConfigurationKey{}});
  request.parts[0] = R"({"valve": 2, "closure": {"method": "slow"},
                         "keys": [[1, 2, 3], [0, 0, 0, 0, 0, 0, 0, 0, 1.5]]})";
  const Expected<Work> work = open_work(request);
  ASSERT_FALSE(work);
  std::vector<std::string> paths;
  for (const Error& error : work.errors()) paths.push_back(error.path);
  for (const char* path : {"/valve", "/closure/method", "/closure/speed", "/keys/0", "/keys/1/8"})
    EXPECT_NE(std::find(paths.begin(), paths.end(), path), paths.end()) << path;
  EXPECT_FALSE(orifice_answers("12345", 1));
}

}  // namespace
}  // namespace coapt
