#include "clients/cli/service.h"

#include <httplib.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <thread>

#include "core/valve/printable.h"
#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTries = 5;
constexpr std::chrono::milliseconds kFirstPause(250);  // before the second try; doubled with each
constexpr std::chrono::seconds kLongestPause(30), kStreamPause(2), kPatience(60);
// The largest answers, reports and meshes, have some 30 MiB.
constexpr std::size_t kMostAnswer = std::size_t{256} << 20, kMostEvent = std::size_t{16} << 20;
constexpr int kMostLevels = 32;  // of JSON, as in requests
constexpr std::chrono::seconds kConnect(10), kAnswer(300),
    kHeartbeats(45);  // the service's is 15 s

struct Reply {
  int status = 0;
  std::string body{}, retry_after{};
  bool too_large = false;  ///< more than kMostAnswer: nothing of it is there
  std::string type = {};   ///< of the body
  bool is_saved = false;   ///< it has a name
};

struct Call {
  std::string method, path, body, key;
};

/// Blocks SIGPIPE for this thread, which a service that closes early would raise; where results are printed it keeps
/// its meaning.
class BrokenPipesAreErrors {
 public:
  BrokenPipesAreErrors() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~BrokenPipesAreErrors() {
    const timespec now{};
    while (sigtimedwait(&pipe_, nullptr, &now) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  BrokenPipesAreErrors(const BrokenPipesAreErrors&) = delete;
  BrokenPipesAreErrors& operator=(const BrokenPipesAreErrors&) = delete;

 private:
  sigset_t pipe_{}, before_{};
};

/// "http://host:port" and the path below which the service is.
std::pair<std::string, std::string> split_url(const std::string& url) {
  const std::size_t host = url.find("://");
  const std::size_t path = host == std::string::npos ? host : url.find('/', host + 3);
  std::string prefix = path == std::string::npos ? "" : url.substr(path);
  while (prefix.ends_with('/')) prefix.pop_back();
  return {url.substr(0, path), prefix};
}

httplib::Headers headers_of(const Service& service) {
  httplib::Headers headers = {{"User-Agent", "coapt/" + std::string(version())}};
  if (!service.token.empty()) headers.emplace("Authorization", "Bearer " + service.token);
  return headers;
}

httplib::Client client_of(const std::string& origin, std::chrono::seconds patience) {
  httplib::Client client(origin);
  client.set_connection_timeout(kConnect);
  client.set_read_timeout(patience);
  client.set_write_timeout(patience);
  return client;
}

std::string in_words(httplib::Error error) {
  switch (error) {
    case httplib::Error::Connection:
      return "no connection; check that coapt-server is running and that the address is correct";
    case httplib::Error::ConnectionTimeout:
      return "no connection within " + std::to_string(kConnect.count()) + " s";
    case httplib::Error::Read:
    case httplib::Error::Write:
      return "the connection was lost";
    case httplib::Error::SSLConnection:
      return "no encrypted connection can be made (TLS)";
    case httplib::Error::SSLServerVerification:
      return "its certificate is not trusted";
    default:
      return httplib::to_string(error);
  }
}

Errors unreachable(const Service& service, httplib::Error error) {
  return {Error{ErrorCode::InputOutput, "", service.url + " does not answer: " + in_words(error)}};
}

Error answer_too_large(const Service& service) {
  return {ErrorCode::InputOutput, "",
          service.url + " answered with more than 256 MiB, the limit for a service's answer"};
}

Expected<Reply> call_once(const Service& service, const Call& call) {
  const BrokenPipesAreErrors guard;
  const auto [origin, prefix] = split_url(service.url);
  httplib::Client client = client_of(origin, kAnswer);
  httplib::Headers headers = headers_of(service);
  if (!call.key.empty()) headers.emplace("Idempotency-Key", call.key);
  httplib::Request request;
  request.method = call.method;
  request.path = prefix + call.path;
  request.headers = headers;
  request.body = call.body;
  if (call.method != "GET") request.set_header("Content-Type", "application/json");
  std::string body;
  bool too_large = false;
  request.content_receiver = [&](const char* bytes, std::size_t size, std::uint64_t,
                                 std::uint64_t) {
    too_large = body.size() + size > kMostAnswer;
    if (!too_large) body.append(bytes, size);
    return !too_large;
  };
  const httplib::Result result = client.send(request);
  if (too_large) return Reply{.too_large = true};
  if (!result) return unreachable(service, result.error());
  return Reply{result->status,
               std::move(body),
               result->get_header_value("Retry-After"),
               false,
               result->get_header_value("Content-Type"),
               result->has_header("Content-Disposition")};
}

/// Makes names and strings printable, but for whole files, and leaves files their names without folders: none is written beside
/// the folder that a user chose. False: nested too deep.
bool clean(Json& json, int level = 0) {
  if (level > kMostLevels) return false;
  if (json.is_string()) json = printable(json.get_ref<const std::string&>());
  if (json.is_array())
    return std::all_of(json.begin(), json.end(), [&](Json& one) { return clean(one, level + 1); });
  if (!json.is_object()) return true;
  Json::object_t members;
  auto& object = json.get_ref<Json::object_t&>();
  members.reserve(object.size());
  const bool names_file =
      json.contains("text") || json.contains("base64") || json.contains("bytes");
  for (auto& [name, value] : object) {
    const bool is_file = value.is_string() && (name == "text" || name == "base64");
    if (!is_file && !clean(value, level + 1)) return false;
    if (names_file && name == "name" && value.is_string())
      value = std::filesystem::path(value.get_ref<const std::string&>()).filename().string();
    members.emplace_back(printable(name), std::move(value));
  }
  object.swap(members);
  return true;
}

/// What a service said, of which nothing moves a terminal; discarded if it is not JSON.
Json read_json(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  if (clean(json)) return json;
  return Json::value_t::discarded;
}

/// What a service, or a proxy before it, says against a request.
Errors problems_of(const Service& service, const Reply& reply) {
  const Json json = read_json(reply.body);
  if (json.is_object() && json.contains("problems"))
    if (Errors errors = errors_from_json(json["problems"]); !errors.empty()) return errors;
  return {Error{reply.status >= 500 ? ErrorCode::InputOutput : ErrorCode::Unsupported, "",
                service.url + " answered with status " + std::to_string(reply.status)}};
}

bool is_busy(int status) { return status == 429 || status == 503; }

std::chrono::milliseconds pause_after(const Reply& reply, std::chrono::milliseconds otherwise) {
  int seconds = 0;
  const std::string& said = reply.retry_after;
  std::from_chars(said.data(), said.data() + said.size(), seconds);
  const std::chrono::milliseconds asked = seconds > 0 ? std::chrono::seconds(seconds) : otherwise;
  return std::min<std::chrono::milliseconds>(asked, kLongestPause);
}

Expected<Reply> call(const Service& service, const Call& one) {
  std::chrono::milliseconds pause = kFirstPause;
  for (int tries = 1;; ++tries, pause *= 2) {
    Expected<Reply> reply = call_once(service, one);
    if (reply && reply->too_large) return answer_too_large(service);
    if (reply && reply->status < 300) return reply;
    if (reply && !is_busy(reply->status)) return problems_of(service, *reply);
    if (tries == kTries) return reply ? problems_of(service, *reply) : reply.errors();
    std::this_thread::sleep_for(reply ? pause_after(*reply, pause) : pause);
  }
}

Expected<std::string> body_of(Expected<Reply> reply) {
  if (!reply) return reply.errors();
  return std::move(reply->body);
}

Expected<Json> json_of(const Service& service, const Expected<Reply>& reply) {
  if (!reply) return reply.errors();
  Json json = read_json(reply->body);
  if (json.is_discarded())
    return Error{ErrorCode::InputOutput, "", service.url + " did not answer with JSON"};
  return json;
}

/// Takes a stream of server-sent events in as it comes.
class EventReader {
 public:
  explicit EventReader(const std::function<void(const ServiceEvent&)>& tell) : tell_(tell) {}

  void take(const char* bytes, std::size_t size) {
    heard_ = Clock::now();
    text_.append(bytes, size);
    for (std::size_t end; (end = text_.find("\n\n")) != std::string::npos;) {
      read(text_.substr(0, end));
      text_.erase(0, end + 2);
    }
    if (text_.size() > kMostEvent) text_.clear();  // no event of this service is so long
  }
  /// Before another stream: what broke off comes again.
  void restart() { text_.clear(); }
  const std::string& last() const { return last_; }
  bool has_ended() const { return ended_; }
  /// When something came, be it a heartbeat.
  Clock::time_point heard() const { return heard_; }

 private:
  void read(const std::string& event) {
    std::istringstream lines(event);
    std::string kind, data;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("id: ")) last_ = line.substr(4);
      if (line.starts_with("event: ")) kind = line.substr(7);
      if (line.starts_with("data: ")) data = line.substr(6);
    }
    const Json json = read_json(data);
    if (!json.is_object()) return;
    const std::string state = kind == "state" ? json.value("state", "") : "";
    ended_ = state == "SUCCEEDED" || state == "FAILED" || state == "CANCELLED";
    tell_({state, kind == "progress" ? json : Json()});
  }

