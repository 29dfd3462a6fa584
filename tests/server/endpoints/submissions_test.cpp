#include "server/endpoints/submissions.h"

#include <algorithm>
#include <thread>

#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class SubmissionsTest : public ServiceTest {
 protected:
  Answer search(const Json& search, const Fields& headers = {}) {
    return post("/v1/plans", {{"valve", small_document()}, {"search", search}}, headers);
  }
  Answer study(const Json& study) {
    return post("/v1/studies", {{"valve", small_document()}, {"study", study}});
  }
  std::size_t jobs() { return json_of(get("/v1/jobs"))["jobs"].size(); }
};

Json parsed(const char* text) { return Json::parse(text); }

TEST_F(SubmissionsTest, ASearchBecomesAJobThatWaits) {
  const Answer answer = post("/v1/plans", {{"valve", small_document()}});
  EXPECT_EQ(answer.status, 202);
  const Json job = json_of(answer);
  EXPECT_EQ(job["kind"], "plans");
  EXPECT_EQ(job["state"], "QUEUED");
  EXPECT_EQ(job["queue_position"], 0);
  EXPECT_EQ(job["progress"]["closures"], 0);
  EXPECT_EQ(header_of(answer, "Location"), "/v1/jobs/" + job["id"].get<std::string>());
  EXPECT_EQ(json_of(get("/v1/valves/" + job["valve"].get<std::string>())), small_document());
  EXPECT_EQ(board().take()->job.id, job["id"]);
}

TEST_F(SubmissionsTest, AStudyBecomesAJobThatWaits) {
  const Answer answer = study({{"name", "annulus"}});
  EXPECT_EQ(answer.status, 202);
  EXPECT_EQ(json_of(answer)["kind"], "study");
  EXPECT_EQ(board().take()->job.request, R"({"name":"annulus"})");
}

TEST_F(SubmissionsTest, TheSurfaceOfAFitIsReadInATurnBeforeItsJobIsTaken) {
  const auto fit = [&](const Json& surface) {
    return post("/v1/fits", {{"valve", small_document()}, {"surface", surface}});
  };
  const Json points = {{"mesh", {{"vertices_mm", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}}};
  const Json file = {{"file", {{"name", "points.csv"}, {"text", "0,0,0\n1,0,0\n0,1,0\n"}}}};
  const Json damaged = {{"file", {{"name", "points.csv"}, {"text", "0,0\n"}}}};
  EXPECT_EQ(fit(damaged).status, 422);
  EXPECT_TRUE(refusal(fit(damaged)).paths.front().starts_with("/surface/file"));
  {
    const Compute::Turn other(compute());
    EXPECT_EQ(fit(file).status, 503);
    EXPECT_EQ(fit(damaged).status, 503);
    EXPECT_EQ(jobs(), 0u);
    EXPECT_EQ(fit(points).status, 202) << "there is no file to be read";
  }
  EXPECT_EQ(fit(file).status, 202);
  limits_.vertices = 200;  // 4,000 of a surface
  std::string many;
  for (int i = 0; i < 4001; ++i) many += std::to_string(i) + ",0,0\n";
  EXPECT_EQ(refusal(fit({{"file", {{"name", "points.csv"}, {"text", many}}}})),
            (Refused{422, {"/surface"}}));
}

TEST_F(SubmissionsTest, ProblemsOfASearchPointIntoTheRequest) {
  const std::vector<std::pair<const char*, std::vector<std::string>>> cases = {
      {R"({"rules": {"forbidden": ["annuloplasty", 1], "most_neochordae": 5, "x": 1},
           "weights": {"leak": -1, "love": 1, "gap": "x"}})",
       {"/search/rules/forbidden/1", "/search/rules/most_neochordae", "/search/rules/x",
        "/search/weights/gap", "/search/weights/leak", "/search/weights/love"}},
      {R"({"rules": {"fixed": {"steps": [{"step": "fly"}]}}})",
       {"/search/rules/fixed/steps/0/step"}},
      // What only the valve can tell.
      {R"({"rules": {"forbidden": ["annuloplasty", "rings"], "fixed": {"steps": [
           {"step": "annuloplasty", "shape": "own", "sizes_below": 2},
           {"step": "chordal_excision", "chorda": "none"}]}}})",
       {"/search/rules/fixed/steps/0", "/search/rules/fixed/steps/1/chorda",
        "/search/rules/forbidden/1"}},
      {R"({"evaluations": 0})", {"/search/evaluations"}},
      {R"({"evaluations": 200000})", {"/search/evaluations"}},
      {R"({"rules": [], "weights": null})", {"/search/rules", "/search/weights"}}};
  for (const auto& [text, paths] : cases) {
    Refused refused = refusal(search(parsed(text)));
    std::sort(refused.paths.begin(), refused.paths.end());
    EXPECT_EQ(refused, (Refused{422, paths})) << text;
  }
  EXPECT_EQ(jobs(), 0u);
}

