#include "server/answer.h"

#include "io/json/problem_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

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

Answer json_answer(int status, Json object) {
  object["notice"] = kResearchNotice;
  return {status, std::move(object)};
}

Answer problem(int status, const Errors& errors) {
  return json_answer(status, problem_json(status, errors));
}

Answer problem(int status, ErrorCode code, const std::string& message) {
  return problem(status, {Error{code, "", message}});
}

std::string content_type(const Answer& answer) {
  if (const auto* content = std::get_if<Content>(&answer.body)) return content->type;
  if (const auto* stream = std::get_if<Stream>(&answer.body)) return stream->type;
  if (std::get<Json>(answer.body).is_null()) return "";
  return answer.status < 400 ? "application/json" : "application/problem+json";
}

std::string content_bytes(const Answer& answer) {
  if (const auto* content = std::get_if<Content>(&answer.body)) return content->bytes;
  const auto* json = std::get_if<Json>(&answer.body);
  if (json == nullptr || json->is_null()) return "";
  return json_text(*json);
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
      "HTTP/1.1 " + std::to_string(answer.status) + ' ' + status_title(answer.status) + "\r\n";
  for (const auto& [name, value] : all_headers(answer)) http += name + ": " + value + "\r\n";
  return http + "Content-Type: " + content_type(answer) +
         "\r\nContent-Length: " + std::to_string(bytes.size()) + "\r\nConnection: close\r\n\r\n" +
         bytes;
}

}  // namespace coapt
