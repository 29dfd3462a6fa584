#include "client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <stdexcept>

namespace coapt {

Client::Client(int port, int receive_buffer_bytes) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  if (receive_buffer_bytes > 0) {
    setsockopt(socket_.number(), SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes, sizeof(int));
  }
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) !=
      0) {
    throw std::runtime_error("no connection");
  }
}

bool Client::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

void Client::half_close() const { shutdown(socket_.number(), SHUT_WR); }

void Client::reset() {
  const linger at_once = {1, 0};
  setsockopt(socket_.number(), SOL_SOCKET, SO_LINGER, &at_once, sizeof(at_once));
  socket_ = Descriptor();
}

std::string Client::receive(std::string_view part) const {
  std::string received;
  const Clock::time_point deadline = after(kHangSeconds);
  std::array<char, 1 << 14> bytes;
  while (part.empty() || received.find(part) == received.npos) {
    pollfd polled = {socket_.number(), POLLIN, 0};
    if (poll(&polled, 1, 1000) == 0) {
      if (Clock::now() > deadline) return received + "(hangs)";
      continue;
    }
    const ssize_t got = recv(socket_.number(), bytes.data(), bytes.size(), 0);
    if (got < 0) return received + "(reset)";
    if (got == 0) break;
    received.append(bytes.data(), static_cast<std::size_t>(got));
  }
  return received;
}

std::string Client::receive_all() const { return receive(""); }
std::string Client::receive_until(std::string_view part) const { return receive(part); }

std::string ask(int port, std::string_view bytes) {
  const Client client(port);
  client.send(bytes);
  return client.receive_all();
}

std::string ask_and_half_close(int port, std::string_view bytes) {
  const Client client(port);
  client.send(bytes);
  client.half_close();
  return client.receive_all();
}

std::string get(int port, const std::string& path, const std::string& fields) {
  return ask(port, "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n" + fields + "\r\n");
}

std::string post(int port, const std::string& path, const std::string& body) {
  return ask(port, "POST " + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Length: " +
                       std::to_string(body.size()) + "\r\n\r\n" + body);
}

int status_of(std::string_view answer) {
  return answer.starts_with("HTTP/1.1 ") ? std::stoi(std::string(answer.substr(9, 3))) : 0;
}

std::string body_of(const std::string& answer) {
  const std::size_t end = answer.find("\r\n\r\n");
  return end == answer.npos ? "" : answer.substr(end + 4);
}

}  // namespace coapt
