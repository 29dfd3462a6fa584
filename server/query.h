// Parameters of a request's query, and of headers that take their place.
#pragma once

#include <cstdint>

#include "core/valve/problem_list.h"
#include "server/route.h"

namespace coapt {

/// An integer of the query; `otherwise` if it is not there. What is no integer or out of range is a problem, with
/// "?NAME" for a path.
std::int64_t integer_in(const Request& request, const char* name, Range range,
                        std::int64_t otherwise, ProblemList& problems);

/// Every parameter that is not among `known` is a problem.
void check_query(const Request& request, std::initializer_list<const char*> known,
                 ProblemList& problems);

}  // namespace coapt
