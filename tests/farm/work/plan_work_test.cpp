#include "farm/work/plan_work.h"

#include <gtest/gtest.h>

#include "farm/work/work_parts.h"
#include "io/json/json.h"
#include "io/json/parse_json.h"
#include "io/json/plan_document.h"
#include "io/json/plans_json.h"
#include "io/json/subject.h"
#include "io/picture/report_material.h"
#include "search/plans/plan_search.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

SearchOptions quick_search() {
  SearchOptions options;
  options.evaluations = 2;
  options.plans = 1;
  options.region_points = 1;
  options.evidence = false;
  options.openings = false;
  options.fine_levels = 0;
  options.model_draws = 0;
  return options;
}

TEST(PlanWork, IsTheSearchThatAnybodyElseWouldMake) {
  const Valve& valve = small_preset("human-functional-mr");
  SearchOptions options = quick_search();
  options.threads = 2;
  const auto request = plan_request({valve, valve}, options);
  ASSERT_TRUE(request);
  const Expected<Work> work = open_work(*request);
  ASSERT_TRUE(work);
  EXPECT_EQ(work->items, 2);
  EXPECT_EQ(work->task_items, 1);
  const std::string bytes = work->compute(0, 1, 1);
  EXPECT_EQ(work->compute(1, 1, 2), bytes) << "threads change nothing";

  const auto answers = plan_answers(bytes + bytes);
  ASSERT_TRUE(answers);
  ASSERT_EQ(answers->size(), 2u);
  const PlanAnswer& answer = answers->back();
  SearchContext context;
  options.threads = 0;
  const auto result = search_plans(valve, options, context);
  Json here = to_json(*result, {options, subject_of(valve, {}), ""});
  here["seconds"] = nullptr;
  EXPECT_EQ(answer.plans, here.dump());
  EXPECT_TRUE(read_plans(answer.plans));
  const auto report = report_page(answer.material, 0, valve);
  ASSERT_TRUE(report);
  EXPECT_NE(report->find(", including ranking"), std::string::npos) << "no seconds";
  EXPECT_NE(answer.tried.find('\n'), std::string::npos);
  EXPECT_FALSE(plan_answers(std::string_view(bytes).substr(0, bytes.size() - 1)));
  EXPECT_EQ(work->objection(0, 1, bytes), "");
  EXPECT_EQ(work->objection(0, 2, bytes), "1 answers, where 2 are asked for");
  EXPECT_NE(work->objection(0, 1, std::string_view(bytes).substr(1)), "");
  const auto other = open_work(*plan_request({small_preset("human-p2-prolapse")}, options));
  EXPECT_EQ(other->objection(0, 1, bytes), "the plans are of another valve");
  options.seed += 1;
  const auto search = open_work(*plan_request({valve}, options));
  EXPECT_EQ(search->objection(0, 1, bytes), "the plans are of another search");
}

std::string packed(const PlanAnswer& answer) {
  std::string bytes;
  for (const std::string* part : {&answer.plans, &answer.material, &answer.tried})
    pack_text(bytes, *part);
  return bytes;
}

TEST(PlanWork, DisputesAnAnswerThatProgramsCouldNotReadOrShow) {
  const auto request = plan_request(
      {small_preset("human-functional-mr"), small_preset("human-p2-prolapse")}, quick_search());
  const Expected<Work> work = open_work(*request);
  ASSERT_TRUE(work);
  const std::string bytes = work->compute(0, 1, 1);
  const PlanAnswer answer = plan_answers(bytes)->front();
  const Json plans = *parse_json(answer.plans);
  ASSERT_FALSE(plans["plans"].empty());

  const auto objection = [&](const auto& change) {
    Json changed = plans;
    change(changed);
    return work->objection(0, 1, packed({changed.dump(), answer.material, answer.tried}));
  };
  EXPECT_EQ(objection([](Json&) {}), "");
  EXPECT_EQ(objection([](Json& json) { json.erase("any_competent"); }),
            "the plans have another form at /any_competent");
  EXPECT_EQ(objection([](Json& json) { json["plans"] = "none"; }),
            "the plans have another form at /plans");
  EXPECT_EQ(objection([](Json& json) { json["plans"][0]["warnings"] = 7; }),
            "the plans have another form at /plans/0/warnings");
  EXPECT_EQ(objection([](Json& json) { json["plans"][0]["leak_mm2"].erase("nominal"); }),
            "the plans have another form at /plans/0/leak_mm2/nominal");
  EXPECT_EQ(objection([](Json& json) { json["plans"].push_back(json["plans"][0]); }),
            "the reports are of another number of plans");
  EXPECT_EQ(objection([](Json& json) { json["plans"][0]["plan"]["steps"] = Json::array(); }),
            "the closed shape of plan 1 is of another plan");

  const auto material = [&](const std::string& changed) {
    return work->objection(0, 1, packed({answer.plans, changed, answer.tried}));
  };
  EXPECT_NE(material(""), "");
  EXPECT_NE(material(answer.material.substr(0, answer.material.size() - 1)), "");
  std::string scripted = answer.material;
  const std::string_view policy = "default-src 'none'";
  for (std::size_t at; (at = scripted.find(policy)) != scripted.npos;)
    scripted.replace(at, policy.size(), "default-src 'self'");
  EXPECT_EQ(material(scripted), "a report is no page of coapt");
  const PlanAnswer other = plan_answers(work->compute(1, 1, 1))->front();
  EXPECT_NE(material(other.material), "") << "of another valve";
}