  const std::function<void(const ServiceEvent&)>& tell_;
  std::string text_, last_ = "0";
  bool ended_ = false;
  Clock::time_point heard_ = Clock::now();
};

/// One stream, until it ends. The reply's body is that of a refusal.
Expected<Reply> read_stream(const Service& service, const std::string& path, EventReader& reader) {
  const BrokenPipesAreErrors guard;
  const auto [origin, prefix] = split_url(service.url);
  httplib::Client client = client_of(origin, kHeartbeats);
  httplib::Headers headers = headers_of(service);
  headers.emplace("Last-Event-ID", reader.last());
  Reply reply;
  reader.restart();
  const httplib::Result result = client.Get(
      prefix + path, headers,
      [&](const httplib::Response& response) {
        reply.status = response.status;
        reply.retry_after = response.get_header_value("Retry-After");
        return true;
      },
      [&](const char* bytes, std::size_t size) {
        if (reply.status == 200) {
          reader.take(bytes, size);
        } else if (reply.body.size() + size <= kMostEvent) {
          reply.body.append(bytes, size);
        } else {
          return false;
        }
        return !reader.has_ended();
      });
  if (!result && !reader.has_ended()) return unreachable(service, result.error());
  return reply;
}

}  // namespace

Expected<std::string> get(const Service& service, const std::string& path) {
  return body_of(call(service, {"GET", path, "", ""}));
}

