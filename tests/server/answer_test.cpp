#include "server/answer.h"

#include <gtest/gtest.h>

#include "io/json/version.h"

namespace coapt {
namespace {

std::string header(const Answer& answer, const std::string& name) {
  for (const auto& [given, value] : all_headers(answer)) {
    if (given == name) return value;
  }
  return "";
}

TEST(Answer, AProblemIsOfRfc9457) {
  const Answer answer = problem(
      422, {{ErrorCode::OutOfRange, "/valve/x", "x must be 1"}, {ErrorCode::WrongType, "/y", "z"}});
  EXPECT_EQ(content_type(answer), "application/problem+json");
  const auto json = Json::parse(content_bytes(answer));
  EXPECT_EQ(json["type"], "https://coapt.example/problems/out_of_range");
  EXPECT_EQ(json["title"], "Unprocessable content");
  EXPECT_EQ(json["status"], 422);
  EXPECT_EQ(json["detail"], "x must be 1");
  EXPECT_EQ(json["problems"][1], (Json{{"code", "wrong_type"}, {"path", "/y"}, {"message", "z"}}));
  EXPECT_EQ(json["notice"], kResearchNotice);
}

TEST(Answer, EveryAnswerHasTheNoticeAndTheHeadersThatKeepBrowsersCareful) {
  for (const Answer& answer : {Answer{204}, problem(500, ErrorCode::Unsupported, ""),
                               Answer{200, Content{"image/png", "x"}}}) {
    EXPECT_EQ(header(answer, "Coapt-Notice"), kResearchNotice);
    EXPECT_EQ(header(answer, "X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(header(answer, "Cache-Control"), "no-store");
    EXPECT_EQ(header(answer, "Content-Security-Policy"),
              "default-src 'none'; frame-ancestors 'none'");
    EXPECT_EQ(header(answer, "Referrer-Policy"), "no-referrer");
    EXPECT_EQ(header(answer, "Cross-Origin-Resource-Policy"), "same-origin");
  }
}

TEST(Answer, APageMayHaveStylesAndPicturesInIt) {
  EXPECT_EQ(header({200, Content{"text/html; charset=utf-8", ""}}, "Content-Security-Policy"),
            "default-src 'none'; style-src 'unsafe-inline'; img-src data:; frame-ancestors 'none'");
}

TEST(Answer, ItsOwnHeadersGoFirst) {
  const Answer answer{
      503, Content{"text/plain", ""}, {{"Cache-Control", "max-age=1"}, {"Retry-After", "7"}}};
  EXPECT_EQ(header(answer, "Cache-Control"), "max-age=1");
  EXPECT_EQ(header(answer, "Retry-After"), "7");
  EXPECT_EQ(header(problem(429, Errors{}), "Retry-After"), "5");
  EXPECT_EQ(all_headers(answer).size(), 7U);
}

TEST(Answer, WhatIsNoUtf8IsReplaced) {
  EXPECT_EQ(Json::parse(content_bytes(json_answer(200, {{"name", "a\xff\xc0z"}})))["name"],
            "a\uFFFD\uFFFDz");
}

}  // namespace
}  // namespace coapt
