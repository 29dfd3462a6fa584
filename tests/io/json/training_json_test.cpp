#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "io/json/json.h"
#include "io/json/schedule_json.h"
#include "io/json/score_json.h"
#include "io/json/trials_csv.h"

namespace coapt {
namespace {

constexpr const char* kTable =
    "learner,block,trial,valve,exam,seed,difficulty,choice,answer,right,confidence,seconds,path_mm,"
    "largest_n,visited\n"
    "1,before,1,human-normal,A,7,-0.25,2,2,1,0.75,92.5,350,0.8,P1 AC A1 A2\n"
    "1,\"after, \"\"second\"\"\",2,human-normal,B,9,-0.5,TNNPPNNN,TNNPPNNT,7,0.5,120,800,1.2,\n";

TEST(TrialsCsv, OfBothExamsAreRead) {
  const auto trials = read_trials_csv(kTable);
  ASSERT_TRUE(trials) << trials.errors()[0].path << trials.errors()[0].message;
  ASSERT_EQ(trials->size(), 2u);
  EXPECT_EQ((*trials)[1].block, "after, \"second\"");
  EXPECT_EQ((*trials)[0].visited.size(), 4u);
  EXPECT_EQ((*trials)[0].confidence, 0.75);
  EXPECT_EQ((*trials)[0].difficulty, -0.25);
  EXPECT_EQ((*trials)[1].seed, 9u);
  EXPECT_EQ(right_of((*trials)[1]), 7);
  EXPECT_TRUE((*trials)[1].visited.empty());
}

TEST(TrialsCsv, EveryProblemHasItsLineColumnAndRange) {
  std::string text = kTable;
  text.replace(text.find("0.75"), 4, "1.75");
  text.replace(text.find("92.5"), 4, "fast");
  text.replace(text.find("A1 A2"), 5, "A1 A9");
  text.replace(text.find("TNNPPNNT"), 8, "TNNPP");
  const auto trials = read_trials_csv(text + "1,2,3\n");
  ASSERT_FALSE(trials);
  std::vector<std::string> paths;
  for (const Error& error : trials.errors()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/2/confidence", "/2/seconds", "/2/visited",
                                             "/3/answer", "/4"}));
  EXPECT_EQ(trials.errors()[0].message, "is \"1.75\", must be from 0 to 1");
}

TEST(TrialsCsv, ContradictionsAndColumnsAreSaid) {
  std::string text = kTable;
  text.replace(text.find(",7,0.5,"), 7, ",8,0.5,");
  EXPECT_EQ(read_trials_csv(text).errors()[0].path, "/3/right");
  text = kTable;
  text.replace(text.find("\",2,human"), 9, "\",1,human");
  EXPECT_EQ(read_trials_csv(text).errors()[0].path, "/3/trial");
  text = kTable;
  text.replace(text.find("path_mm"), 7, "name_of");
  const auto columns = read_trials_csv(text);
  ASSERT_EQ(columns.errors().size(), 2u);
  EXPECT_EQ(columns.errors()[1].message, "has no column path_mm");
  EXPECT_FALSE(read_trials_csv(""));
  EXPECT_FALSE(read_trials_csv(std::string(kTable).substr(0, 140)));
}

TEST(TrialsCsv, TextIsUtf8WithoutControlCharacters) {
  const auto read_block = [](const std::string& block) {
    std::string text = kTable;
    return read_trials_csv(text.replace(text.find("before"), 6, block));
  };
  EXPECT_TRUE(read_block("caf\u00e9 \\ /"));
  const auto broken = read_block("caf\xe9");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.errors()[0].path, "/2/block");
  EXPECT_EQ(broken.errors()[0].message, "must be UTF-8");
  const auto control = read_block("\x1b[2J");
  ASSERT_FALSE(control);
  EXPECT_EQ(control.errors()[0].path, "/2/block");
  EXPECT_EQ(control.errors()[0].message,
            "must have no control characters but tabs and ends of lines");
}

TEST(TrialsCsv, NamesAreThoseThatThePageWrote) {
  const auto read_block = [](const std::string& cell) {
    std::string text = kTable;
    const auto trials = read_trials_csv(text.replace(text.find("before"), 6, cell));
    return trials ? trials->front().block : trials.errors()[0].message;
  };
  EXPECT_EQ(read_block("'=1+1"), "=1+1");
  EXPECT_EQ(read_block("'-5"), "-5");
  EXPECT_EQ(read_block("\"'@a, b\""), "@a, b");
  EXPECT_EQ(read_block("\"two\nlines\""), "two\nlines");
  EXPECT_EQ(read_block("\"'\rback\""), "\rback");
  EXPECT_EQ(read_block("it's 5 - 3"), "it's 5 - 3");
  EXPECT_EQ(read_block("'quoted'"), "'quoted'");
}

TEST(TrialsCsv, LinesAreCountedAlsoInCells) {
  std::string text = kTable;
  text.replace(text.find("before"), 6, "\"on\nthree\nlines\"");
  text.replace(text.find(",0.5,120"), 8, ",1.5,120");
  EXPECT_EQ(read_trials_csv(text).errors()[0].path, "/5/confidence");
}

