// coapt-server: closures, searches and studies over HTTP.
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <condition_variable>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <thread>

#include "io/json/plan_json.h"
#include "io/json/version.h"
#include "io/store/closure_store.h"
#include "io/store/plan_store.h"
#include "server/content_id.h"
#include "server/crash_mark.h"
#include "server/jobs/closure_retention.h"
#include "server/jobs/import_job.h"
#include "server/jobs/operation_job.h"
#include "server/jobs/plan_job.h"
#include "server/jobs/study_job.h"
#include "server/login_accounts.h"
#include "server/memory.h"
#include "server/options.h"
#include "server/routes.h"
#include "server/service.h"

namespace coapt {
namespace {

constexpr int kOk = 0, kFailure = 1, kBadInput = 2;
constexpr std::chrono::seconds kPatience(
    8);  // from the signal to the end, whatever is still running

int fail(int status, const Errors& errors) {
  for (const Error& error : errors) std::cerr << "coapt-server: " << error.message << '\n';
  return status;
}

void log_request(const Exchange& exchange) {
  std::ostringstream line;
  line << exchange.method << ' ' << exchange.route << ' ' << exchange.status << ' '
       << 1e3 * exchange.seconds << " ms\n";
  std::cerr << line.str();
}

/// Stops board and server on SIGINT or SIGTERM. If something cannot be ended in time, the process ends all the same:
/// jobs lose nothing by it, as by kill -9.
class Stopper {
 public:
  /// @pre made before any other thread, so that they all leave the two signals to it.
  Stopper() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    // Clients that go, and a limit on the size of files, are errors like others.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
  }

  void watch(JobBoard& board, HttpServer& http) {
    thread_ = std::thread([this, &board, &http] {
      int signal = 0;
      sigwait(&signals_, &signal);
      board.stop();
      http.stop();
      std::unique_lock<std::mutex> lock(mutex_);
      if (ended_.wait_for(lock, kPatience, [this] { return is_over_; })) return;
      std::cerr
          << "coapt-server: a closure did not finish in time; its job resumes at the next start\n";
      board.suspend_all();
      _exit(kOk);
    });
  }

  /// All jobs have ended.
  void over() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    ended_.notify_all();
    pthread_kill(thread_.native_handle(), SIGTERM);
    thread_.join();
  }

 private:
  sigset_t signals_{};
  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_over_ = false;
};

/// Where people open the page: with the token, if one was made for them.
void print_address(const std::string& host, int port, const std::string& made_token) {
  const std::string address = "http://" + host + ':' + std::to_string(port);
  std::ostringstream lines;
  if (!made_token.empty())
    lines << "coapt-server: requests require a token, because other accounts may log in to this "
             "machine (--no-token disables it)\n"
             "coapt-server: the page is at "
          << address << "/#token=" << made_token
          << "\ncoapt-server: for programs, set COAPT_TOKEN=" << made_token << '\n';
  lines << "coapt-server: listening on " << address << '\n';
  std::cerr << lines.str();  // at once: programs wait for it
}

