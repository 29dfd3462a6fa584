// What a request is refused with: problem details (RFC 9457).
#pragma once

#include "core/valve/types.h"
#include "io/json/json.h"

namespace coapt {

const char* status_title(int status);  ///< of an HTTP status, as the service says it

/// {"type", "title", "status", "detail", "problems": [{"code", "path", "message"}]}; paths point into the request's body.
Json problem_json(int status, const Errors& errors);

}  // namespace coapt
