#include "server/options.h"

namespace coapt {
namespace {

template <class T>
void add_limit(CLI::App& app, const std::string& flag, T& value, T least, T most,
               const std::string& help) {
  app.add_option(flag, value, help)
      ->check(CLI::Range(least, most))
      ->capture_default_str()
      ->group("Limits");
}

void add_http_limits(CLI::App& app, HttpLimits& http) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  add_limit(app, "--body-bytes", http.body_bytes, std::size_t{1024}, 64 * kMiB,
            "Of a request's body, counted as they arrive");
  add_limit(app, "--header-bytes", http.header_bytes, std::size_t{1024}, kMiB,
            "Of its request line and headers");
  add_limit(app, "--header-seconds", http.header_seconds, 0.1, 600.0, "For its headers to come");
  add_limit(app, "--body-seconds", http.body_seconds, 0.1, 3600.0, "For its body to come");
  add_limit(app, "--answer-seconds", http.answer_seconds, 0.1, 3600.0,
            "For the client to take the answer");
  add_limit(app, "--connections", http.connections, 8, 100000, "Open at once");
  add_limit(app, "--requests", http.requests, 4, 4096,
            "Answered at once; half of them with a body");
  add_limit(app, "--streams", http.streams, 0, 4096, "Event streams open at once");
}

void add_service_limits(CLI::App& app, ServiceLimits& service) {
  add_limit(app, "--vertices", service.vertices, 10, 1'000'000, "Of a valve");
  add_limit(app, "--chordae", service.chordae, 1, 100'000, "Of a valve");
  add_limit(app, "--evaluations", service.evaluations, 1, 1'000'000, "Of a search");
  add_limit(app, "--seconds", service.seconds, 1.0, 1e6, "That a job may run");
  add_limit(app, "--queue", service.queue, 1, 100'000, "Jobs that wait");
  add_limit(app, "--evaluation-closures", service.evaluation_closures, 1, 1'000'000,
            "Of POST /v1/evaluations: plans times region points and evidence, of 650 triangles");
  add_limit(app, "--wait-seconds", service.wait_seconds, 0, 3600, "Of Prefer: wait");
  add_limit(app, "--running-jobs", service.running_jobs, 1, 64, "Run at once");
  add_limit(app, "--threads", service.threads, 0, 1024,
            "Of a running job; 0: all cores. Does not change any answer");
}

}  // namespace

void add_options(CLI::App& app, ServerOptions& options) {
  app.add_option("--port", options.port, "0 takes a free port")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option("--host", options.host,
                 "Address to listen on; any but this machine's own needs --token-file")
      ->capture_default_str();
  app.add_option(
         "--db", options.database,
         "File of valves and jobs (SQLite, made if missing); closures are kept beside it, in "
         "FILE-plans and FILE-studies")
      ->capture_default_str();
  app.add_option("--token-file", options.token_file,
                 "Requests must carry its first line: Authorization: Bearer TOKEN");
  app.add_option("--allow-host", options.hosts,
                 "Name by which clients call this server besides localhost (Host, Origin)");
  app.add_option(
      "--web", options.web,
      "Folder of the built page; by default build/web, or share/coapt/web of an installation");
  app.add_flag("--log-requests", options.log_requests,
               "A line on standard error for each request: method, route, status, milliseconds");
  add_http_limits(app, options.http);
  add_service_limits(app, options.service);
}

}  // namespace coapt
