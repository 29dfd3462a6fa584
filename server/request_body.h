// What of a request's body can be told before it is read.
#pragma once

#include <optional>

#include "server/answer.h"
#include "server/header_block.h"

namespace coapt {

/// Why it cannot be taken: 400, 411, 413, 415.
std::optional<Answer> refuse_body(const HeaderBlock& header, std::size_t most_bytes);

Answer too_large(std::size_t most_bytes);  ///< 413

}  // namespace coapt
