#include "server/listening.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <memory>

namespace coapt {
namespace {

constexpr int kBacklog = 1024;  // bursts would wait for a second else

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses addresses_of(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) found = nullptr;
  return {found, freeaddrinfo};
}

/// None (-1) if it cannot be listened on.
Descriptor socket_at(const addrinfo& address) {
  Descriptor made(
      socket(address.ai_family, address.ai_socktype | SOCK_CLOEXEC, address.ai_protocol));
  const int yes = 1, no = 0;
  setsockopt(made.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  if (address.ai_family == AF_INET6)
    setsockopt(made.number(), IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof(no));
  if (bind(made.number(), address.ai_addr, address.ai_addrlen) == 0 &&
      listen(made.number(), kBacklog) == 0)
    return made;
  return Descriptor();
}

int port_of(const Descriptor& socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof(address);
  getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6*>(&address)->sin6_port
                                             : reinterpret_cast<sockaddr_in*>(&address)->sin_port);
}

}  // namespace

Expected<Listening> listen_on(const std::string& host, int port) {
  const Addresses addresses = addresses_of(host, port);
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    Descriptor socket = socket_at(*address);
    if (socket.number() < 0) continue;
    const int bound = port_of(socket);
    return Listening{std::move(socket), bound};
  }
  return Error{ErrorCode::InputOutput, "", "cannot listen on " + host + ':' + std::to_string(port)};
}

}  // namespace coapt
