#include "server/http.h"

#include <gtest/gtest.h>

#include <thread>

#include "client.h"
#include "demo_server.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json json_of(const std::string& answer) { return Json::parse(body_of(answer)); }

bool has(const std::string& answer, const std::string& text) {
  return answer.find(text) != answer.npos;
}

TEST(Http, ARequestReachesItsEndpoint) {
  DemoServer server;
  const auto answer = json_of(get(server.port(), "/demo/a%20b?x=1&y=%2B&x=2"));
  EXPECT_EQ(answer["name"], "a b");
  EXPECT_EQ(answer["query"], (Json{{"x", "1"}, {"y", "+"}}));
  EXPECT_EQ(answer["notice"], kResearchNotice);
  EXPECT_EQ(json_of(post(server.port(), "/demo/a", std::string(100000, 'x')))["bytes"], 100000);
  EXPECT_EQ(json_of(post(server.port(), "/demo/a", ""))["bytes"], 0);
}

TEST(Http, AnswersHaveTheHeadersOfAllAnswers) {
  DemoServer server;
  for (const std::string& answer :
       {get(server.port(), "/demo/a"), get(server.port(), "/none"), get(server.port(), "/throws"),
        get(server.port(), "/three"), ask(server.port(), "BREW / HTTP/1.1\r\n\r\n"),
        ask(server.port(), "x\r\nnonsense\r\n\r\n"),
        ask_and_half_close(server.port(), "half a header"),
        ask(server.port(), "DELETE /demo/a HTTP/1.1\r\nHost: localhost\r\n\r\n")}) {
    for (const char* line :
         {"\r\nCoapt-Notice: coapt is research", "\r\nX-Content-Type-Options: nosniff\r\n",
          "\r\nCache-Control: no-store\r\n",
          "\r\nContent-Security-Policy: default-src 'none'; frame-ancestors 'none'\r\n",
          "\r\nReferrer-Policy: no-referrer\r\n",
          "\r\nCross-Origin-Resource-Policy: same-origin\r\n", "\r\nConnection: close\r\n"}) {
      EXPECT_TRUE(has(answer, line)) << line << " in " << answer;
    }
    EXPECT_FALSE(has(answer, "Access-Control-")) << answer;
    EXPECT_FALSE(has(answer, "Server:")) << answer;
    EXPECT_FALSE(has(answer, "secret")) << answer;
  }
}

