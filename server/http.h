// The one file that knows HTTP.
#pragma once

#include <atomic>
#include <cstddef>

#include "server/answer.h"

namespace coapt {

/// Largest body of a request.
inline constexpr std::size_t kMaxBodyBytes = std::size_t{64} << 20;

/// Serves on 127.0.0.1 until SIGINT or SIGTERM, which also sets `stopping`. Port 0 takes a free
/// one; the address is printed to standard error. Returns false if the port cannot be had.
/// @pre called before any thread is started, so that they all leave the two signals to it.
bool serve(int port, const Routes& routes, std::atomic<bool>& stopping);

}  // namespace coapt
