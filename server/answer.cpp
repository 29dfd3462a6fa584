#include "server/answer.h"

#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

using nlohmann::ordered_json;

constexpr const char* kProblemTypes = "https://coapt.example/problems/";

const char* title(int status) {
  switch (status) {
    case 400:
      return "Bad request";
    case 401:
      return "Unauthorized";
    case 403:
      return "Forbidden";
    case 404:
      return "Not found";
    case 405:
      return "Method not allowed";
    case 408:
      return "Request timeout";
    case 409:
      return "Conflict";
    case 411:
      return "Length required";
    case 413:
      return "Content too large";
    case 414:
      return "URI too long";
    case 415:
      return "Unsupported media type";
    case 421:
      return "Misdirected request";
    case 422:
      return "Unprocessable content";
    case 429:
      return "Too many requests";
    case 431:
      return "Request header fields too large";
    case 503:
      return "Service unavailable";
    case 507:
      return "Insufficient storage";
    default:
      return status < 500 ? "Request error" : "Internal error";
  }
}

bool says(const Answer& answer, std::string_view name) {
  for (const auto& [given, value] : answer.headers) {
    if (given == name) return true;
  }
  return false;
}

const char* content_security_policy(std::string_view type) {
  return type.starts_with("text/html") ? "default-src 'none'; style-src 'unsafe-inline'; img-src "
                                         "data:; frame-ancestors 'none'"
                                       : "default-src 'none'; frame-ancestors 'none'";
}

}  // namespace

Answer json_answer(int status, ordered_json object) {
  object["notice"] = kResearchNotice;
  return {status, std::move(object)};
}

Answer problem(int status, const Errors& errors) {
  ordered_json problems = to_json(errors);
  const std::string kind = errors.empty() ? "unsupported" : problems[0]["code"].get<std::string>();
  return json_answer(status, {{"type", kProblemTypes + kind},
                              {"title", title(status)},
                              {"status", status},
                              {"detail", errors.empty() ? title(status) : errors.front().message},
                              {"problems", std::move(problems)}});
}

Answer problem(int status, ErrorCode code, const std::string& message) {
  return problem(status, {Error{code, "", message}});
}

std::string content_type(const Answer& answer) {
  if (const auto* content = std::get_if<Content>(&answer.body)) return content->type;
  if (const auto* stream = std::get_if<Stream>(&answer.body)) return stream->type;
  if (std::get<ordered_json>(answer.body).is_null()) return "";
  return answer.status < 400 ? "application/json" : "application/problem+json";
}

std::string content_bytes(const Answer& answer) {
  if (const auto* content = std::get_if<Content>(&answer.body)) return content->bytes;
  const auto* json = std::get_if<ordered_json>(&answer.body);
  if (json == nullptr || json->is_null()) return "";
  return json->dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Headers all_headers(const Answer& answer) {
  Headers headers = answer.headers;
  const auto add = [&](const char* name, std::string value) {
    if (!says(answer, name)) headers.emplace_back(name, std::move(value));
  };
  add("Coapt-Notice", std::string(kResearchNotice));
  add("X-Content-Type-Options", "nosniff");
  add("Cache-Control", "no-store");
  add("Content-Security-Policy", content_security_policy(content_type(answer)));
  add("Referrer-Policy", "no-referrer");
  add("Cross-Origin-Resource-Policy", "same-origin");
  if (answer.status == 429 || answer.status == 503) add("Retry-After", "5");
  return headers;
}

std::string as_http(const Answer& answer) {
  const std::string bytes = content_bytes(answer);
  std::string http =
      "HTTP/1.1 " + std::to_string(answer.status) + ' ' + title(answer.status) + "\r\n";
  for (const auto& [name, value] : all_headers(answer)) http += name + ": " + value + "\r\n";
  return http + "Content-Type: " + content_type(answer) +
         "\r\nContent-Length: " + std::to_string(bytes.size()) + "\r\nConnection: close\r\n\r\n" +
         bytes;
}

}  // namespace coapt
