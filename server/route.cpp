#include "server/route.h"

#include <algorithm>

namespace coapt {

std::optional<std::vector<std::string>> match(std::string_view pattern, std::string_view path) {
  std::vector<std::string> parameters;
  while (!pattern.empty()) {
    if (pattern.front() == '{') {
      const std::size_t length = std::min(path.find_first_of("/:"), path.size());
      if (length == 0) return std::nullopt;
      parameters.emplace_back(path.substr(0, length));
      path.remove_prefix(length);
      pattern.remove_prefix(pattern.find('}') + 1);
    } else {
      const std::size_t length = std::min(pattern.find('{'), pattern.size());
      if (!path.starts_with(pattern.substr(0, length))) return std::nullopt;
      path.remove_prefix(length);
      pattern.remove_prefix(length);
    }
  }
  if (!path.empty()) return std::nullopt;
  return parameters;
}

Found find_route(const Routes& routes, const Request& request) {
  std::string allowed;
  for (const Route& route : routes) {
    auto parameters = match(route.path, request.path);
    if (!parameters) continue;
    if (route.method == request.method) return {&route, *std::move(parameters), {}};
    allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
    if (route.method == "GET") allowed += ", HEAD";
  }
  if (allowed.empty()) return {nullptr, {}, problem(404, ErrorCode::BadReference, "no such path")};
  Answer refusal = problem(405, ErrorCode::Unsupported, "this path accepts " + allowed);
  refusal.headers.emplace_back("Allow", allowed);
  return {nullptr, {}, std::move(refusal)};
}

std::string header(const Request& request, const std::string& name) {
  const auto found = request.headers.find(name);
  return found == request.headers.end() ? "" : found->second;
}

}  // namespace coapt
