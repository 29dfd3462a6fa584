// Answers that several endpoints give.
#pragma once

#include "server/answer.h"

namespace coapt {

inline constexpr int kRetrySeconds = 10;  ///< after which a refused client may try again

/// 503 with Retry-After for a store that is locked, 507 for a full disk, else 500.
Answer store_problem(const Errors& errors);
/// With Retry-After.
Answer retry_later(int status, const std::string& why);
Answer not_found(const std::string& what);

}  // namespace coapt
