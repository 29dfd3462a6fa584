// Who gets in. A page in a browser of this machine may send requests to 127.0.0.1, too: so without a
// token a request must be addressed to this very server (Host, against DNS rebinding), and with or
// without one it must not come from a page of another origin (Origin).
#pragma once

#include <optional>
#include <set>
#include <string>

#include "server/route.h"

namespace coapt {

struct Access {
  std::string token = {};  ///< empty: none is asked for
  /// Names, without port, that Host may say besides localhost, 127.0.0.1, [::1].
  std::set<std::string> hosts = {};
  /// Of other sites whose pages may send requests: "https://plans.example".
  std::set<std::string> origins = {};
};

/// The first line of a file, without what is blank around it: 16 to 4,096 visible ASCII characters. The
/// file must belong to this user or root and be closed to all others but root's group.
Expected<std::string> read_token(const std::string& path);

/// Of a service that was given none, but needs one: read there, or, the first time, made and written for this user alone.
Expected<std::string> kept_token(const std::string& path);

/// The answer to a request that does not get in: 401, 403 or 421. /healthz/live is open to all, the files of the page
/// to all who call this server by its name.
/// The time it takes says nothing of the token but its length.
std::optional<Answer> refuse(const Access& access, const Request& request);

/// Whether only this machine can reach an address: localhost, 127.0.0.0/8, ::1.
bool is_loopback(const std::string& host);

}  // namespace coapt
