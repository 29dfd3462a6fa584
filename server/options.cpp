#include "server/options.h"

#include "server/jobs/job_board.h"
#include "server/workers.h"

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
            "Maximum size of a request body, bytes");
  add_limit(app, "--header-bytes", http.header_bytes, std::size_t{1024}, kMiB,
            "Maximum size of a request line with its headers, bytes");
  add_limit(app, "--header-seconds", http.header_seconds, 0.1, 600.0,
            "Timeout for receiving the headers of a request, s");
  add_limit(app, "--body-seconds", http.body_seconds, 0.1, 3600.0,
            "Timeout for receiving the body of a request, s");
  add_limit(app, "--answer-seconds", http.answer_seconds, 0.1, 3600.0,
            "Timeout for sending the answer, s");
  add_limit(app, "--connections", http.connections, 8, 100000,
            "Maximum number of open connections");
  add_limit(app, "--requests", http.requests, 4, 4096,
            "Maximum number of concurrent requests; half of them may have a body");
  add_limit(app, "--streams", http.streams, 0, 4096, "Maximum number of open event streams");
}

void add_service_limits(Command app, ServiceLimits& service) {
  add_limit(app, "--vertices", service.vertices, 10, 1'000'000,
            "Maximum number of vertices of a valve");
  add_limit(app, "--chordae", service.chordae, 1, 100'000, "Maximum number of chordae of a valve");
  add_limit(app, "--evaluations", service.evaluations, 1, 1'000'000,
            "Maximum number of closures of a search; exploring trade-offs may double it");
  add_limit(app, "--vertex-steps", service.vertex_steps, 1e3, 1e12,
            "Maximum steps times vertices of a closure computed within a request");
  add_limit(app, "--request-seconds", service.request_seconds, 0.1, 3600.0,
            "Maximum computing time within a request, s");
  add_limit(app, "--import-bytes", service.import_bytes, std::size_t{1} << 28, std::size_t{1} << 40,
            "Maximum address space of the process that reads the files of an import, bytes");
  add_limit(app, "--seconds", service.seconds, 1.0, 1e6, "Maximum running time of a job, s");
  add_limit(app, "--kept-plans", service.kept_plans, 0, 1'000'000, "Maximum number of kept plans");
  add_limit(app, "--kept-jobs", service.retention.jobs, 1, 1'000'000,
            "Maximum number of finished jobs to keep; the oldest are removed first");
  add_limit(app, "--kept-days", service.retention.days, 0.0, 36500.0,
            "Days to keep a finished job, and closures that no job has used (0: no limit)");
  add_limit(app, "--kept-valves", service.retention.valves, 1, 1'000'000,
            "Maximum number of stored valves, in addition to those of jobs and kept plans");
  add_limit(app, "--kept-closures", service.retention.closures, 1, 1'000'000'000,
            "Maximum number of stored closures for searches, and separately for studies; the least "
            "recently used valve is evicted first");
  add_limit(app, "--queue", service.queue, 1, 100'000, "Maximum number of waiting jobs");
  add_limit(app, "--evaluation-closures", service.evaluation_closures, 1, 1'000'000,
            "Maximum number of closures of one POST /v1/evaluations (plans times region points, "
            "evidence and draws) for a valve of 650 triangles");
  add_limit(app, "--wait-seconds", service.wait_seconds, 0, 3600,
            "Maximum wait that a client may request (Prefer: wait), s");
  add_limit(app, "--running-jobs", service.running_jobs, 1, 64, "Maximum number of running jobs");
  add_limit(app, "--threads", service.threads, 0, 1024,
            "Number of threads of a running job (0: all cores); does not change results");
}

}  // namespace

void add_options(Command app, ServerOptions& options) {
  app.add_option("--port", options.port, "Port to listen on (0: any free port)")
      .check(number_from(0, 65535))
      .show_default();
  app.add_option(
         "--host", options.host,
         "Address to listen on; any address other than a loopback one (127.0.0.1, ::1) requires "
         "--token-file")
      .show_default();
  app.add_option("--db", options.database,
                 "Database of valves and jobs (SQLite, created if missing); closures are stored "
                 "beside it in FILE-plans and FILE-studies")
      .show_default();
  app.add_option("--token-file", options.token_file,
                 "File with the access token in its first line, which requests must send "
                 "(Authorization: Bearer TOKEN). By default, if other accounts may log in, a token "
                 "is generated once and stored beside --db with the suffix -token");
  app.add_flag("--print-token", options.print_token,
               "Print the token that requests need, or an empty line if they need none, and exit");
  app.add_flag("--no-token", options.no_token,
               "Require no token; every account of this machine can then read all valves and jobs");
  app.add_option("--allow-host", options.hosts,
                 "Host name of this server, in addition to localhost (Host, Origin)");
  app.add_option("--allow-origin", options.origins,
                 "Allow web pages of this site to use the server from a browser, such as "
                 "https://plans.example");
  app.add_option("--farm", options.farm,
                 "Run searches and the closures of studies on the workers of this farm "
                 "(coapt-farm), postgresql://HOST/NAME; searches with a time limit run here")
      .show_argument("URL")
      .environment("COAPT_FARM");
  app.add_option(
      "--web", options.web,
      "Folder of the web page (default: build/web, or share/coapt/web of an installation)");
  app.add_flag("--behind-proxy", options.http.behind_proxy,
               "Tell clients apart by the last address in X-Forwarded-For, which a proxy in front "
               "of the server must set; requests of different clients alternate");
  app.add_flag("--log-requests", options.log_requests,
               "Log each request on standard error: method, route, status, milliseconds");
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
           ", half of --requests, because each stream occupies a thread that answers requests");
  if (options.service.wait_seconds > 0 &&
      Workers::most_of_one_client(http.requests) <= JobBoard::kMostWaiting) {
    int least = http.requests;
    while (Workers::most_of_one_client(least) <= JobBoard::kMostWaiting) ++least;
    refuse("--requests is " + std::to_string(http.requests) + ", must be at least " +
           std::to_string(least) +
           " where clients may wait for jobs: seven sixteenths of the threads answer requests of "
           "one client with a body, and " +
           std::to_string(JobBoard::kMostWaiting) + " may wait (or --wait-seconds 0)");
  }
  return errors;
}

}  // namespace coapt
