#include "server/chunk_framing.h"

#include <algorithm>

#include "server/header_block.h"

namespace coapt {
namespace {

constexpr int kMaxDigits = 15;  // what 64 bits hold

/// -1: none
int hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

ChunkFraming::State ChunkFraming::after_size(char c) {
  const int digit = hexadecimal(c);
  if (digit < 0 && digits_ == 0) return State::Wrong;
  if (c == ';') return State::Extension;
  if (c == '\r') return State::SizeEnd;
  if (digit < 0 || digits_ == kMaxDigits) return State::Wrong;
  bytes_ = 16 * bytes_ + static_cast<std::uint64_t>(digit);
  ++digits_;
  return State::Size;
}

ChunkFraming::State ChunkFraming::after(char c) {
  const auto expect = [c](char wanted, State next) { return c == wanted ? next : State::Wrong; };
  switch (state_) {
    case State::Size:
      return after_size(c);
    case State::Extension:
      if (c == '\r') return State::SizeEnd;
      return is_control(c) ? State::Wrong : State::Extension;
    case State::SizeEnd:
      digits_ = 0;
      return expect('\n', bytes_ == 0 ? State::LastReturn : State::Data);
    case State::DataReturn:
      return expect('\r', State::DataEnd);
    case State::DataEnd:
      return expect('\n', State::Size);
    case State::LastReturn:
      return expect('\r', State::LastEnd);
    case State::LastEnd:
      return expect('\n', State::Ended);
    case State::Data:  // follow() skips it
    case State::Ended:
    case State::Wrong:
      break;
  }
  return State::Wrong;
}

bool ChunkFraming::follow(std::string_view bytes) {
  while (!bytes.empty() && state_ != State::Wrong) {
    if (state_ == State::Data) {
      const std::uint64_t skipped = std::min<std::uint64_t>(bytes_, bytes.size());
      bytes.remove_prefix(skipped);
      bytes_ -= skipped;
      if (bytes_ == 0) state_ = State::DataReturn;
    } else {
      state_ = after(bytes.front());
      bytes.remove_prefix(1);
    }
  }
  return state_ != State::Wrong;
}

}  // namespace coapt
