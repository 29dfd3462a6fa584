// cpp-httplib behind one function: it reads the request line, decodes the body and lays the answer out. No other file
// of the server includes it.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "server/route.h"

namespace coapt {

/// What the library reads and writes in place of a socket.
struct Wire {
  std::string header;  ///< request line and length of the body; nothing else of the header
  std::function<std::size_t(char*, std::size_t)> read;  ///< of the body, as sent; 0: no more
  std::function<bool(std::string_view)> send;           ///< of a stream; false: the client is gone
  std::function<bool()> wants_more;  ///< false: a stream is to end, nobody waits for it
};

/// Hands over the body, decoded, in parts until `take` returns false; whether it came whole.
using ReadBody = std::function<bool(const std::function<bool(std::string_view)>& take)>;

/// From a request with method (as sent), path and query alone, and what reads its body, to the answer. What it throws
/// is answered with 500.
using Serve = std::function<Answer(Request, const ReadBody&)>;

struct Served {
  int status = 0;
  std::string unsent;  ///< the answer as HTTP/1.1; empty for a stream, which has been sent
};

/// One request, from its header to the end of its answer.
Served serve_request(const Wire& wire, const Serve& serve);

}  // namespace coapt
