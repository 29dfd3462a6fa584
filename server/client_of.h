// Who a request is from, as far as the turns of clients go: nothing is allowed or refused by it.
#pragma once

#include <string>
#include <string_view>

namespace coapt {

/// The address at the other end of a socket: of IPv6 its network of 64 bits, which one client has; empty where there is none.
/// @param header of a request that a proxy of one's own has passed on: the last address in X-Forwarded-For, which that proxy has
/// added, counts instead; what stands before it anybody may have written. Empty: there is no proxy
std::string client_of(int socket, std::string_view header);

/// An address in the form that client_of() gives; empty if it is none.
std::string client_at(std::string_view address);

}  // namespace coapt
