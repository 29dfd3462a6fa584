#include "server/jobs/import_job.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/server/endpoints/import_scene.h"

namespace coapt {
namespace {

class ImportJobTest : public ServiceTest {};

/// A job that waits, run as the server does.
JobEnd run_import(const ServiceLimits& limits, JobStore& store, JobBoard& board) {
  const std::shared_ptr<RunningJob> job = board.take();
  const std::optional<JobEnd> end = ImportJob{board, store, {limits}}(*job);
  EXPECT_TRUE(end);
  board.finish(job, end);
  return end.value_or(JobEnd{});
}

TEST_F(ImportJobTest, AsAJobAPictureStandsBesideTheValve) {
  const Json request = cone_request();
  const Answer answer = post("/v1/imports", request, {{"idempotency-key", "one"}});
  ASSERT_EQ(answer.status, 202) << json_of(answer);
  const std::string job = json_of(answer)["id"];
  EXPECT_EQ(json_of(answer)["kind"], "import");
  EXPECT_EQ(json_of(post("/v1/imports", request, {{"idempotency-key", "one"}}))["id"], job);
  Json other = request;
  other["name"] = "another";
  EXPECT_EQ(post("/v1/imports", other, {{"idempotency-key", "one"}}).status, 422);
  ASSERT_TRUE(*store().input(job));
  run_import(limits_, store(), board());
  EXPECT_FALSE(*store().input(job)) << "files are kept no longer than they are needed";

  const Json ended = json_of(get("/v1/jobs/" + job));
  EXPECT_EQ(ended["state"], "SUCCEEDED");
  EXPECT_EQ(ended["made"], ended["valve"]);
  const Json result = json_of(get(ended["links"]["result"]));
  EXPECT_EQ(result["schema"], "coapt.import/2");
  EXPECT_EQ(result["valve"], ended["made"]);
  EXPECT_EQ(decision_about(result["decisions"], "units")["value"], "mm");
  EXPECT_TRUE(result["fit"].is_null());
  EXPECT_TRUE(bytes_of(get(ended["links"]["picture"])).starts_with("\x89PNG"));
  const std::string document = bytes_of(get("/v1/jobs/" + job + "/files/valve.json"));
  EXPECT_EQ(Json::parse(document),
            json_of(get("/v1/valves/" + result["valve"].get<std::string>())));
  EXPECT_EQ(get("/v1/jobs/" + job + "/report").status, 404);
  EXPECT_EQ(remove("/v1/jobs/" + job).status, 204);
}

TEST_F(ImportJobTest, AFitChangesTheValveThatWasImported) {
  const Answer answer = post("/v1/imports", fit_request());
  ASSERT_EQ(answer.status, 202) << json_of(answer);
  const std::string job = json_of(answer)["id"];
  const JobEnd end = run_import(limits_, store(), board());
  EXPECT_EQ(end.state, JobState::Succeeded) << end.summary;
  const Json result = json_of(get("/v1/jobs/" + job + "/result"));
  EXPECT_EQ(result["imported"], json_of(answer)["valve"]);
  EXPECT_NE(result["valve"], result["imported"]);
  EXPECT_EQ(result["fit"]["schema"], "coapt.fit/1");
  EXPECT_LT(result["fit"]["rms_mm"], result["fit"]["rms_before_mm"]);
  EXPECT_EQ(result["decisions"].back()["subject"], "fit");
  const Json valve = json_of(get("/v1/valves/" + result["valve"].get<std::string>()));
  EXPECT_TRUE(valve["provenance"].back().get<std::string>().starts_with("fitted to the closed"));
  EXPECT_EQ(valve.dump().find("Smith"), std::string::npos);
  EXPECT_EQ(result.dump().find("Smith"), std::string::npos);
  EXPECT_GT(json_of(get("/v1/jobs/" + job))["progress"]["rms_mm"], 0.0);
}

TEST_F(ImportJobTest, AFitGoesOnWhereItWasKept) {
  const std::string whole = json_of(post("/v1/imports", fit_request()))["id"];
  run_import(limits_, store(), board());
  const std::string again = json_of(post("/v1/imports", fit_request()))["id"];
  // A server that stops after the first round.
  const std::shared_ptr<RunningJob> job = board().take();
  std::thread stopper([&] {
    while (!store().state(again)->has_value()) std::this_thread::yield();
    board().stop();
  });
  const ImportJob work{board(), store(), {limits_}};
  std::optional<JobEnd> end;
  try {
    end = work(*job);
  } catch (const std::runtime_error&) {
  }
  stopper.join();
  JobBoard next(store(), kQueue);
  if (!end) {
    board().finish(job, std::nullopt);
    ASSERT_TRUE(**store().state(again) != "");
    ASSERT_TRUE(next.resume().empty());
    run_import(limits_, store(), next);
  } else {
    board().finish(job, end);
  }
  const auto result_of = [&](const std::string& id) {
    Json result = json_of(get("/v1/jobs/" + id + "/result"));
    return result;
  };
  EXPECT_EQ(result_of(again), result_of(whole));
}

TEST_F(ImportJobTest, AJobEndsWhileItsValveIsMade) {
  post("/v1/imports", unseen_request());
  const std::shared_ptr<RunningJob> job = board().take();
  job->cancelled = job->cancel_asked = true;
  EXPECT_THROW((ImportJob{board(), store(), {limits_}})(*job), std::runtime_error);
}

TEST_F(ImportJobTest, AFitThatCannotBeMadeFailsWithItsPlace) {
  Json request = fit_request();
  request["fit"]["surface"]["text"] = "0,0,0\n1,0,0\n";
  const std::string job = json_of(post("/v1/imports", request))["id"];
  run_import(limits_, store(), board());
  const Json ended = json_of(get("/v1/jobs/" + job));
  EXPECT_EQ(ended["state"], "FAILED");
  EXPECT_EQ(ended["problems"][0]["path"], "/fit/surface");
}

}  // namespace
}  // namespace coapt