int serve(const ServerOptions& options, const Access& access, const ReaderProcesses& readers) {
  set_up_memory();
  Stopper stopper;
  umask(S_IRWXG | S_IRWXO);  // valves are of patients: no other user reads the files
  Expected<JobStore> store = JobStore::open(options.database);
  if (!store) return fail(kFailure, store.errors());
  const std::string plans = options.database + "-plans", studies = options.database + "-studies";
  if (const auto opened = PlanStore::open(plans); !opened) return fail(kFailure, opened.errors());
  if (const auto opened = ClosureStore::open(studies); !opened)
    return fail(kFailure, opened.errors());
  JobBoard board(*store, options.service.queue, options.service.retention);
  const std::string crash_mark = options.database + "-crashed";
  if (const Errors errors = board.resume(take_crash_mark(crash_mark)); !errors.empty())
    return fail(kFailure, errors);
  leave_crash_mark_at(crash_mark);
  const ClosureRetention retention{*store, options.service.retention, plans, studies};
  static_cast<void>(retention(wall_clock_ms()));  // else after the next job

  const std::string folder = options.web.empty() ? usual_page_folder() : options.web;
  const Expected<Page> read = folder.empty() ? Page{} : read_page(folder);
  if (!read) return fail(kFailure, read.errors());
  const Page& page = *read;

  Metrics metrics;
  ValveCache known;
  Compute parsing;
  Compute compute(options.service.request_seconds);
  SearchReports reports;
  FarmWatch farm(options.farm.empty() ? std::nullopt : std::optional(farm_at(options.farm)));
  const PageTokens tokens;
  const ImportReader imports{options.service, &readers};
  HttpServer* running = nullptr;
  const Service service{options.service,
                        *store,
                        board,
                        known,
                        parsing,
                        compute,
                        imports,
                        reports,
                        farm,
                        metrics,
                        page,
                        tokens,
                        [&running] { return running->load(); }};
  const Routes routes = routes_of(service);
  HttpServer http(options.http, routes, access, [&](const Exchange& exchange) {
    metrics.observe(exchange);
    if (options.log_requests) log_request(exchange);
  });
  running = &http;
  const Expected<int> port = http.bind(options.host, options.port);
  if (!port) return fail(kFailure, port.errors());

  bool served = false;
  stopper.watch(board, http);
  {
    const JobRunner runner(
        board,
        with_operations({{"plans", PlanJob{board, *store, options.service, plans, options.farm}},
                         {"study", StudyJob{board, *store, options.service, studies, options.farm}},
                         {"import", ImportJob{board, *store, imports}}},
                        board, *store, imports),
        options.service.running_jobs,
        [&retention](const Job& ended) { static_cast<void>(retention(ended, wall_clock_ms())); });
    print_address(options.host, *port, options.token_file.empty() ? access.token : "");
    served = http.run();
    board.stop();
  }
  stopper.over();
  return served ? kOk : kFailure;
}

int run(int argc, char** argv) {
  CommandLine line("coapt-server", "Closes valves and searches repair plans over HTTP.");
  line.add_json_of_version();
  Command app = line.program();
  ServerOptions options;
  add_options(app, options);
  app.footer(
      "The web page is at /, the API description at /openapi.json. Jobs survive a restart of the "
      "server\nwith the same --db. SIGTERM and Ctrl-C stop the server within 10 s.\n\n"
      "Examples:\n"
      "  export COAPT_TOKEN=$(coapt-server --db coapt.sqlite --print-token)\n"
      "  coapt-server --db coapt.sqlite &\n"
      "  curl --retry 9 --retry-connrefused -H \"Authorization: Bearer $COAPT_TOKEN\" -d "
      "'{\"valve\": \"human-functional-mr\"}' "
      "http://127.0.0.1:8080/v1/closures");
  line.end_helps_with(std::string(kResearchNotice));
  if (const std::optional<int> ended = line.parse(argc, argv)) return *ended;
  if (const Errors errors = check_together(options); !errors.empty())
    return fail(kBadInput, errors);

  // Before any token is read: what strangers' files can reach has none.
  const std::unique_ptr<ReaderProcesses> readers = import_processes(options.service);
  Access access;
  access.hosts.insert(options.hosts.begin(), options.hosts.end());
  access.origins.insert(options.origins.begin(), options.origins.end());
  if (!options.token_file.empty()) {
    const Expected<std::string> token = read_token(options.token_file);
    if (!token) return fail(kBadInput, token.errors());
    access.token = *token;
  } else if (!is_loopback(options.host)) {
    return fail(kBadInput, {Error{ErrorCode::MissingField, "",
                                  "other machines can reach " + options.host +
                                      ", so --token-file is required"}});
  } else if (!options.no_token && !other_login_accounts().empty()) {
    const Expected<std::string> token = kept_token(options.database + "-token");
    if (!token) return fail(kFailure, token.errors());
    access.token = *token;
  }
  if (options.print_token) {
    std::cout << access.token << '\n';
    return kOk;
  }
  return serve(options, access, *readers);
}

}  // namespace
}  // namespace coapt

int main(int argc, char** argv) {
  try {
    return coapt::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "coapt-server: " << error.what() << '\n';
    return 1;
  }
}