TEST(TrialsCsv, SeedsAreExactInJson) {
  const auto read_seed = [](const std::string& seed) {
    std::string text = kTable;
    return read_trials_csv(text.replace(text.find(",7,-0.25"), 8, ',' + seed + ",-0.25"));
  };
  EXPECT_EQ((*read_seed("9007199254740991"))[0].seed, 9007199254740991u);
  EXPECT_EQ(read_seed("9007199254740992").errors()[0].path, "/2/seed");
}

TEST(TrialsCsv, ABadRowDoesNotCountAsALearnersTrial) {
  const std::string text = std::string(kTable) +
                           "nobody,after,50,human-normal,A,7,0,2,2,1,1,9,9,1,\n" +
                           "1,after,3,human-normal,A,7,0,2,2,1,1,9,9,1,\n";
  const auto trials = read_trials_csv(text);
  ASSERT_EQ(trials.errors().size(), 1u);
  EXPECT_EQ(trials.errors()[0].path, "/4/learner");
}

TEST(ScoreJson, HasScoresAndWhatComesNext) {
  const auto json = score_to_json(*read_trials_csv(kTable));
  EXPECT_EQ(json["schema"], "coapt.training_score/1");
  ASSERT_EQ(json["scores"].size(), 4u);
  EXPECT_EQ(json["scores"][0]["exam"], "A");
  EXPECT_TRUE(json["scores"][0]["block"].is_null());
  EXPECT_EQ(json["scores"][0]["right"], 1);
  ASSERT_EQ(json["next"].size(), 2u);
  EXPECT_EQ(json["next"][1]["repeat"][0]["seed"], 9);
  EXPECT_TRUE(json["cases"].empty());
}

TEST(ScoreJson, TenLearnersCalibrateTheirCases) {
  std::vector<TrainingTrial> trials;
  for (int learner = 1; learner <= 10; ++learner)
    for (int number = 1; number <= 2; ++number) {
      TrainingTrial trial;
      trial.learner = learner;
      trial.trial = number;
      trial.seed = static_cast<std::uint64_t>(number);
      trial.judged = ChosenValve{number == 1 || learner < 4 ? 1 : 2, 1};
      trials.push_back(trial);
    }
  const auto json = score_to_json(trials);
  ASSERT_EQ(json["cases"].size(), 2u);
  EXPECT_LT(json["cases"][0]["difficulty"], json["cases"][1]["difficulty"]);
}

TEST(ScoreJson, CalibrationTakesTheFirstTenThousandAnswers) {
  std::vector<TrainingTrial> trials;
  for (int learner = 1; learner <= 2; ++learner)
    for (int number = 1; number <= 5000; ++number) {
      TrainingTrial trial;
      trial.learner = learner;
      trial.trial = number;
      trial.seed = static_cast<std::uint64_t>(number);
      trial.judged = ChosenValve{};
      trials.push_back(trial);
    }
  ASSERT_EQ(trials.size(), kMostCalibrationAnswers);
  for (int learner = 3; learner <= 10; ++learner) {
    trials.push_back(trials.front());
    trials.back().learner = learner;
  }
  EXPECT_TRUE(score_to_json(trials)["cases"].empty());
}

TEST(Schedules, OfTheThesisAreReadAndLaidOut) {
  const auto read = [](const std::string& name) {
    std::ifstream file(COAPT_SOURCE_DIR "/examples/training/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return read_schedule(text.str());
  };
  const auto trials = [](const Json& exam) {
    std::size_t count = 0;
    for (const auto& block : exam["blocks"])
      if (block.contains("trials")) count += block["trials"].size();
    return count;
  };
  for (const auto& [name, count] : {std::pair("study-1.json", 10u), std::pair("study-2.json", 15u),
                                    std::pair("study-3.json", 6u)}) {
    const auto schedule = read(name);
    ASSERT_TRUE(schedule) << name << schedule.errors()[0].message;
    EXPECT_EQ(trials(exam_to_json(*schedule, 3, 1)), count) << name;
  }
}

TEST(Schedules, WithProblemsAreRefused) {
  const auto bad = read_schedule(
      R"({"schema": "coapt.training_schedule/1", "name": "s", "title": "", "blocks": [
        {"name": "a", "exam": "C", "cases": 0}, {"name": "b", "exam": "A", "cases": 2, "repeats": 3},
        {"name": "c", "instruction": ""}]})");
  ASSERT_FALSE(bad);
  std::vector<std::string> paths;
  for (const Error& error : bad.errors()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"/blocks/0/exam", "/blocks/0/cases",
                                             "/blocks/1/repeats", "/blocks/2/instruction"}));
}

TEST(Schedules, AWrongTypeIsOneProblem) {
  const auto bad = read_schedule(
      R"({"schema": "coapt.training_schedule/1", "name": 5, "title": "", "blocks": [
        {"name": "a", "instruction": 5}]})");
  ASSERT_EQ(bad.errors().size(), 2u);
  EXPECT_EQ(bad.errors()[0].path, "/name");
  EXPECT_EQ(bad.errors()[1].path, "/blocks/0/instruction");
  EXPECT_EQ(read_schedule(
                R"({"schema": "coapt.training_schedule/1", "name": "s", "title": "", "blocks": 5})")
                .errors()
                .size(),
            1u);
}

}  // namespace
}  // namespace coapt
