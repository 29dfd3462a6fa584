// From a method and a path to the endpoint that answers them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/answer.h"

namespace coapt {

struct Request {
  std::string method;  ///< "GET" also for HEAD
  std::string path;    ///< percent-decoded, without the query
  std::map<std::string, std::string> query;
  std::map<std::string, std::string> headers;  ///< names in lower case; the first of each
  std::string body;
  std::vector<std::string> parameters;  ///< what the {...} of the route matched, in order
  std::string client =
      {};  ///< who asks, as far as turns go (client_of()); all alike where it is empty
  /// Whether nobody waits for the answer any more; empty: somebody does.
  std::function<bool()> abandoned = {};
};

/// The value of a header; empty if it is not there. @param name in lower case
std::string header(const Request& request, const std::string& name);

/// From a request to its answer; from many threads at once.
using Endpoint = std::function<Answer(const Request&)>;

struct Route {
  std::string_view method;
  std::string_view path;  ///< {NAME} stands for one or more characters up to the next '/' or ':'
  Endpoint endpoint;
  bool takes_form = false;  ///< also multipart/form-data, handed over as it came
};
using Routes = std::vector<Route>;

/// The parameters if `path` is of the kind `pattern`; else none.
std::optional<std::vector<std::string>> match(std::string_view pattern, std::string_view path);

struct Found {
  const Route* route = nullptr;  ///< the first that fits; null: `refusal` says why, 404 or 405
  std::vector<std::string> parameters;
  Answer refusal;
};
Found find_route(const Routes& routes, const Request& request);

}  // namespace coapt
