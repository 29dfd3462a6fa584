#include "server/cors.h"

namespace coapt {

std::optional<Answer> answer_preflight(const Access& access, const Request& request) {
  if (request.method != "OPTIONS" || !access.origins.contains(header(request, "origin")) ||
      !request.headers.contains("access-control-request-method"))
    return std::nullopt;
  return for_origin(
      access, request,
      {204,
       nullptr,
       {{"Access-Control-Allow-Methods", "GET, POST, PATCH, DELETE"},
        {"Access-Control-Allow-Headers",
         "Authorization, Content-Type, Idempotency-Key, If-None-Match, Last-Event-ID, Prefer"},
        {"Access-Control-Max-Age", "600"}}});
}

Answer for_origin(const Access& access, const Request& request, Answer answer) {
  if (access.origins.empty()) return answer;
  answer.headers.emplace_back("Vary", "Origin");
  const std::string origin = header(request, "origin");
  if (!access.origins.contains(origin)) return answer;
  answer.headers.emplace_back("Access-Control-Allow-Origin", origin);
  answer.headers.emplace_back("Access-Control-Expose-Headers",
                              "Coapt-Closure, Coapt-Notice, ETag, Location, Retry-After");
  return answer;
}

}  // namespace coapt
