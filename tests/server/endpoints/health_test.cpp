#include "server/endpoints/health.h"

#include "server/answers.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class HealthTest : public ServiceTest {};

TEST_F(HealthTest, ItIsAliveAndReadyWithWhatItDoes) {
  EXPECT_EQ(json_of(get("/healthz/live"))["status"], "live");
  queued_job("a");
  queued_job("b");
  board().take();
  const Answer ready = get("/healthz/ready");
  EXPECT_EQ(ready.status, 200);
  EXPECT_EQ(json_of(ready)["status"], "ready");
  EXPECT_EQ(json_of(ready)["jobs_queued"], 1);
  EXPECT_EQ(json_of(ready)["jobs_running"], 1);
}

TEST_F(HealthTest, AServerThatStopsIsAliveButNotReady) {
  board().stop();
  EXPECT_EQ(get("/healthz/live").status, 200);
  EXPECT_EQ(get("/healthz/ready").status, 503);
}

TEST_F(HealthTest, MetricsCountJobsAndConnections) {
  queued_job("a");
  const std::string text = bytes_of(get("/metrics"));
  for (const char* line : {"coapt_jobs{state=\"queued\"} 1\n", "coapt_jobs{state=\"running\"} 0\n",
                           "coapt_http_connections 7\n", "coapt_http_requests_in_progress 5\n",
                           "coapt_http_streams 3\n"})
    EXPECT_NE(text.find(line), text.npos) << line << text;
}

TEST_F(HealthTest, VersionAndDocumentAreOfThisService) {
  const auto version = json_of(get("/version"));
  EXPECT_EQ(version["name"], "coapt-server");
  EXPECT_FALSE(version["not_modelled"].empty());
  EXPECT_EQ(json_of(get("/openapi.json"))["info"]["version"], version["version"]);
}

TEST_F(HealthTest, WithoutAFarmThereIsNothingToTellOfIt) {
  EXPECT_EQ(json_of(get("/version"))["farm"], false);
  EXPECT_EQ(get("/v1/farm").status, 404);
}

TEST_F(HealthTest, WithoutAPageThereIsNone) {
  for (const char* path : {"/", "/favicon.svg", "/assets/x.js"}) EXPECT_EQ(get(path).status, 404);
}

TEST(StoreProblem, IsBusyFullOrBroken) {
  EXPECT_EQ(store_problem({Error{ErrorCode::Busy, "", "locked"}}).status, 503);
  EXPECT_EQ(store_problem({Error{ErrorCode::NoSpace, "", "full"}}).status, 507);
  EXPECT_EQ(store_problem({Error{ErrorCode::InputOutput, "", "broken"}}).status, 500);
}

}  // namespace
}  // namespace coapt
