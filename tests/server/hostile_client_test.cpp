// Clients that dribble, stop, lie and go away, and what becomes of the others meanwhile.
#include <gtest/gtest.h>

#include <thread>

#include "client.h"
#include "demo_server.h"

namespace coapt {
namespace {

const std::string kPost = "POST /demo/a HTTP/1.1\r\nHost: localhost\r\n";
const std::string kChunked = kPost + "Transfer-Encoding: chunked\r\n\r\n";

HttpLimits small() {
  HttpLimits limits;
  limits.header_bytes = 1024;
  limits.body_bytes = 100000;
  limits.requests = 4;
  return limits;
}

/// For requests that never come whole; a busy machine would be too slow for any other.
HttpLimits impatient() {
  HttpLimits limits = small();
  limits.header_seconds = 0.3;
  limits.body_seconds = 0.5;
  return limits;
}

TEST(HostileClient, DribbledHeadersStopNobody) {
  HttpLimits limits;
  limits.requests = 4;
  DemoServer server(limits);
  std::vector<Client> dribblers;
  for (int i = 0; i < 300; ++i) {
    dribblers.emplace_back(server.port());
    dribblers.back().send("GET /demo/a HTTP/1.1\r\nX-");
  }
  for (const Client& dribbler : dribblers) dribbler.send("a");
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
  EXPECT_TRUE(eventually([&] { return server.load().requests == 0; }));
  dribblers.front().send(": 1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(status_of(dribblers.front().receive_all()), 200);
}

TEST(HostileClient, TheOneThatHasWaitedLongestIsPushedOut) {
  HttpLimits limits;
  limits.connections = 10;
  DemoServer server(limits);
  std::vector<Client> waiting;
  for (int i = 0; i < 10; ++i) {
    waiting.emplace_back(server.port());
    waiting.back().send("GET");
  }
  EXPECT_TRUE(eventually([&] { return server.load().connections == 10; }));
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
  const std::string pushed_out = waiting.front().receive_all();
  EXPECT_EQ(status_of(pushed_out), 503);
  EXPECT_NE(pushed_out.find("\r\nRetry-After: "), pushed_out.npos);
  EXPECT_EQ(Json::parse(body_of(pushed_out))["status"], 503);
  waiting.back().send(" /demo/a HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(status_of(waiting.back().receive_all()), 200);
}

TEST(HostileClient, WithoutRoomTheNewOneIsRefused) {
  HttpLimits limits;
  limits.connections = limits.requests = 2;
  DemoServer server(limits);
  const std::string wait = "GET /wait HTTP/1.1\r\nHost: localhost\r\n\r\n";
  const Client first(server.port()), second(server.port());
  first.send(wait);
  second.send(wait);
  EXPECT_TRUE(eventually([&] { return server.load().requests == 2; }));
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 503);
  server.open_latch();
  EXPECT_EQ(status_of(first.receive_all()), 200);
  EXPECT_EQ(status_of(second.receive_all()), 200);
}

TEST(HostileClient, HeadersTooLargeAreRefused) {
  DemoServer server(small());
  EXPECT_EQ(status_of(get(server.port(), "/demo/a", "X: " + std::string(2000, 'x') + "\r\n")), 431);
  EXPECT_EQ(status_of(ask(server.port(), std::string(100000, 'x'))), 431);
  EXPECT_EQ(status_of(get(server.port(), "/demo/a", "X: " + std::string(800, 'x') + "\r\n")), 200);
  EXPECT_EQ(server.exchanges()["other none 431"], 2);
}

TEST(HostileClient, HeadersThatDoNotComeAreTooSlow) {
  DemoServer server(impatient());
  EXPECT_EQ(status_of(ask(server.port(), "GET /demo/a HTTP/1.1\r\n")), 408);
  EXPECT_EQ(status_of(ask(server.port(), "")), 408);
  EXPECT_EQ(server.exchanges()["other none 408"], 2);
}

TEST(HostileClient, WhoHasClosedItsHalfGetsItsAnswer) {
  DemoServer server;
  const Client whole(server.port()), part(server.port());
  whole.send(kPost + "Content-Length: 3\r\n\r\nabc");
  whole.half_close();
  EXPECT_EQ(status_of(whole.receive_all()), 200);
  part.send("GET /demo/a HTT");
  part.half_close();
  EXPECT_EQ(status_of(part.receive_all()), 400);
  const Client waiting(server.port());
  waiting.send("GET /wait HTTP/1.1\r\nHost: localhost\r\n\r\n");
  waiting.half_close();
  server.open_latch();
  EXPECT_EQ(status_of(waiting.receive_all()), 200);
}

TEST(HostileClient, BodiesOverTheLimitAreRefusedHoweverTheyCome) {
  DemoServer server(small());
  EXPECT_EQ(status_of(ask(server.port(), kPost + "Content-Length: 100001\r\n\r\n")), 413);
  EXPECT_EQ(status_of(post(server.port(), "/demo/a", std::string(200000, 'x'))), 413);
  EXPECT_EQ(status_of(post(server.port(), "/demo/a", std::string(100000, 'x'))), 200);
  EXPECT_EQ(status_of(ask(server.port(),
                          kChunked + "186A0\r\n" + std::string(100000, 'x') + "\r\n0\r\n\r\n")),
            200);
  EXPECT_EQ(status_of(ask(server.port(),
                          kChunked + "186A1\r\n" + std::string(100001, 'x') + "\r\n0\r\n\r\n")),
            413);
  // Nothing but a chunk's header.
  EXPECT_EQ(status_of(ask(server.port(), kChunked + "1;" + std::string(1 << 20, 'x'))), 413);
}

TEST(HostileClient, BodiesThatEndEarlyAreBadOnes) {
  DemoServer server(small());
  for (const std::string& request :
       {kPost + "Content-Length: 5\r\n\r\nabc", kChunked + "5\r\nabc", kChunked}) {
    EXPECT_EQ(status_of(ask_and_half_close(server.port(), request)), 400) << request;
  }
}

TEST(HostileClient, BodiesThatDoNotComeAreTooSlow) {
  DemoServer server(impatient());
  EXPECT_EQ(status_of(ask(server.port(), kPost + "Content-Length: 5\r\n\r\nabc")), 408);
  EXPECT_EQ(status_of(ask(server.port(), kChunked + "5\r\nabc")), 408);
}

TEST(HostileClient, BodiesThatDribbleAreTooSlow) {
  HttpLimits limits;
  limits.requests = 2;
  DemoServer server(limits);
  const Client client(server.port());
  client.send(kPost + "Content-Length: 100000\r\n\r\n");
  std::jthread dribble([&](const std::stop_token& stop) {
    while (!stop.stop_requested() && client.send("x"))
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  });
  EXPECT_TRUE(eventually([&] { return server.load().requests == 1; }));
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
  EXPECT_EQ(status_of(client.receive_until("\r\n\r\n")), 408);
}

TEST(HostileClient, WrongChunksAreBadOnes) {
  DemoServer server(small());
  for (const char* chunks :
       {"x\r\n", "-1\r\nabc", "ffffffffffffffffffff\r\nabc", "3\r\nabcdef\r\n0\r\n\r\n",
        "0\r\nnot the end\r\n\r\n", "\r\n\r\n", "0x3\r\nabc\r\n0\r\n\r\n", "+3\r\nabc\r\n0\r\n\r\n",
        "3 x\r\nabc\r\n0\r\n\r\n"}) {
    EXPECT_EQ(status_of(ask(server.port(), kChunked + chunks)), 400) << chunks;
  }
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
}

TEST(HostileClient, ARefusedBodyIsNotTheNextRequest) {
  DemoServer server(small());
  const std::string inner = "GET /demo/smuggled HTTP/1.1\r\nHost: localhost\r\n\r\n";
  const std::string length = "Content-Length: " + std::to_string(inner.size()) + "\r\n\r\n";
  for (const std::string& outer : {"POST /none HTTP/1.1\r\nHost: localhost\r\n" + length,
                                   "GET /demo/a HTTP/1.1\r\nHost: localhost\r\n" + length,
                                   "DELETE /demo/a HTTP/1.1\r\nHost: localhost\r\n" + length,
                                   kPost + "Content-Encoding: br\r\n" + length}) {
    const std::string answer = ask(server.port(), outer + inner);
    EXPECT_NE(status_of(answer), 0);
    EXPECT_EQ(answer.find("HTTP/1.1", 1), answer.npos) << answer;
    EXPECT_EQ(answer.find("smuggled"), answer.npos) << answer;
  }
}

TEST(HostileClient, ARefusalReachesAClientThatSendsItsWholeBodyFirst) {
  DemoServer server(small());
  const Client client(server.port());
  EXPECT_TRUE(client.send(kPost + "Content-Length: 8000000\r\n\r\n"));
  EXPECT_TRUE(client.send(std::string(8000000, 'x')));
  EXPECT_EQ(status_of(client.receive_all()), 413);
}

TEST(HostileClient, AnswersThatNobodyTakesHoldNoThread) {
  HttpLimits limits;
  limits.requests = 2;
  DemoServer server(limits);
  std::vector<Client> deaf;
  for (int i = 0; i < 6; ++i) {
    deaf.emplace_back(server.port(), 4096);
    deaf.back().send("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  EXPECT_TRUE(eventually([&] { return server.exchanges()["GET /large 200"] == 6; }));
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
  EXPECT_EQ(body_of(deaf.back().receive_all()).size(), std::size_t{32} << 20);
}

TEST(HostileClient, TheOldestAnswerThatNobodyTakesIsDroppedWhenTheyAreTooMany) {
  DemoServer server;
  std::vector<Client> deaf;
  for (int i = 0; i < 12; ++i) {
    deaf.emplace_back(server.port(), 4096);
    deaf.back().send("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  EXPECT_TRUE(eventually([&] { return server.exchanges()["GET /large 200"] == 12; }));
  EXPECT_TRUE(eventually([&] { return server.load().connections <= 8; }));
}

TEST(HostileClient, ThoseThatGoAwayLeaveNothing) {
  DemoServer server;
  for (int i = 0; i < 10; ++i) {
    for (const std::string& sent :
         {std::string(), std::string("GET /de"), kPost + "Content-Length: 9\r\n\r\nx",
          std::string("GET /large HTTP/1.1\r\nHost: localhost\r\n\r\n")}) {
      Client client(server.port());
      client.send(sent);
      if (i % 2 == 0) client.reset();
    }
  }
  EXPECT_TRUE(
      eventually([&] { return server.load().connections == 0 && server.load().requests == 0; }));
}

}  // namespace
}  // namespace coapt
