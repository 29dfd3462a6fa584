// A client that speaks in bytes, so that it can misbehave.
#pragma once

#include <string>
#include <string_view>

#include "server/connection.h"

namespace coapt {

/// How long a test waits for what must happen: against hanging, not a measure.
inline constexpr double kHangSeconds = 60.0;

class Client {
 public:
  explicit Client(int port, int receive_buffer_bytes = 0);

  bool send(std::string_view bytes) const;  ///< false: the server has closed
  void half_close() const;                  ///< nothing more will be sent
  void reset();                             ///< gone without a goodbye
  /// All until the server closes, "(hangs)" at the end if it does not.
  std::string receive_all() const;
  /// Until `part` has come; what has come.
  std::string receive_until(std::string_view part) const;

 private:
  std::string receive(std::string_view part) const;
  Descriptor socket_;
};

/// Sends, and receives all.
std::string ask(int port, std::string_view bytes);
std::string ask_and_half_close(int port, std::string_view bytes);
std::string get(int port, const std::string& path, const std::string& fields = "");
std::string post(int port, const std::string& path, const std::string& body);

int status_of(std::string_view answer);  ///< 0: there is none
std::string body_of(const std::string& answer);

}  // namespace coapt
