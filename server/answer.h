// What an endpoint answers, before HTTP.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/valve/types.h"

namespace coapt {

struct Answer {
  int status = 200;  ///< HTTP status
  nlohmann::ordered_json body;
};

/// An endpoint: from the body of a request to its answer.
using Endpoint = std::function<Answer(std::string_view body)>;

struct Route {
  std::string_view method, path;
  Endpoint endpoint;
};
using Routes = std::vector<Route>;

/// {"status", "title", "problems": [{"code", "path", "message"}]}; paths point into the request
/// body.
Answer problem(int status, const Errors& errors);

}  // namespace coapt