TEST(Http, RefusalsSayWhatIsWrong) {
  DemoServer server;
  const std::string host = "HTTP/1.1\r\nHost: localhost\r\n";
  const std::vector<std::pair<std::string, int>> cases = {
      {"GET /none " + host + "\r\n", 404},
      {"PUT /demo/a " + host + "\r\n", 405},
      {"OPTIONS /demo/a " + host + "\r\n", 405},
      {"OPTIONS * " + host + "\r\n", 404},
      {"BREW /demo/a " + host + "\r\n", 400},
      {"GET /demo/a HTTP/9\r\n\r\n", 400},
      {" POST /demo/a " + host + "Content-Length: 2\r\n\r\n{}", 400},
      {"GET /demo/a " + host + "Host: localhost\r\n\r\n", 400},
      {"GET /" + std::string(9000, 'v') + " " + host + "\r\n", 414},
      {"GET /demo/a HTTP/1.1\r\nHost: evil.example\r\n\r\n", 421},
      {"GET /demo/a " + host + "Origin: http://evil.example\r\n\r\n", 403},
      {"POST /demo/a " + host + "\r\n", 411},
      {"POST /demo/a " + host +
           "Content-Length: 2\r\nContent-Type: multipart/form-data; boundary=x\r\n\r\n{}",
       415},
      {"POST /demo/a " + host + "Content-Length: 2\r\nContent-Encoding: gzip\r\n\r\n{}", 415},
      {"POST /demo/a " + host + "Content-Length: -1\r\n\r\n", 400},
      {"POST /demo/a " + host + "Content-Length: 99999999999999999999999\r\n\r\n", 413},
      {"POST /demo/a " + host + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n{}", 400},
      {"POST /demo/a " + host + "Transfer-Encoding: gzip\r\n\r\n{}", 400},
  };
  for (const auto& [request, status] : cases) {
    const std::string answer = ask(server.port(), request);
    EXPECT_EQ(status_of(answer), status) << request.substr(0, 200) << answer;
    EXPECT_EQ(json_of(answer)["status"], status);
    EXPECT_TRUE(has(answer, "Content-Type: application/problem+json\r\n"));
  }
  EXPECT_TRUE(has(ask(server.port(), cases[2].first), "Allow: GET, HEAD, POST, DELETE\r\n"));
}

TEST(Http, HeadIsGetWithoutItsBody) {
  DemoServer server;
  const std::string answer = ask(server.port(), "HEAD /demo/a HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_EQ(body_of(answer), "");
  EXPECT_TRUE(has(
      answer, "Content-Length: " + std::to_string(body_of(get(server.port(), "/demo/a")).size())));
  EXPECT_EQ(body_of(ask(server.port(), "HEAD /ticks HTTP/1.1\r\nHost: localhost\r\n\r\n")), "");
}

TEST(Http, ATokenIsAskedForBeforeABodyIsRead) {
  DemoServer server({}, {"0123456789abcdef", {}});
  const std::string refused =
      ask(server.port(),
          "POST /demo/a HTTP/1.1\r\nContent-Length: 1000\r\nExpect: 100-continue\r\n\r\n");
  EXPECT_EQ(status_of(refused), 401);
  EXPECT_TRUE(has(refused, "WWW-Authenticate: Bearer\r\n"));
  EXPECT_EQ(status_of(get(server.port(), "/demo/a", "Authorization: Bearer 0123456789abcdef\r\n")),
            200);
  EXPECT_EQ(status_of(get(server.port(), "/healthz/live")), 200);
}

TEST(Http, AClientThatAsksWhetherToSendItsBodyIsTold) {
  DemoServer server;
  const Client client(server.port());
  client.send(
      "POST /demo/a HTTP/1.1\r\nHost: localhost\r\nContent-Length: 3\r\nExpect: "
      "100-continue\r\n\r\n");
  EXPECT_EQ(client.receive_until("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
  client.send("abc");
  EXPECT_EQ(json_of(client.receive_all())["bytes"], 3);
}

TEST(Http, HeadersReachTheEndpointUnchanged) {
  DemoServer server;
  const auto answer =
      json_of(get(server.port(), "/header",
                  "Idempotency-Key: a%0d%0ab%00\r\nREMOTE_ADDR: 1\r\nRange: bytes=0-1,0-1\r\n"));
  EXPECT_EQ(answer["idempotency-key"], "a%0d%0ab%00");
  EXPECT_EQ(answer["remote_addr"], "1");
}

TEST(Http, HostileUtf8IsAnswered) {
  DemoServer server;
  EXPECT_EQ(json_of(get(server.port(), "/demo/%ff%c0%00?%fe=%ed%a0%80"))["name"],
            std::string("\uFFFD\uFFFD\0", 7));
  EXPECT_EQ(status_of(get(server.port(), "/header", "X: \xff\xfe\r\n")), 200);
  EXPECT_EQ(status_of(get(server.port(), "/\xff\xfe%u0000%")), 404);
}

TEST(Http, PagesKeepTheirOwnHeaders) {
  DemoServer server;
  const std::string answer = get(server.port(), "/page");
  EXPECT_TRUE(has(answer, "Cache-Control: max-age=60\r\n"));
  EXPECT_FALSE(has(answer, "no-store"));
  EXPECT_TRUE(has(answer, "style-src 'unsafe-inline'"));
}

TEST(Http, AnExceptionIs500AndTheServerGoesOn) {
  DemoServer server;
  EXPECT_EQ(status_of(get(server.port(), "/throws")), 500);
  EXPECT_EQ(status_of(get(server.port(), "/demo/a")), 200);
}

TEST(Http, ExchangesAreObservedByPattern) {
  DemoServer server;
  get(server.port(), "/demo/secret");
  get(server.port(), "/secret");
  ask(server.port(), "BREW / HTTP/1.1\r\n\r\n");
  ask_and_half_close(server.port(), "secret");
  EXPECT_EQ(server.exchanges(),
            (std::map<std::string, int>{
                {"GET /demo/{name} 200", 1}, {"GET none 404", 1}, {"other none 400", 2}}));
}

TEST(Http, SixtyFourThreadsAreAllAnswered) {
  DemoServer server;
  std::atomic<int> right = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 64; ++t) {
    threads.emplace_back([&, name = std::to_string(t)] {
      for (int i = 0; i < 50; ++i)
        right += json_of(get(server.port(), "/demo/" + name))["name"] == name ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 64 * 50);
}

TEST(Http, APortThatIsTakenIsAnError) {
  DemoServer server;
  const Routes routes;
  const Access access;
  HttpServer second({}, routes, access, [](const Exchange&) {});
  EXPECT_FALSE(second.bind("127.0.0.1", server.port()));
  EXPECT_FALSE(second.bind("no such host", 0));
}

}  // namespace
}  // namespace coapt
