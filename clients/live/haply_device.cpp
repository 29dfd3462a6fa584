#include "clients/live/haply_device.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "clients/live/haply_message.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience(5);         // for the service and its first state
constexpr std::chrono::milliseconds kSilence(1000);  // of a device that is lost
constexpr std::chrono::milliseconds kFarewell(50);   // for the last force and the end of the talk
constexpr std::size_t kLargestMessage = 64 << 10;    // bytes; a state has some hundred
// A state in and a force out take about 5; more are left to the next period, so that no service can hold up the loop.
constexpr int kMostHandlers = 16;

std::string no_place() {
  return "no Inverse3 reported a place from " + shown(-kFarthest_mm) + " to " +
         shown(kFarthest_mm) + " mm";
}

struct Address {
  std::string host, port, path;
};

/// ws://HOST:PORT or ws://HOST:PORT/PATH.
std::optional<Address> address_of(const std::string& text) {
  if (!text.starts_with("ws://")) return std::nullopt;
  const std::string rest = text.substr(5);
  const std::size_t slash = std::min(rest.find('/'), rest.size());
  const std::size_t colon = rest.rfind(':', slash);
  if (colon == std::string::npos || colon == 0 || colon + 1 >= slash) return std::nullopt;
  return Address{rest.substr(0, colon), rest.substr(colon + 1, slash - colon - 1),
                 slash < rest.size() ? rest.substr(slash) : "/"};
}

/// Closes at once where Beast would first read all that the other side still sends, however much that is.
struct Socket : beast::tcp_stream {
  using beast::tcp_stream::tcp_stream;
};

template <class Handler>
void async_teardown(beast::role_type, Socket& socket, Handler&& handler) {
  error_code error;
  socket.socket().close(error);
  asio::post(socket.get_executor(),
             beast::bind_front_handler(std::forward<Handler>(handler), error));
}

/// Runs within poll(): nothing waits, and no thread is needed. Forces go out one at a time.
class HaplyConnection {
 public:
  explicit HaplyConnection(Address address) : address_(std::move(address)), socket_(io_) {
    socket_.read_message_max(kLargestMessage);
  }

  /// Waits until the last force is out.
  ~HaplyConnection() {
    if (!state_ || failure_) return;
    const auto end = Clock::now() + kFarewell;
    io_.restart();
    while ((unsent_ || writing_) && !failure_ && Clock::now() < end) io_.run_one_until(end);
    if (failure_) return;
    socket_.async_close(beast::websocket::close_code::normal, [](error_code) {});
    io_.run_for(kFarewell);
  }
  HaplyConnection(const HaplyConnection&) = delete;
  HaplyConnection& operator=(const HaplyConnection&) = delete;

  /// Until the first state; "" or what went wrong.
  std::string connect() {
    error_code failed;
    asio::ip::tcp::resolver resolver(io_);
    const auto hosts = resolver.resolve(address_.host, address_.port, failed);
    if (failed) return failed.message();
    beast::get_lowest_layer(socket_).expires_after(kPatience);
    beast::get_lowest_layer(socket_).async_connect(
        hosts, [this](error_code error, const auto&) { error ? fail(error) : shake_hands(); });
    const auto end = Clock::now() + kPatience;
    while (!state_ && !failure_ && Clock::now() < end) io_.run_one_for(kSilence);
    if (failure_) return reason();
    return state_ ? "" : no_place() + " within 5 s";
  }

  const HaplyState& state() const { return *state_; }

  /// In the device's frame.
  Expected<StylusState> poll() {
    io_.restart();
    for (int run = 0; run < kMostHandlers && io_.poll_one() > 0; ++run) {
    }
    if (failure_) return Error{ErrorCode::InputOutput, "", "was lost: " + reason()};
    if (Clock::now() - heard_ > kSilence)
      return Error{ErrorCode::InputOutput, "", "was lost: " + no_place() + " for 1 s"};
    return StylusState{state_->position_mm, state_->button, false, std::exchange(fresh_, false)};
  }

  void show(const Vec3& force_n) {
    force_n_ = force_n;
    unsent_ = true;
    send();
  }

 private:
  void fail(error_code error) {
    if (!failure_) failure_ = error;
  }

  std::string reason() const {
    return failure_ == beast::websocket::error::message_too_big
               ? "a message of the service has more than 64 KiB"
               : failure_.message();
  }

  void shake_hands() {
    beast::get_lowest_layer(socket_).expires_never();
    beast::get_lowest_layer(socket_).socket().set_option(asio::ip::tcp::no_delay(true));
    socket_.set_option(beast::websocket::stream_base::timeout{
        kPatience, beast::websocket::stream_base::none(), false});
    socket_.async_handshake(address_.host + ':' + address_.port, address_.path,
                            [this](error_code error) { error ? fail(error) : listen(); });
  }

  void listen() {
    socket_.async_read(received_, [this](error_code error, std::size_t) {
      if (error) return fail(error);
      const auto bytes = received_.cdata();
      auto state = read_haply_state({static_cast<const char*>(bytes.data()), bytes.size()});
      received_.clear();
      if (state) {
        state_ = std::move(state);
        fresh_ = true;
        heard_ = Clock::now();
      }
      listen();
    });
  }

  void send() {
    if (!unsent_ || writing_ || failure_) return;
    unsent_ = false;
    writing_ = true;
    sent_ = haply_force_message(state_->device_id, force_n_);
    socket_.async_write(asio::buffer(sent_), [this](error_code error, std::size_t) {
      writing_ = false;
      if (error) return fail(error);
      send();
    });
  }

  Address address_;
  asio::io_context io_{1};
  beast::websocket::stream<Socket> socket_;
  beast::flat_buffer received_;
  std::string sent_;
  std::optional<HaplyState> state_;
  Vec3 force_n_ = Vec3::Zero();
  Clock::time_point heard_ = Clock::now();
  bool fresh_ = false;  // state_ was not read yet
  bool unsent_ = false, writing_ = false;
  error_code failure_;
};

}  // namespace

Expected<HapticDevice> connect_haply(const std::string& address, const Vec3& start_mm) {
  const std::optional<Address> parts = address_of(address);
  if (!parts)
    return Error{ErrorCode::OutOfRange, "", "is not an address; must have the form ws://HOST:PORT"};
  const auto connection = std::make_shared<HaplyConnection>(*parts);
  if (const std::string problem = connection->connect(); !problem.empty())
    return Error{ErrorCode::InputOutput, "", "cannot be reached: " + problem};
  const Vec3 shift_mm = start_mm - connection->state().position_mm;
  return HapticDevice{[connection, shift_mm](double) -> Expected<StylusState> {
                        Expected<StylusState> state = connection->poll();
                        if (state) state->position_mm += shift_mm;
                        return state;
                      },
                      [connection](const Vec3& force_n) { connection->show(force_n); }};
}

}  // namespace coapt
