#include "io/json/answers_json.h"

#include <cmath>

#include "tests/io/json/found.h"

namespace coapt {
namespace {

using enum ErrorCode;

/// With its leak, all other amounts 0.
Json plan_of(double leak_mm2) {
  Json terms;
  for (const CostTermRow& row : cost_term_rows()) terms[row.name] = 0.0;
  terms["leak"] = leak_mm2;
  return {{"description", {"a ring"}}, {"cost_terms", terms}, {"leak_mm2", {{"mean", leak_mm2}}}};
}

Json two_plans() {
  return {{"schema", "coapt.plans/2"}, {"plans", {plan_of(1.0), plan_of(2.5)}}, {"closures", 7}};
}

std::vector<PlanCase> cases() {
  PlanCase read = *read_plan_case(two_plans().dump());
  read.name = "ring";
  return {read};
}

constexpr const char* kSheet = R"({"schema": "coapt.answers/1", "rater": "A", "answers": [
  {"case": "ring", "first": 2, "second": 1, "answer": "unable"}]})";

TEST(AnswersJson, PlansAreReadFromWhatASearchPrints) {
  const PlanCase read = cases()[0];
  ASSERT_EQ(read.plans.size(), 2u);
  EXPECT_EQ(read.plans[1].terms[CostTerm::Leak], 2.5);
  EXPECT_EQ(read.plans[1].leak_mm2, 2.5);
  EXPECT_EQ(read.plans[0].description.at(0), "a ring");
  EXPECT_TRUE(std::isnan(read.plans[0].opening_area_mm2));
  EXPECT_EQ(read.sd_share, 1.0);
}

TEST(AnswersJson, ProblemsOfPlansAreListedWithTheirPlace) {
  Json plans = two_plans();
  plans["plans"][0]["cost_terms"].erase("gap");
  plans["plans"][1]["cost_terms"]["step"] = "two";
  plans["plans"][1].erase("description");
  const auto read = read_plan_case(plans.dump());
  ASSERT_FALSE(read);
  EXPECT_EQ(problems_of(read), (Found{{MissingField, "/plans/0/cost_terms/gap"},
                                      {WrongType, "/plans/1/cost_terms/step"},
                                      {MissingField, "/plans/1/description"}}));
}

TEST(AnswersJson, AnswersComeBackAsTheyWereWritten) {
  const auto sheet = read_answers(kSheet, cases());
  ASSERT_TRUE(sheet);
  EXPECT_EQ(sheet->rater, "A");
  EXPECT_EQ(sheet->answers.at(0).pair, (PlanPair{0, 1, 0}));
  EXPECT_EQ(sheet->answers.at(0).answer, Preference::Unable);
  EXPECT_EQ(to_json(*sheet, cases()), Json::parse(kSheet));
}

TEST(AnswersJson, ProblemsOfAnswersAreListedWithTheirPlace) {
  const auto read = read_answers(R"({"schema": "coapt.answers/2", "answers": [
      {"case": "rong", "first": 1, "second": 2, "answer": "first"},
      {"case": "ring", "first": 1, "second": 3, "answer": "maybe"},
      {"case": "ring", "first": 1, "second": 1, "answer": "first", "when": 3}]})",
                                 cases());
  ASSERT_FALSE(read);
  EXPECT_EQ(problems_of(read), (Found{{Unsupported, "/schema"},
                                      {MissingField, "/rater"},
                                      {BadReference, "/answers/0/case"},
                                      {OutOfRange, "/answers/1/second"},
                                      {BadReference, "/answers/1/answer"},
                                      {UnknownField, "/answers/2/when"},
                                      {OutOfRange, "/answers/2"}}));
  EXPECT_NE(read.errors()[3].message.find("from 1 to 2"), std::string::npos);
}

TEST(AnswersJson, AQuestionHidesFiguresOnRequest) {
  const Question question{{0, 1, 0}, true, 0.5};
  const auto shown = to_json(question, cases(), false), hidden = to_json(question, cases(), true);
  EXPECT_EQ(shown["plans"][0]["rank"], 2);
  EXPECT_EQ(shown["plans"][0]["leak_mm2"], 2.5);
  EXPECT_TRUE(shown["plans"][0]["durability_mm"].is_null());
  EXPECT_FALSE(hidden["plans"][0].contains("leak_mm2"));
  EXPECT_EQ(hidden["first"], 2);
}

}  // namespace
}  // namespace coapt
