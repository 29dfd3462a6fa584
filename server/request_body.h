// The body of a request: what can be told before it is read, and reading it within limits.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "server/answer.h"
#include "server/chunk_framing.h"
#include "server/connection.h"
#include "server/header_block.h"
#include "server/http_limits.h"
#include "server/httplib_adapter.h"

namespace coapt {

/// Why it cannot be taken: 400, 411, 413, 415.
std::optional<Answer> refuse_body(const HeaderBlock& header, std::size_t most_bytes,
                                  bool takes_form);

/// A body on its way.
struct BodySource {
  Connection& connection;
  const HeaderBlock& header;
  ReadBody decoded = {};      ///< reads by take()
  ChunkFraming framing = {};  ///< of a chunked one

  /// As sent; 0: there are no more, or the framing is wrong.
  std::size_t take(char* to, std::size_t size);
};

/// Appends it to `body`. Else why not: 400, 408, 413, 503.
std::optional<Answer> read_body(BodySource& source, const HttpLimits& limits, std::string& body);

}  // namespace coapt
