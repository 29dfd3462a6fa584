#include "server/endpoints/jobs.h"

#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class JobsTest : public ServiceTest {
 protected:
  Json state_of(const std::string& id) { return json_of(get("/v1/jobs/" + id))["state"]; }
};

std::vector<std::string> ids_of(const Answer& answer) {
  std::vector<std::string> ids;
  const Json page = json_of(answer);
  for (const auto& job : page["jobs"]) ids.push_back(job["id"]);
  return ids;
}

/// All that a stream sends until it ends.
std::string text_of(const Answer& answer) {
  std::string text;
  const auto send = [&](std::string_view part) {
    text += part;
    return true;
  };
  while (std::get<Stream>(answer.body).next(send)) {
  }
  return text;
}

TEST_F(JobsTest, AJobIsSeenByItsId) {
  queued_job("j");
  const Json job = json_of(get("/v1/jobs/j"));
  EXPECT_EQ(job["state"], "QUEUED");
  EXPECT_EQ(job["valve"], "valve");
  EXPECT_EQ(job["plans"], nullptr);
  EXPECT_EQ(job["links"]["events"], "/v1/jobs/j/events");
  EXPECT_FALSE(job["links"].contains("result"));
  EXPECT_EQ(get("/v1/jobs/other").status, 404);
}

TEST_F(JobsTest, AListIsPagedNewestFirstAndFilteredByState) {
  for (const char* id : {"a", "b", "c"}) queued_job(id);
  finish_next({});
  const Answer page = get("/v1/jobs?page_size=2");
  EXPECT_EQ(ids_of(page), (std::vector<std::string>{"c", "b"}));
  const std::string token = json_of(page)["next_page_token"];
  const Answer rest = get("/v1/jobs?page_size=2&page_token=" + token);
  EXPECT_EQ(ids_of(rest), std::vector<std::string>{"a"});
  EXPECT_EQ(json_of(rest)["next_page_token"], nullptr);
  EXPECT_EQ(ids_of(get("/v1/jobs?state=SUCCEEDED")), std::vector<std::string>{"a"});
  EXPECT_EQ(refusal(get("/v1/jobs?page_size=0&state=X&y=1&page_token=z")),
            (Refused{422, {"?y", "?page_size", "?page_token", "?state"}}));
}

TEST_F(JobsTest, AWaitingJobIsCancelledAtOnce) {
  queued_job("j");
  const Answer answer = ask("POST", "/v1/jobs/j:cancel");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(json_of(answer)["state"], "CANCELLED");
  EXPECT_EQ(ask("POST", "/v1/jobs/other:cancel").status, 404);
}

TEST_F(JobsTest, ARunningJobIsToldToEnd) {
  queued_job("j");
  const std::shared_ptr<RunningJob> job = board().take();
  int stalled = 0;
  ASSERT_TRUE(board().start(*job, 0, stalled));
  const Answer answer = ask("POST", "/v1/jobs/j:cancel");
  EXPECT_EQ(json_of(answer)["state"], "RUNNING");
  EXPECT_EQ(json_of(answer)["cancel_requested"], true);
  EXPECT_TRUE(job->cancelled);
}

TEST_F(JobsTest, AnEndedJobIsRemovedAnotherStays) {
  queued_job("j");
  EXPECT_EQ(remove("/v1/jobs/j").status, 409);
  EXPECT_EQ(state_of("j"), "QUEUED");
  finish_next({});
  EXPECT_EQ(remove("/v1/jobs/j").status, 204);
  EXPECT_EQ(remove("/v1/jobs/j").status, 404);
  EXPECT_EQ(get("/v1/jobs/j").status, 404);
}

TEST_F(JobsTest, EventsGoOnAfterTheLastOneSeen) {
  queued_job("j");
  finish_next({});
  const Answer all = get("/v1/jobs/j/events");
  EXPECT_EQ(std::get<Stream>(all.body).type, "text/event-stream");
  EXPECT_EQ(text_of(all),
            "retry: 2000\n\n"
            "id: 1\nevent: state\ndata: {\"state\": \"QUEUED\"}\n\n"
            "id: 2\nevent: state\ndata: {\"state\": \"RUNNING\"}\n\n"
            "id: 3\nevent: state\ndata: {\"state\": \"SUCCEEDED\"}\n\n");
  const std::string last =
      "retry: 2000\n\nid: 3\nevent: state\ndata: {\"state\": \"SUCCEEDED\"}\n\n";
  EXPECT_EQ(text_of(get("/v1/jobs/j/events", {{"last-event-id", "2"}})), last);
  EXPECT_EQ(text_of(get("/v1/jobs/j/events?last_event_id=2")), last);
  EXPECT_EQ(get("/v1/jobs/j/events", {{"last-event-id", "3"}}).status, 204);
}

TEST_F(JobsTest, EventsOfNoJobOrAfterNoNumberAreRefused) {
  EXPECT_EQ(get("/v1/jobs/other/events").status, 404);
  queued_job("j");
  EXPECT_EQ(refusal(get("/v1/jobs/j/events?last_event_id=x&y=1")),
            (Refused{422, {"?y", "?last_event_id"}}));
  const Answer answer = get("/v1/jobs/j/events", {{"last-event-id", "x"}});
  EXPECT_EQ(refusal(answer), (Refused{422, {""}}));
  EXPECT_TRUE(json_of(answer)["detail"].get<std::string>().starts_with("Last-Event-ID must be"));
}

TEST_F(JobsTest, AStreamEndsWhenTheServerStops) {
  queued_job("j");
  const Answer events = get("/v1/jobs/j/events");
  board().stop();
  EXPECT_EQ(text_of(events),
            "retry: 2000\n\nid: 1\nevent: state\ndata: {\"state\": \"QUEUED\"}\n\n");
}

}  // namespace
}  // namespace coapt
