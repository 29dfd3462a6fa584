#pragma once

#include "server/answer.h"

namespace coapt {

/// GET /healthz/live: the process answers.
struct GetHealthzLive {
  Answer operator()(std::string_view /*body*/) const { return {200, {{"status", "live"}}}; }
};

}  // namespace coapt
