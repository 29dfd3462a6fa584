#include "farm/ask/ask.h"

#include <gtest/gtest.h>

#include <thread>

#include "farm/ask/farm.h"
#include "farm/ask/farm_closures.h"
#include "farm/work/orifice_work.h"
#include "farm/work/work_file.h"
#include "io/picture/study_csv.h"
#include "search/studies/anchor_question.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

const WorkRequest kRequest{"plans", {"{}", "ab"}};

Expected<std::string> asked_of_fake(const std::string& label, const WorkRequest& request = kRequest,
                                    AskContext context = {}) {
  context.label = label;
  const Farm fake{"postgres://farm", COAPT_SOURCE_DIR "/tests/farm/ask/fake_farm.sh"};
  return ask_farm(fake)(request, context);
}

TEST(AskFarm, SendsTheRequestAndTakesTheAnswerBothLargerThanAnyPipe) {
  const WorkRequest large{"plans", {"{}", std::string(8'000'000, 'x'), std::string(1000, '\0')}};
  const Expected<std::string> answer = asked_of_fake("echo", large);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(*answer == write_work(large));
}

TEST(AskFarm, TellsHowFarItIs) {
  std::vector<AskProgress> told;
  AskContext context;
  context.progress = [&](const AskProgress& now) { told.push_back(now); };
  EXPECT_EQ(*asked_of_fake("progress", kRequest, context), "answer");
  ASSERT_EQ(told.size(), 2u) << "the last line, too, without its end";
  EXPECT_EQ(told[0].done, 256);
  EXPECT_EQ(told[0].items, 1000);
  EXPECT_EQ(told[0].workers, 3);
  EXPECT_EQ(told[0].rate_per_s, 12.5);
  EXPECT_EQ(told[0].eta_s, 59.5);
  EXPECT_EQ(told[1].done, 1000);
}

TEST(AskFarm, GivesTheAddressInTheEnvironment) {
  EXPECT_EQ(*asked_of_fake("address"), "postgres://farm");
}

TEST(AskFarm, AnErrorIsWhatTheFarmSaysOfIt) {
  const auto holes = asked_of_fake("holes"),
             deaf = asked_of_fake("deaf", {"plans", {std::string(1'000'000, 'x')}});
  const auto killed = asked_of_fake("killed");
  ASSERT_FALSE(holes || deaf || killed);
  EXPECT_EQ(holes.errors().front().path, "/keys/7");
  EXPECT_EQ(holes.errors().front().message, "3 items were given up");
  EXPECT_NE(deaf.errors().front().message.find("does not answer"), std::string::npos);
  EXPECT_NE(killed.errors().front().message.find("137"), std::string::npos);
  const auto missing = ask_farm({"", "/nowhere/coapt-farm"})(kRequest, {});
  EXPECT_NE(missing.errors().front().message.find("/nowhere/coapt-farm"), std::string::npos);
}

TEST(AskFarm, CancelledTheChildEnds) {
  std::atomic<bool> cancelled = false;
  AskContext context;
  context.cancelled = &cancelled;
  context.progress = [&](const AskProgress&) { cancelled = true; };
  const auto answer = asked_of_fake("waits", kRequest, context);
  ASSERT_FALSE(answer);
  EXPECT_NE(answer.errors().front().message.find("interrupted"), std::string::npos);
}

TEST(AskFarm, FromManyThreadsEachGetsItsOwn) {
  std::vector<Expected<std::string>> answers(8, std::string());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < answers.size(); ++i)
      threads.emplace_back([&answers, i] {
        answers[i] = asked_of_fake("echo", {"plans", {std::string(300'000, char('a' + i))}});
      });
  }
  for (std::size_t i = 0; i < answers.size(); ++i) EXPECT_EQ(answers[i]->back(), char('a' + i));
}

std::vector<ConfigurationKey> two_keys() {
  return {key_of({}), key_of(displacement(Displaced::Both, Vec3(1.0, 0.0, 0.0)))};
}

TEST(AskHere, GivesTheBytesOfTheWork) {
  const WorkRequest request = *orifice_request(small_valve(), {}, two_keys());
  int done = 0;
  AskContext context;
  context.progress = [&](const AskProgress& now) { done = static_cast<int>(now.done); };
  const auto bytes = ask_here(1)(request, context);
  ASSERT_TRUE(bytes);
  EXPECT_EQ(*bytes, open_work(request)->compute(0, 2, 1));
  EXPECT_EQ(done, 2);
  EXPECT_FALSE(ask_here(1)(kRequest, {})) << "no such document";
  const std::atomic<bool> cancelled = true;
  context.cancelled = &cancelled;
  EXPECT_FALSE(ask_here(1)(request, context));
}

TEST(ClosuresAsked, AreTheTables) {
  OrificeTableOptions options;
  options.close_elsewhere = closures_asked_of(ask_here(1), small_valve(), {}, {});
  int planned = 0;
  options.progress = [&](int, int of) { planned = of; };
  OrificeTable there(small_valve(), options), here(small_valve(), {});
  const Configuration one = displacement(Displaced::Both, Vec3(1.0, 0.0, 0.0));
  EXPECT_EQ(there.at({&one, 1}).front().area_mm2, here.at({&one, 1}).front().area_mm2);
  EXPECT_EQ(planned, 1);
  const Farm none{"", "/nowhere/coapt-farm"};
  options.close_elsewhere = closures_asked_of(ask_farm(none), small_valve(), {}, {});
  OrificeTable nowhere(small_valve(), options);
  EXPECT_THROW(nowhere.at({&one, 1}), std::runtime_error);
}

/// Of closures of the small valve, whatever the anatomy; undisturbed it is said to be tight.
std::vector<ScannedAnatomy> scan_of_small(int at_once, const CloseElsewhere& elsewhere) {
  AnchorQuestionOptions options;
  options.anatomies = 2;
  options.at_once = at_once;
  options.protocols = {Protocol::Closed};
  options.approximation = {6.0, 17, -1.0};  // whether it leaks or not
  OrificeTableOptions table;
  table.threads = 1;
  table.known[key_of({})] = {0.0, 0.0, true};
  table.close_elsewhere = elsewhere;
  return scan_anchors(
      ParametricValve{}, [&](const Valve&) { return OrificeTable(small_valve(), table); }, options);
}

TEST(ClosuresAsked, OfSeveralAnatomiesAtOnceGiveTheSameAnswers) {
  const auto here = scan_of_small(1, {});
  const auto there = scan_of_small(2, closures_asked_of(ask_here(1), small_valve(), {}, {}));
  EXPECT_EQ(anchor_scan_csv(there), anchor_scan_csv(here));
  EXPECT_EQ(anchor_answers_csv(answer_anchor_question(there)),
            anchor_answers_csv(answer_anchor_question(here)));
  EXPECT_GT(here.front().summaries.size(), 0u);
  EXPECT_GT(there.front().closures, 17);
}

}  // namespace
}  // namespace coapt
