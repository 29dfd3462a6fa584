#include "clients/live/haply_device.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "clients/live/haply_message.h"

namespace coapt {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience(5);         // for the service and its first state
constexpr std::chrono::milliseconds kSilence(1000);  // of a device that is lost

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

/// Runs within poll(): nothing waits, and no thread is needed. A force goes out for each state that came in, one at a time.
class HaplyConnection {
 public:
  explicit HaplyConnection(Address address) : address_(std::move(address)), socket_(io_) {}

  ~HaplyConnection() {
    if (!state_ || failure_) return;
    io_.restart();
    io_.run_for(std::chrono::milliseconds(20));  // a force that is on its way
    force_n_.setZero();
    unanswered_ = true;
    answer();
    io_.restart();
    io_.run_for(std::chrono::milliseconds(50));
    error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
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
    if (failure_) return failure_.message();
    return state_ ? "" : "no Inverse3 reported a place within 5 s";
  }

  const HaplyState& state() const { return *state_; }

  Expected<HaplyState> poll() {
    io_.restart();
    io_.poll();
    if (failure_) return Error{ErrorCode::InputOutput, "", "was lost: " + failure_.message()};
    if (Clock::now() - heard_ > kSilence)
      return Error{ErrorCode::InputOutput, "", "was lost: no state for 1 s"};
    return *state_;
  }

  void show(const Vec3& force_n) {
    force_n_ = force_n;
    answer();
  }

 private:
  void fail(error_code error) {
    if (!failure_) failure_ = error;
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
      heard_ = Clock::now();
      if (state) state_ = std::move(state);
      if (state_) unanswered_ = true;
      listen();
    });
  }

  void answer() {
    if (!unanswered_ || writing_ || failure_) return;
    unanswered_ = false;
    writing_ = true;
    sent_ = haply_force_message(state_->device_id, force_n_);
    socket_.async_write(asio::buffer(sent_), [this](error_code error, std::size_t) {
      writing_ = false;
      if (error) fail(error);
    });
  }

  Address address_;
  asio::io_context io_{1};
  beast::websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer received_;
  std::string sent_;
  std::optional<HaplyState> state_;
  Vec3 force_n_ = Vec3::Zero();
  Clock::time_point heard_ = Clock::now();
  bool unanswered_ = false, writing_ = false;
  error_code failure_;
};

}  // namespace

Expected<HapticDevice> connect_haply(const std::string& address, const Vec3& start_mm) {
  const std::optional<Address> parts = address_of(address);
  if (!parts)
    return Error{ErrorCode::OutOfRange, "", "is no address; must be like ws://localhost:10001"};
  const auto connection = std::make_shared<HaplyConnection>(*parts);
  if (const std::string problem = connection->connect(); !problem.empty())
    return Error{ErrorCode::InputOutput, "", "cannot be reached: " + problem};
  const Vec3 shift_mm = start_mm - connection->state().position_mm;
  return HapticDevice{[connection, shift_mm](double) -> Expected<StylusState> {
                        const Expected<HaplyState> state = connection->poll();
                        if (!state) return state.errors();
                        return StylusState{state->position_mm + shift_mm, state->button};
                      },
                      [connection](const Vec3& force_n) { connection->show(force_n); }};
}

}  // namespace coapt
