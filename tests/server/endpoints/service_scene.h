// The whole service without HTTP: its routes over a store in memory. No thread runs its jobs.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/valve/parametric.h"
#include "io/json/plan_json.h"
#include "io/json/valve_json.h"
#include "io/store/stored_valves.h"
#include "server/routes.h"
#include "server/service.h"
#include "tests/io/store/store_scene.h"

namespace coapt {

/// Where there is memory to be had as files: what is forced to the disk there costs nothing.
inline std::filesystem::path memory_folder() {
  const std::filesystem::path memory = "/dev/shm";
  return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

inline JobStore open_store(const std::string& path) { return *JobStore::open(path); }

/// Some 150 triangles: it closes in milliseconds.
inline const Valve& small_valve() {
  static const Valve kValve = [] {
    ParametricValve dimensions;
    dimensions.triangles = 150;
    return *make_parametric_valve(dimensions);
  }();
  return kValve;
}
inline Json small_document() { return Json::parse(write_valve(small_valve())); }

using Fields = std::map<std::string, std::string>;

class ServiceTest : public testing::Test {
 protected:
  /// @param target a path, with or without a query
  Answer ask(const std::string& method, const std::string& target, const std::string& body = "",
             const Fields& headers = {}) {
    Request request;
    request.method = method;
    const std::size_t end = target.find('?');
    request.path = target.substr(0, end);
    for (std::size_t at = end; at != target.npos;) {
      const std::size_t next = target.find('&', at + 1);
      const std::string field = target.substr(at + 1, next == target.npos ? next : next - at - 1);
      request.query[field.substr(0, field.find('='))] = field.substr(field.find('=') + 1);
      at = next;
    }
    request.headers = headers;
    request.body = body;
    const Routes routes = routes_of(service_);
    Found found = find_route(routes, request);
    if (found.route == nullptr) return found.refusal;
    request.parameters = found.parameters;
    return found.route->endpoint(request);
  }
  Answer get(const std::string& target, const Fields& headers = {}) {
    return ask("GET", target, "", headers);
  }
  Answer post(const std::string& path, const Json& body, const Fields& headers = {}) {
    return ask("POST", path, body.dump(), headers);
  }
  Answer remove(const std::string& path) { return ask("DELETE", path); }

  /// The id of the small valve, stored.
  std::string stored_valve() {
    const std::string id(64, 'a');
    EXPECT_TRUE(add_valve(store_, id, write_valve(small_valve())));
    return id;
  }
  /// Submitted, and not taken yet.
  std::string queued_job(const std::string& id, const std::string& kind = "plans") {
    EXPECT_TRUE(board_.submit({id, kind, "valve", "{}"}, write_valve(small_valve())));
    return id;
  }
  /// The oldest job that waits, ended as `end` says.
  void finish_next(const JobEnd& end) {
    const std::shared_ptr<RunningJob> job = board_.take();
    int stalled = 0;
    ASSERT_TRUE(board_.start(*job, 0, stalled));
    ASSERT_TRUE(board_.finish(job, end));
  }

  static constexpr int kQueue = 3;

  // Machines are shared, and slow under sanitizers.
  ServiceLimits limits_{.request_seconds = 300.0};
  JobStore& store() { return store_; }
  JobBoard& board() { return board_; }
  Compute& compute() { return compute_; }
  Compute& parsing() { return parsing_; }

 private:
  TemporaryFolder folder_{memory_folder()};
  JobStore store_ = open_store(folder_.file("jobs.db"));
  JobBoard board_{store_, kQueue};
  ValveCache known_;
  static constexpr std::chrono::milliseconds kNone{0}, kAsLongAsItTakes{1'000'000};
  Compute parsing_{1, kNone, kAsLongAsItTakes}, compute_{1, kNone, kAsLongAsItTakes};
  SearchReports reports_{1, std::chrono::milliseconds(0)};
  FarmWatch farm_{std::nullopt};
  Metrics metrics_;
  Page page_;
  PageTokens tokens_;
  Service service_{.limits = limits_,
                   .store = store_,
                   .jobs = board_,
                   .known = known_,
                   .parsing = parsing_,
                   .compute = compute_,
                   .imports = {limits_},
                   .reports = reports_,
                   .farm = farm_,
                   .metrics = metrics_,
                   .page = page_,
                   .tokens = tokens_,
                   .load = [] {
                     return HttpLoad{7, 5, 3};
                   }};
};

inline Json json_of(const Answer& answer) {
  if (const auto* content = std::get_if<Content>(&answer.body)) return Json::parse(content->bytes);
  return std::get<Json>(answer.body);
}

inline std::string bytes_of(const Answer& answer) {
  const auto* content = std::get_if<Content>(&answer.body);
  return content == nullptr ? "" : content->bytes;
}

/// Empty if it is not there.
inline std::string header_of(const Answer& answer, const std::string& name) {
  for (const auto& [its_name, value] : answer.headers)
    if (its_name == name) return value;
  return "";
}

/// Status and paths of a refusal.
struct Refused {
  int status = 0;
  std::vector<std::string> paths;
  bool operator==(const Refused&) const = default;
};
inline void PrintTo(const Refused& refused, std::ostream* to) {
  *to << refused.status;
  for (const std::string& path : refused.paths) *to << ' ' << path;
}
inline Refused refusal(const Answer& answer) {
  Refused refused{answer.status, {}};
  for (const auto& problem : json_of(answer).value("problems", Json::array()))
    refused.paths.push_back(problem["path"]);
  return refused;
}

}  // namespace coapt
