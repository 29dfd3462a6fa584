// What an endpoint answers, before HTTP.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/valve/types.h"
#include "io/json/json.h"

namespace coapt {

inline constexpr const char* kHtmlType = "text/html; charset=utf-8";
inline constexpr const char* kCsvType = "text/csv; charset=utf-8";

/// Bytes of some other kind than JSON.
struct Content {
  std::string type;  ///< "image/png", "text/html; charset=utf-8"
  std::string bytes;
};

/// Sends a part of a stream at once; false when the client is gone.
using Send = std::function<bool(std::string_view)>;

/// An answer without an end known beforehand. `next` is called again and again until it returns false,
/// the client is gone or the server stops; it waits for something to send, a second at most.
struct Stream {
  std::string type;
  std::function<bool(const Send&)> next;
};

using Headers = std::vector<std::pair<std::string, std::string>>;

struct Answer {
  int status = 200;                               ///< HTTP status
  std::variant<Json, Content, Stream> body = {};  ///< null: none
  Headers headers = {};  ///< besides those that all have, or instead of them
};

/// A JSON object of the service's own: with the research-only notice in it.
Answer json_answer(int status, Json object);

/// problem_json() of the errors.
Answer problem(int status, const Errors& errors);
Answer problem(int status, ErrorCode code, const std::string& message);

std::string content_type(const Answer& answer);  ///< empty: no content
std::string content_bytes(
    const Answer& answer);  ///< what is no UTF-8 in JSON is replaced; of a stream none
/// Its own headers and those that every answer has, but type and length.
Headers all_headers(const Answer& answer);
/// The whole of a refusal as HTTP/1.1, connection closed after it.
std::string as_http(const Answer& answer);

}  // namespace coapt
