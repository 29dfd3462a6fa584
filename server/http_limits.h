// What clients may ask of the server's threads and memory.
#pragma once

#include <cstddef>

namespace coapt {

struct HttpLimits {
  std::size_t header_bytes = 16 << 10;            ///< request line and headers
  std::size_t body_bytes = std::size_t{8} << 20;  ///< counted as they arrive, chunked or not
  double header_seconds = 10.0;                   ///< from the connection to the end of the headers
  double body_seconds = 60.0;  ///< from the first thread that is free to the end of the body
  double body_bytes_per_second = 16 << 10;  ///< at least, after two seconds
  double answer_seconds = 60.0;  ///< for the client to take the answer; for each part of a stream
  int connections =
      1024;  ///< at once; those over it push out the one that waits longest for its headers
  int requests =
      128;  ///< answered at once, streams among them, the others wait; with a body, half as many
  int streams = 32;           ///< open at once, over it 503
  bool behind_proxy = false;  ///< clients are told apart by the last address in X-Forwarded-For
};

}  // namespace coapt
