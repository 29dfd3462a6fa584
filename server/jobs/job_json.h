// A job as its clients read it.
#pragma once

#include "server/jobs/job_board.h"

namespace coapt {

/// The job resource (server/openapi.json, schema Job). @param results with what an ended job has come to.
Json to_json(const JobView& view, bool results);

/// RFC 3339 in UTC with milliseconds; null for 0.
Json time_json(std::int64_t ms);

}  // namespace coapt
