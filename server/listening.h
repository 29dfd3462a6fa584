// The socket that clients connect to.
#pragma once

#include <string>

#include "core/valve/types.h"
#include "server/connection.h"

namespace coapt {

struct Listening {
  Descriptor socket;
  int port = 0;
};

/// @param host an address, or a name for one; @param port 0 takes a free one
Expected<Listening> listen_on(const std::string& host, int port);

}  // namespace coapt
