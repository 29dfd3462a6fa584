#include "server/endpoints/job_results.h"

#include "io/picture/report.h"
#include "tests/io/plans_scene.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

/// Ranks 1 to `count`, each of one plan that does nothing.
std::string result_of(int count) {
  Json plans = Json::array();
  for (int rank = 1; rank <= count; ++rank)
    plans.push_back(
        {{"rank", rank}, {"plan", {{"schema", "coapt.plan/1"}, {"steps", Json::array()}}}});
  return Json{{"schema", "coapt.plans/2"}, {"plans", plans}}.dump();
}

class JobResultsTest : public ServiceTest {
 protected:
  void ended_search(int plans) {
    queued_job("j");
    finish_next({.summary = R"({"plans": []})",
                 .result = result_of(plans),
                 .files = {{"report.html", kHtmlType, "all"}, {"plan-1.html", kHtmlType, "one"}}});
  }
  std::vector<int> ranks(const std::string& query) {
    std::vector<int> found;
    const Json page = json_of(get("/v1/jobs/j/plans" + query));
    for (const auto& plan : page["plans"]) found.push_back(plan["rank"]);
    return found;
  }
};

const std::vector<std::string> kResults = {
    "/result",         "/plans",  "/plans/1", "/plans/1/mesh",      "/plans/1/picture",
    "/plans/1/report", "/report", "/files",   "/files/report.html", "/evaluations.csv"};

TEST_F(JobResultsTest, ThereAreNoneBeforeTheJobHasEndedNorOfOneThatFailed) {
  queued_job("j");
  for (const std::string& path : kResults) EXPECT_EQ(get("/v1/jobs/j" + path).status, 409) << path;
  finish_next({.state = JobState::Failed});
  for (const std::string& path : kResults) EXPECT_EQ(get("/v1/jobs/j" + path).status, 409) << path;
}

TEST_F(JobResultsTest, OfNoJobThereAreNone) {
  for (const std::string& path : kResults) EXPECT_EQ(get("/v1/jobs/x" + path).status, 404) << path;
}

TEST_F(JobResultsTest, TheResultIsWhatTheJobLeft) {
  ended_search(2);
  const Answer answer = get("/v1/jobs/j/result");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(bytes_of(answer), result_of(2));
}

TEST_F(JobResultsTest, AJobCancelledBeforeItHadAnythingHasNoResultAndNoPlans) {
  queued_job("j");
  ask("POST", "/v1/jobs/j:cancel");
  EXPECT_EQ(get("/v1/jobs/j/result").status, 404);
  EXPECT_TRUE(ranks("").empty());
  EXPECT_EQ(get("/v1/jobs/j/plans/1").status, 404);
  EXPECT_EQ(get("/v1/jobs/j/report").status, 404);
}

TEST_F(JobResultsTest, PlansArePagedByRank) {
  ended_search(5);
  EXPECT_EQ(ranks(""), (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(ranks("?page_size=2"), (std::vector<int>{1, 2}));
  const std::string next = json_of(get("/v1/jobs/j/plans?page_size=2"))["next_page_token"];
  EXPECT_EQ(ranks("?page_size=2&page_token=" + next), (std::vector<int>{3, 4}));
  const Json middle = json_of(get("/v1/jobs/j/plans?page_size=2&page_token=" + next));
  const std::string last = middle["next_page_token"];
  EXPECT_EQ(ranks("?page_size=2&page_token=" + last), std::vector<int>{5});
  EXPECT_EQ(json_of(get("/v1/jobs/j/plans?page_token=" + last))["next_page_token"], nullptr);
  EXPECT_EQ(refusal(get("/v1/jobs/j/plans?page_size=101&page_token=0&x=1")),
            (Refused{422, {"?x", "?page_size", "?page_token"}}));
}

TEST_F(JobResultsTest, ThePlansTriedAreATable) {
  queued_job("j");
  finish_next({.files = {{"evaluations.csv", kCsvType, "number\n1\n"}}});
  const Answer answer = get("/v1/jobs/j/evaluations.csv");
  EXPECT_EQ(bytes_of(answer), "number\n1\n");
  EXPECT_EQ(content_type(answer), kCsvType);
}

TEST_F(JobResultsTest, APlanIsNamedByItsRank) {
  ended_search(2);
  EXPECT_EQ(json_of(get("/v1/jobs/j/plans/2"))["rank"], 2);
  for (const char* what : {"", "/mesh", "/picture", "/report"})
    EXPECT_EQ(get("/v1/jobs/j/plans/3" + std::string(what)).status, 404) << what;
}

TEST_F(JobResultsTest, APlanComesAsMeshPictureAndReport) {
  ended_search(1);
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/plans/1/mesh")).starts_with("ply"));
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/plans/1/mesh?format=obj")).starts_with("# coapt"));
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/plans/1/picture")).starts_with("\x89PNG"));
  EXPECT_EQ(bytes_of(get("/v1/jobs/j/plans/1/report")), "one");
  EXPECT_EQ(refusal(get("/v1/jobs/j/plans/1/mesh?format=exe&x=1")),
            (Refused{422, {"?x", "?format"}}));
  const Compute::Turn other(compute());
  EXPECT_EQ(get("/v1/jobs/j/plans/1/mesh").status, 503);
  EXPECT_EQ(get("/v1/jobs/j/plans/1/picture").status, 503);
}

TEST_F(JobResultsTest, FilesAreListedAndGot) {
  ended_search(1);
  EXPECT_EQ(bytes_of(get("/v1/jobs/j/report")), "all");
  const Json files = json_of(get("/v1/jobs/j/files"))["files"];
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0], (Json{{"name", "report.html"},
                            {"type", kHtmlType},
                            {"bytes", 3},
                            {"path", "/v1/jobs/j/files/report.html"}}));
  EXPECT_EQ(bytes_of(get("/v1/jobs/j/files/plan-1.html")), "one");
  EXPECT_EQ(get("/v1/jobs/j/files/other").status, 404);
}