Expected<ServiceAnswer> post(const Service& service, const std::string& path, const Json& body) {
  Expected<Reply> reply = call(service, {"POST", path, body.dump(), ""});
  if (!reply) return reply.errors();
  return ServiceAnswer{std::move(reply->body), std::move(reply->type), reply->is_saved};
}

Expected<Json> get_json(const Service& service, const std::string& path) {
  return json_of(service, call(service, {"GET", path, "", ""}));
}

Expected<Json> post_json(const Service& service, const std::string& path, const Json& body,
                         const std::string& key) {
  return json_of(service, call(service, {"POST", path, body.dump(), key}));
}

Errors follow_job(const Service& service, const std::string& job_path,
                  const std::function<void(const ServiceEvent&)>& tell) {
  EventReader reader(tell);
  Clock::time_point answered = Clock::now();
  while (!reader.has_ended()) {
    const Expected<Reply> reply = read_stream(service, job_path + "/events", reader);
    if (reply && reply->status == 204) return {};
    if (reply && reply->status >= 300 && !is_busy(reply->status))
      return problems_of(service, *reply);
    if (reply) answered = Clock::now();
    if (!reply && Clock::now() - std::max(answered, reader.heard()) > kPatience)
      return reply.errors();
    if (!reader.has_ended())
      std::this_thread::sleep_for(reply ? pause_after(*reply, kStreamPause) : kStreamPause);
  }
  return {};
}

}  // namespace coapt