TEST(PlanWork, DoubtsShapesThatAreNotAtRestAndLeaksThatAreNotTheirs) {
  const Valve& valve = small_preset("human-functional-mr");
  SearchOptions options = quick_search();
  options.threads = 0;
  const Expected<Work> work = open_work(*plan_request({valve}, options));
  ASSERT_TRUE(work);
  SearchContext context;
  const auto result = search_plans(valve, options, context);
  ASSERT_TRUE(result);
  const SearchRequest request{options, subject_of(valve, {}), ""};
  const auto doubt = [&](const auto& change) {
    ReportMaterial material = report_material(*result, request);
    Json plans = to_json(*result, request);
    plans["seconds"] = nullptr;
    change(material, plans);
    const std::string bytes = packed({plans.dump(), write_report_material(material), ""});
    EXPECT_EQ(work->objection(0, 1, bytes), "");
    return work->doubt(0, 1, bytes);
  };
  EXPECT_FALSE(doubt([](ReportMaterial&, Json&) {}));
  const auto away = [](ClosedValve& shape) { shape.closure.closed_mm.col(2).array() += 3.0; };
  EXPECT_TRUE(doubt([&](ReportMaterial& material, Json&) { away(material.before); }));
  EXPECT_TRUE(doubt([&](ReportMaterial& material, Json&) { away(material.after.front()); }));
  EXPECT_TRUE(doubt([](ReportMaterial&, Json& plans) {
    Json& area = plans["plans"][0]["leak"]["area_mm2"];
    area = area.get<double>() + 1.0;
  }));
  EXPECT_TRUE(doubt([](ReportMaterial&, Json& plans) { plans["before"]["status"] = "diverged"; }));
  EXPECT_TRUE(doubt([](ReportMaterial&, Json& plans) { plans["before"] = nullptr; }));
  EXPECT_TRUE(doubt([](ReportMaterial&, Json& plans) { plans["plans"][0]["leak"] = nullptr; }));
}

TEST(PlanWork, AStoppedSearchHasNoAnswer) {
  const auto request = plan_request({small_preset("human-functional-mr")}, quick_search());
  const Expected<Work> work = open_work(*request);
  *work->stop = true;
  EXPECT_THROW(work->compute(0, 1, 1), WorkStopped);
}

TEST(PlanWork, RefusesWhatWouldDependOnTheMachineOrLeavesNothingToTry) {
  const Valve& valve = small_preset("human-functional-mr");
  SearchOptions timed = quick_search(), other = quick_search(), forbidden = quick_search();
  timed.seconds = 60.0;
  EXPECT_EQ(plan_request({valve}, timed).errors().front().path, "/seconds");
  other.closure.speed = 0.5;
  EXPECT_EQ(plan_request({valve}, other).errors().front().path, "/closure");
  forbidden.rules.forbidden = {"magic"};
  const Expected<Work> work = open_work(*plan_request({valve}, forbidden));
  ASSERT_FALSE(work);
  EXPECT_EQ(work.errors().front().path, "/search/rules/forbidden/0");
}

}  // namespace
}  // namespace coapt
