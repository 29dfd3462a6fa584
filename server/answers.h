// Answers that several endpoints give.
#pragma once

#include "server/answer.h"

namespace coapt {

/// What a store or a farm says, with paths shortened to names: where files lie is no business of clients.
std::string without_folders(const std::string& message);

/// 503 for a store that is locked, 507 for a full disk, else 500.
Answer store_problem(const Errors& errors);
/// 429 or 503. @param seconds of Retry-After; 0: as every such answer has
Answer retry_later(int status, const std::string& why, int seconds = 0);
Answer not_found(const std::string& what);

}  // namespace coapt
