#include "io/json/problem_json.h"

#include <string>
#include <utility>

#include "io/json/result_json.h"

namespace coapt {
namespace {

constexpr const char* kProblemTypes = "https://coapt.example/problems/";

}  // namespace

const char* status_title(int status) {
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

Json problem_json(int status, const Errors& errors) {
  Json problems = to_json(errors);
  const std::string kind = errors.empty() ? "unsupported" : problems[0]["code"].get<std::string>();
  return {{"type", kProblemTypes + kind},
          {"title", status_title(status)},
          {"status", status},
          {"detail", errors.empty() ? status_title(status) : errors.front().message},
          {"problems", std::move(problems)}};
}

}  // namespace coapt
