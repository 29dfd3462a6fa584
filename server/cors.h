// Pages of other sites that may use the service (Fetch standard, CORS protocol); access.h refuses all others.
#pragma once

#include <optional>

#include "server/access.h"

namespace coapt {

/// The answer to a browser that asks, before a request of a page from one of `access.origins`, whether it may be sent.
std::optional<Answer> answer_preflight(const Access& access, const Request& request);

/// `answer`, for the page that sent `request` to read.
Answer for_origin(const Access& access, const Request& request, Answer answer);

}  // namespace coapt
