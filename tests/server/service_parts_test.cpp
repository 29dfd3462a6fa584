// The small parts of the service, with answers known beforehand.
#include <gtest/gtest.h>

#include "server/access.h"
#include "server/answers.h"
#include "server/content_id.h"
#include "server/jobs/job_json.h"
#include "server/jobs/study_request.h"
#include "server/metrics.h"
#include "server/query.h"

namespace coapt {
namespace {

TEST(StoreProblem, NamesFilesWithoutTheirFolders) {
  EXPECT_EQ(without_folders("/var/lib/coapt/jobs.sqlite: cannot be written: disk is full"),
            "jobs.sqlite: cannot be written: disk is full");
  EXPECT_EQ(without_folders("database farm at /run/postgresql, user anna: it is away"),
            "database farm at postgresql, user anna: it is away");
  const Answer answer = store_problem({{ErrorCode::NoSpace, "", "/a/b.db: no room"}});
  EXPECT_EQ(answer.status, 507);
  EXPECT_EQ(content_bytes(answer).find("/a/"), std::string::npos);
}

TEST(ContentId, IsTheSha256OfNothingAndOfAbc) {
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(content_id("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(content_id(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(RandomId, Has32DigitsAndIsNeverTheSame) {
  EXPECT_EQ(random_id().size(), 32u);
  EXPECT_NE(random_id(), random_id());
}

TEST(TimeJson, IsUtcWithMillisecondsAndNullForNone) {
  EXPECT_EQ(time_json(0), nullptr);
  EXPECT_EQ(time_json(1'000'000'000'007), "2001-09-09T01:46:40.007Z");
}

TEST(Query, IntegersAreReadWholeAndInRange) {
  Request request;
  request.query = {{"a", "7"}, {"b", "7x"}, {"c", "0"}, {"d", ""}, {"e", "99999999999999999999"}};
  ProblemList problems;
  EXPECT_EQ(integer_in(request, "a", {1, 9}, 5, problems), 7);
  EXPECT_EQ(integer_in(request, "missing", {1, 9}, 5, problems), 5);
  EXPECT_TRUE(problems.empty());
  for (const char* name : {"b", "c", "d", "e"}) integer_in(request, name, {1, 9}, 5, problems);
  check_query(request, {"a", "b", "c", "d"}, problems);
  std::vector<std::string> paths;
  for (const Error& error : problems.listed()) paths.push_back(error.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"?b", "?c", "?d", "?e", "?e"}));
}

TEST(Access, LoopbackIsWhatOnlyThisMachineReaches) {
  for (const char* host : {"localhost", "127.0.0.1", "127.9.8.7", "::1"})
    EXPECT_TRUE(is_loopback(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "10.0.0.1", "", "localhost.example", "127.0.0.1 "})
    EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Metrics, CountRequestsByRouteAndStatusAndTheirTimes) {
  Metrics metrics;
  metrics.observe({"GET", "/v1/jobs/{id}", 200, 0.004});
  metrics.observe({"GET", "/v1/jobs/{id}", 200, 0.3});
  const std::string text = metrics.text({{"coapt_jobs{state=\"queued\"}", 3}});
  const std::string who = "{method=\"GET\",route=\"/v1/jobs/{id}\"";
  for (const std::string& line : {"coapt_http_requests_total" + who + ",status=\"200\"} 2\n",
                                  "coapt_http_request_seconds_bucket" + who + ",le=\"0.002\"} 0\n",
                                  "coapt_http_request_seconds_bucket" + who + ",le=\"0.005\"} 1\n",
                                  "coapt_http_request_seconds_bucket" + who + ",le=\"+Inf\"} 2\n",
                                  "coapt_http_request_seconds_count" + who + "} 2\n",
                                  std::string("coapt_jobs{state=\"queued\"} 3\n")})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

StudyRequest study_of(const char* text, ProblemList& problems) {
  const Json json = Json::parse(text);
  return read_study({json, problems});
}

TEST(StudyRequest, ComesBackAsItWasWritten) {
  ProblemList problems;
  for (const char* text :
       {R"({"name": "annulus"})",
        R"({"name": "approximation", "protocols": ["closed"], "displacement_step_mm": 6.0,)"
        R"( "region_points": 17, "scan_sites": 3})"}) {
    const StudyRequest request = study_of(text, problems);
    EXPECT_EQ(to_json(request), Json::parse(text));
  }
  EXPECT_TRUE(problems.empty());
}

TEST(StudyRequest, ListsEveryProblem) {
  ProblemList problems;
  study_of(R"({"name": "thesis", "protocols": [], "displacement_step_mm": 4, "region_points": 1,
               "scan_sites": -1, "x": 0})",
           problems);
  EXPECT_EQ(problems.listed().size(), 5u);
  ProblemList others;
  study_of(R"({"name": "annulus", "protocols": ["closed"]})", others);
  study_of(R"({"name": "dance"})", others);
  study_of("[]", others);
  EXPECT_EQ(others.listed().size(), 3u);
  ProblemList of_step;
  study_of(R"({"name": "thesis", "displacement_step_mm": "3"})", of_step);
  ASSERT_EQ(of_step.listed().size(), 1u);
  EXPECT_EQ(of_step.listed()[0].path, "/displacement_step_mm");
}

}  // namespace
}  // namespace coapt
