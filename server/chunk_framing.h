// The framing of a chunked body (RFC 9112, 7.1), followed byte by byte beside cpp-httplib, which reads sizes as strtoul
// does: signs, spaces, 0x.
#pragma once

#include <cstdint>
#include <string_view>

namespace coapt {

/// Sizes are 1 to 15 hexadecimal digits, extensions begin with a semicolon, lines end in CRLF, there are no trailers.
class ChunkFraming {
 public:
  /// The bytes that came next. False from the first that should not have come.
  bool follow(std::string_view bytes);

  bool has_ended() const { return state_ == State::Ended; }

 private:
  enum class State {
    Size,
    Extension,
    SizeEnd,
    Data,
    DataReturn,
    DataEnd,
    LastReturn,
    LastEnd,
    Ended,
    Wrong
  };

  State after(char c);
  State after_size(char c);

  State state_ = State::Size;
  int digits_ = 0;           // of the size
  std::uint64_t bytes_ = 0;  // of the chunk that are to come
};

}  // namespace coapt
