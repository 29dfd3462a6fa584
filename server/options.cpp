#include "server/options.h"

#include "server/jobs/job_board.h"

namespace coapt {
namespace {

template <class T>
void add_limit(Command app, const std::string& flag, T& value, T least, T most,
               const std::string& help) {
  app.add_option(flag, value, help).check(number_from(least, most)).show_default().group("Limits");
}

void add_http_limits(Command app, HttpLimits& http) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  add_limit(app, "--body-bytes", http.body_bytes, std::size_t{1024}, 64 * kMiB,
            "Bytes of a request's body at most, counted as they arrive");
  add_limit(app, "--header-bytes", http.header_bytes, std::size_t{1024}, kMiB,
            "Bytes of a request line with its headers at most");
  add_limit(app, "--header-seconds", http.header_seconds, 0.1, 600.0,
            "Time for a request's headers to arrive");
  add_limit(app, "--body-seconds", http.body_seconds, 0.1, 3600.0,
            "Time for a request's body to arrive");
  add_limit(app, "--answer-seconds", http.answer_seconds, 0.1, 3600.0,
            "Time for the client to take the answer");
  add_limit(app, "--connections", http.connections, 8, 100000, "Connections open at once, at most");
  add_limit(app, "--requests", http.requests, 4, 4096,
            "Requests answered at once, at most; half of them with a body");
  add_limit(app, "--streams", http.streams, 0, 4096, "Event streams open at once, at most");
}

void add_service_limits(Command app, ServiceLimits& service) {
  add_limit(app, "--vertices", service.vertices, 10, 1'000'000, "Vertices of a valve at most");
  add_limit(app, "--chordae", service.chordae, 1, 100'000, "Chordae of a valve at most");
  add_limit(app, "--evaluations", service.evaluations, 1, 1'000'000,
            "Closures that a search may ask for, at most; what plans trade may take as many again");
  add_limit(app, "--vertex-steps", service.vertex_steps, 1e3, 1e12,
            "Steps times vertices of a closure that a client waits for, at most");
  add_limit(app, "--request-seconds", service.request_seconds, 0.1, 3600.0,
            "Time that is computed for a client that waits");
  add_limit(app, "--import-bytes", service.import_bytes, std::size_t{1} << 28, std::size_t{1} << 40,
            "Address space of the process that reads the files of an import, at most");
  add_limit(app, "--seconds", service.seconds, 1.0, 1e6, "Time that a job may run");
  add_limit(app, "--kept-plans", service.kept_plans, 0, 1'000'000, "Plans that it keeps, at most");
  add_limit(app, "--kept-jobs", service.retention.jobs, 1, 1'000'000,
            "Ended jobs that it keeps, at most; the oldest go first");
  add_limit(app, "--kept-days", service.retention.days, 0.0, 36500.0,
            "Days that it keeps an ended job, and closures that no job has used; 0: no limit");
  add_limit(app, "--kept-valves", service.retention.valves, 1, 1'000'000,
            "Valves that it keeps, at most, besides those of jobs and kept plans");
  add_limit(app, "--kept-closures", service.retention.closures, 1, 1'000'000'000,
            "Closures that it keeps of searches, at most, and as many of studies; those of a valve "
            "go together, the one used least recently first");
  add_limit(app, "--queue", service.queue, 1, 100'000, "Jobs that wait, at most");
  add_limit(app, "--evaluation-closures", service.evaluation_closures, 1, 1'000'000,
            "Closures of one POST /v1/evaluations at most (plans times region points, evidence "
            "and draws) for a valve of 650 triangles");
  add_limit(app, "--wait-seconds", service.wait_seconds, 0, 3600,
            "Longest wait that a client may ask for (Prefer: wait)");
  add_limit(app, "--running-jobs", service.running_jobs, 1, 64, "Jobs that run at once, at most");
  add_limit(app, "--threads", service.threads, 0, 1024,
            "Threads of a running job; 0: all cores. Results do not depend on it");
}

}  // namespace

void add_options(Command app, ServerOptions& options) {
  app.add_option("--port", options.port, "0 takes a free port")
      .check(number_from(0, 65535))
      .show_default();
  app.add_option("--host", options.host,
                 "Address to listen on; any but this machine's own needs --token-file")
      .show_default();
  app.add_option(
         "--db", options.database,
         "File of valves and jobs (SQLite, made if missing); closures are kept beside it, in "
         "FILE-plans and FILE-studies")
      .show_default();
  app.add_option(
      "--token-file", options.token_file,
      "Requests must carry its first line: Authorization: Bearer TOKEN. Without it, where other "
      "accounts may log in, a token is made once, kept in the file of --db with -token behind it");
  app.add_flag("--print-token", options.print_token,
               "Print the token that requests need, an empty line where they need none, and end");
  app.add_flag("--no-token", options.no_token,
               "Ask for no token: every account of this machine may read all valves and jobs");
  app.add_option("--allow-host", options.hosts,
                 "Name by which clients call this server besides localhost (Host, Origin)");
  app.add_option(
      "--allow-origin", options.origins,
      "Site whose pages may use this server from a browser, such as https://plans.example");
  app.add_option("--farm", options.farm,
                 "Searches and the closures of studies by the workers of this farm (coapt-farm): "
                 "postgresql://HOST/NAME; searches with a limit of time stay here")
      .show_argument("URL")
      .environment("COAPT_FARM");
  app.add_option(
      "--web", options.web,
      "Folder of the built page; by default build/web, or share/coapt/web of an installation");
  app.add_flag("--log-requests", options.log_requests,
               "A line on standard error for each request: method, route, status, milliseconds");
  add_http_limits(app, options.http);
  add_service_limits(app, options.service);
}

Errors check_together(const ServerOptions& options) {
  const HttpLimits& http = options.http;
  Errors errors;
  const auto refuse = [&errors](const std::string& message) {
    errors.push_back({ErrorCode::OutOfRange, "", message});
  };
  if (http.streams > http.requests / 2)
    refuse("--streams is " + std::to_string(http.streams) + ", must be at most " +
           std::to_string(http.requests / 2) +
           ", half of --requests: each stream holds a thread that answers requests");
  if (options.service.wait_seconds > 0 && http.requests / 2 <= JobBoard::kMostWaiting)
    refuse(
        "--requests is " + std::to_string(http.requests) + ", must be at least " +
        std::to_string(2 * JobBoard::kMostWaiting + 2) +
        " where clients may wait for jobs: half of the threads answer requests with a body, and " +
        std::to_string(JobBoard::kMostWaiting) + " may wait (or --wait-seconds 0)");
  return errors;
}

}  // namespace coapt
