// Events are the store's: a client that comes back after a while, or after the server was killed, is told what it
// missed.
#include "server/endpoints/job_events.h"

#include <memory>

#include "server/answers.h"
#include "server/query.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kHeartbeat(15);
constexpr std::chrono::milliseconds kLook(1000);  // in between the client may have gone
constexpr int kAtOnce = 100;                      // events

std::string text_of(const JobEvent& event) {
  return "id: " + std::to_string(event.number) + "\nevent: " + event.kind +
         "\ndata: " + event.content + "\n\n";
}

struct Follower {
  const JobStore& store;
  const JobBoard& jobs;
  std::string id;
  std::int64_t last = 0;
  bool greeted = false;
  Clock::time_point sent = Clock::now();

  bool send(const Send& send_part, const std::string& text) {
    sent = Clock::now();
    return send_part(text);
  }

  /// See Stream::next.
  bool next(const Send& send_part) {
    if (!greeted) {
      greeted = true;
      return send(send_part, "retry: 2000\n\n");
    }
    const Expected<std::optional<Job>> job = store.job(id);
    const Expected<std::vector<JobEvent>> events = store.events(id, last, kAtOnce);
    if (!job || !*job || !events) return false;
    for (const JobEvent& event : *events) {
      if (!send(send_part, text_of(event))) return false;
      last = event.number;
    }
    if (!events->empty()) return true;
    if (has_ended((*job)->state) || jobs.stopping()) return false;
    if (Clock::now() - sent >= kHeartbeat && !send(send_part, ": heartbeat\n\n")) return false;
    jobs.wait(kLook);
    return true;
  }
};

}  // namespace

Answer GetJobEvents::operator()(const Request& request) const {
  ProblemList problems;
  check_query(request, {"last_event_id"}, problems);
  Request asked = request;
  const auto header = request.headers.find("last-event-id");
  const bool is_in_header = header != request.headers.end();
  if (is_in_header) asked.query["last_event_id"] = header->second;
  ProblemList of_number;
  const std::int64_t last = integer_in(asked, "last_event_id", {0.0, 1e15}, 0, of_number);
  for (const Error& error : std::move(of_number).take())
    problems.add(error.code, is_in_header ? "" : error.path,
                 (is_in_header ? "Last-Event-ID " : "") + error.message);
  if (!problems.empty()) return problem(422, std::move(problems).take());

  const std::string& id = request.parameters.at(0);
  const Expected<std::optional<Job>> job = store.job(id);
  if (!job) return store_problem(job.errors());
  if (!*job) return not_found("job");
  const Expected<std::vector<JobEvent>> events = store.events(id, last, 1);
  if (!events) return store_problem(events.errors());
  if (has_ended((*job)->state) && events->empty()) return {204};
  const auto follower = std::make_shared<Follower>(Follower{store, jobs, id, last});
  return {200, Stream{"text/event-stream",
                      [follower](const Send& send) { return follower->next(send); }}};
}

}  // namespace coapt
