#include "server/client_of.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cstring>
#include <optional>

#include "server/header_block.h"

namespace coapt {
namespace {

std::string bytes_of(const void* from, std::size_t size) {
  return std::string(static_cast<const char*>(from), size);
}

/// An IPv4 address that is written as one of IPv6 (RFC 4291, 2.5.5.2) is that of IPv4.
std::string network_of(const in6_addr& address) {
  if (IN6_IS_ADDR_V4MAPPED(&address)) return bytes_of(address.s6_addr + 12, 4);
  return bytes_of(address.s6_addr, 8);
}

std::string peer_of(int socket) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &size) != 0) return "";
  if (peer.ss_family == AF_INET6) {
    sockaddr_in6 six{};
    std::memcpy(&six, &peer, sizeof six);
    return network_of(six.sin6_addr);
  }
  if (peer.ss_family != AF_INET) return "";
  sockaddr_in four{};
  std::memcpy(&four, &peer, sizeof four);
  return bytes_of(&four.sin_addr, sizeof four.sin_addr);
}

}  // namespace

std::string client_at(std::string_view address) {
  const std::string text(address);
  in_addr four{};
  in6_addr six{};
  if (inet_pton(AF_INET, text.c_str(), &four) == 1) return bytes_of(&four, sizeof four);
  return inet_pton(AF_INET6, text.c_str(), &six) == 1 ? network_of(six) : "";
}

std::string client_of(int socket, std::string_view header) {
  if (const std::optional<HeaderBlock> block =
          header.empty() ? std::nullopt : parse_header(header)) {
    const std::string passed = field(*block, "x-forwarded-for");
    const std::string_view last = std::string_view(passed).substr(passed.rfind(',') + 1);
    if (std::string client = client_at(without_ows(last)); !client.empty()) return client;
  }
  return peer_of(socket);
}

}  // namespace coapt