TEST_F(SubmissionsTest, ProblemsOfARequestAreListed) {
  EXPECT_EQ(refusal(post("/v1/plans", {{"search", Json::object()}})), (Refused{422, {"/valve"}}));
  EXPECT_EQ(refusal(post("/v1/plans", {{"valve", small_document()}, {"x", 1}})),
            (Refused{422, {"/x"}}));
  EXPECT_EQ(refusal(study({{"name", "x"}})), (Refused{422, {"/study/name"}}));
  EXPECT_EQ(refusal(post("/v1/studies", {{"valve", small_document()}})),
            (Refused{422, {"/study"}}));
  for (const char* path : {"/v1/plans", "/v1/studies"}) {
    for (const std::string& text : {std::string("{"), std::string(), std::string(100'000, '['),
                                    std::string("{\"valve\": NaN}")})
      EXPECT_EQ(refusal(ask("POST", path, text)).status, 400) << path << ' ' << text.substr(0, 20);
    const Compute::Turn other(parsing());
    EXPECT_EQ(post(path, {{"valve", small_document()}}).status, 503) << path;
  }
  EXPECT_EQ(jobs(), 0u);
}

TEST_F(SubmissionsTest, AnIdempotencyKeyMakesOneJob) {
  const Fields key = {{"idempotency-key", "once"}};
  const Answer first = search({{"seed", 1}}, key), again = search({{"seed", 1}}, key);
  EXPECT_EQ(again.status, 202);
  EXPECT_EQ(json_of(again)["id"], json_of(first)["id"]);
  EXPECT_EQ(search({{"seed", 2}}, key).status, 422);
  EXPECT_EQ(jobs(), 1u);
  for (const std::string& wrong :
       {std::string(256, 'k'), std::string("two words"), std::string("ü")})
    EXPECT_EQ(search({{"seed", 1}}, {{"idempotency-key", wrong}}).status, 422) << wrong;
}

TEST_F(SubmissionsTest, AFullQueueIs429AndAServerThatStops503) {
  for (int i = 0; i < kQueue; ++i) EXPECT_EQ(search({{"seed", i}}).status, 202);
  EXPECT_EQ(search({{"seed", 1}}).status, 429);
  EXPECT_EQ(jobs(), static_cast<std::size_t>(kQueue));
  board().stop();
  EXPECT_EQ(search({{"seed", 1}}).status, 503);
}

TEST_F(SubmissionsTest, AJobThatEndsWithinThePreferredWaitIsAnsweredWithItsEnd) {
  std::thread runner([this] { finish_next({.summary = R"({"stop": "exhausted", "plans": []})"}); });
  const Answer answer = search({{"seed", 1}}, {{"prefer", "respond-async, wait=60"}});
  runner.join();
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(json_of(answer)["state"], "SUCCEEDED");
  EXPECT_EQ(json_of(answer)["stop"], "exhausted");
  EXPECT_EQ(header_of(answer, "Preference-Applied"), "wait=60");
}

TEST_F(SubmissionsTest, AWaitIsCutToWhatTheServiceGives) {
  limits_.wait_seconds = 1;
  const Answer answer = search({{"seed", 1}}, {{"prefer", "wait=60"}});
  EXPECT_EQ(answer.status, 202);
  EXPECT_EQ(header_of(answer, "Preference-Applied"), "wait=1");
  EXPECT_EQ(header_of(search({{"seed", 2}}), "Preference-Applied"), "");
}

}  // namespace
}  // namespace coapt
