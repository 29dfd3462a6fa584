// Streams, and the end of the server.
#include <gtest/gtest.h>

#include "client.h"
#include "demo_server.h"

namespace coapt {
namespace {

const std::string kTicks = "GET /ticks HTTP/1.1\r\nHost: localhost\r\n\r\n";
const std::string kQuiet = "GET /quiet HTTP/1.1\r\nHost: localhost\r\n\r\n";

TEST(HttpStream, PartsComeAtOnceAndTheStreamEnds) {
  DemoServer server;
  const Client client(server.port());
  client.send(kTicks);
  EXPECT_NE(client.receive_until("data: tick\n\n").find("Content-Type: text/event-stream\r\n"),
            std::string::npos);
  const std::string part = "data: one of three\n\n";
  const std::string three = get(server.port(), "/three");
  EXPECT_EQ(body_of(three), part + part + part);
  EXPECT_EQ(three.find("Content-Length"), three.npos);
  EXPECT_EQ(body_of(ask(server.port(), "GET /three HTTP/1.0\r\nHost: localhost\r\n\r\n")),
            part + part + part);
}

TEST(HttpStream, OneTooManyIsRefusedUntilAClientGoes) {
  HttpLimits limits;
  limits.streams = 2;
  DemoServer server(limits);
  Client first(server.port()), second(server.port());
  first.send(kQuiet);
  second.send(kQuiet);
  EXPECT_TRUE(eventually([&] { return server.load().streams == 2; }));
  const std::string refused = get(server.port(), "/ticks");
  EXPECT_EQ(status_of(refused), 503);
  EXPECT_NE(refused.find("\r\nRetry-After: "), refused.npos);
  first.reset();
  EXPECT_TRUE(eventually([&] { return server.load().streams == 1; }));
  second.half_close();
  EXPECT_TRUE(eventually([&] { return server.load().streams == 0; }));
  EXPECT_EQ(status_of(get(server.port(), "/three")), 200);
  EXPECT_TRUE(eventually([&] { return server.exchanges()["GET /quiet 200"] == 2; }));
}

TEST(HttpStream, AClientThatDoesNotReadLosesIt) {
  HttpLimits limits;
  limits.answer_seconds = 0.2;
  DemoServer server(limits);
  const Client deaf(server.port(), 4096);
  deaf.send("GET /flood HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(eventually([&] { return server.exchanges()["GET /flood 200"] == 1; }));
  EXPECT_EQ(server.load().streams, 0);
}

TEST(Stop, StreamsEndAndRequestsInProgressAreFinished) {
  DemoServer server;
  const Client stream(server.port()), waiting(server.port()), dribbler(server.port());
  stream.send(kTicks);
  stream.receive_until("tick");
  dribbler.send("GET");
  waiting.send("GET /wait HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(eventually([&] { return server.load().requests == 2; }));
  server.stop();
  EXPECT_EQ(stream.receive_all().find("(hangs)"), std::string::npos);
  EXPECT_EQ(status_of(dribbler.receive_all()), 0);
  EXPECT_THROW(Client{server.port()}, std::runtime_error);
  EXPECT_FALSE(server.ended(0.0));
  server.open_latch();
  EXPECT_EQ(status_of(waiting.receive_all()), 200);
  EXPECT_TRUE(server.ended(kHangSeconds));
}

TEST(Stop, StuckClientsDoNotHoldItUp) {
  DemoServer server;
  const Client silent(server.port()), half_body(server.port()), deaf(server.port(), 4096),
      flooded(server.port(), 4096), lingering(server.port());
  half_body.send("POST /demo/a HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\nx");
  deaf.send("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
  flooded.send("GET /flood HTTP/1.1\r\nHost: localhost\r\n\r\n");
  lingering.send("GET /demo/a HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(
      eventually([&] { return server.load().connections == 5 && server.load().requests == 2; }));
  server.stop();
  // The limits of body and answer are 60 s.
  EXPECT_TRUE(server.ended(30.0));
}

TEST(Stop, MayComeBeforeTheBeginning) {
  const Routes routes;
  const Access access;
  HttpServer server({}, routes, access, [](const Exchange&) {});
  ASSERT_TRUE(server.bind("127.0.0.1", 0));
  server.stop();
  EXPECT_TRUE(server.run());
}

}  // namespace
}  // namespace coapt