/// The scene's words, on closures of the small valve.
SearchResult search_of_small_valve() {
  SearchResult result = search_result();
  result.closed_before = std::make_shared<const ClosedValve>(close_and_measure(small_valve()));
  for (RankedPlan& plan : result.plans) plan.closed = result.closed_before;
  return result;
}

TEST_F(JobResultsTest, ReportsOfASearchAreDrawnWhenTheyAreAskedForToTheSameBytes) {
  SearchResult result = search_of_small_valve();
  result.plans.resize(2);
  const PlanPictures pictures = pictures_of(result);
  queued_job("j");
  finish_next({.summary = R"({"plans": []})",
               .result = result_of(2),
               .files = {{"evaluations.csv", kCsvType, "number\n"}},
               .material = search_material(result, search_request())});
  const auto report = [&](int about) {
    return plan_report_html(
        {pictures.before, pictures.after, result, search_request(), about, today()});
  };
  const std::string all = report(0), second = report(2);
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/report")) == all);
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/plans/2/report")) == second);
  EXPECT_TRUE(bytes_of(get("/v1/jobs/j/files/plan-2.html")) == second) << "again";
  EXPECT_EQ(content_type(get("/v1/jobs/j/report")), kHtmlType);
  for (const char* none :
       {"plan-3.html", "plan-0.html", "plan-01.html", "plan-.html", "plan-1.htm"})
    EXPECT_EQ(get("/v1/jobs/j/files/" + std::string(none)).status, 404) << none;

  const Json files = json_of(get("/v1/jobs/j/files"))["files"];
  ASSERT_EQ(files.size(), 4u);
  const auto size_of = [&](const char* name) {
    return bytes_of(get("/v1/jobs/j/files/" + std::string(name))).size();
  };
  const std::vector<std::pair<std::string, std::size_t>> sizes = {
      {"report.html", all.size()},
      {"plan-1.html", size_of("plan-1.html")},
      {"plan-2.html", second.size()},
      {"evaluations.csv", size_of("evaluations.csv")}};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(files[i]["name"], sizes[i].first);
    EXPECT_EQ(files[i]["bytes"], sizes[i].second);
    EXPECT_EQ(files[i]["path"], "/v1/jobs/j/files/" + sizes[i].first);
  }
}

TEST_F(JobResultsTest, ReportsThatCannotBeDrawnAnyMoreAreSaidSo) {
  queued_job("j");
  finish_next({.result = result_of(1), .material = "no gzip"});
  for (const char* path : {"/report", "/plans/1/report", "/files"})
    EXPECT_EQ(get("/v1/jobs/j" + std::string(path)).status, 500) << path;
  EXPECT_EQ(get("/v1/jobs/j/files/other").status, 404);
}

TEST_F(JobResultsTest, AStudyHasItsPageForAReportAndNoPlans) {
  queued_job("j", "study");
  finish_next({.summary = R"({"findings": 0})",
               .result = R"({"findings": []})",
               .files = {{"index.html", kHtmlType, "page"}}});
  EXPECT_EQ(bytes_of(get("/v1/jobs/j/report")), "page");
  EXPECT_TRUE(ranks("").empty());
  EXPECT_EQ(get("/v1/jobs/j/plans/1").status, 404);
  EXPECT_EQ(json_of(get("/v1/jobs/j"))["findings"], 0);
}

}  // namespace
}  // namespace coapt
