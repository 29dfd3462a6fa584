#include "server/negotiation.h"

#include <gtest/gtest.h>
#include <zlib.h>

namespace coapt {
namespace {

const std::string kLong(10'000, 'x');

Request with_headers(const std::map<std::string, std::string>& headers) {
  Request request;
  request.method = "GET";
  request.headers = headers;
  return request;
}

std::string said(const Answer& answer, const std::string& name) {
  for (const auto& [given, value] : answer.headers)
    if (given == name) return value;
  return "";
}

std::string inflated(const std::string& bytes) {
  std::string text(1 << 20, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  std::string given = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(given.data());
  stream.avail_in = static_cast<uInt>(given.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return text;
}

TEST(Gzip, ComesBackAsItWas) {
  for (const std::string& text : {std::string(), std::string("valve"), kLong})
    for (const int level : {1, 9}) EXPECT_EQ(inflated(gzip(text, level)), text);
  EXPECT_LT(gzip(kLong, 1).size(), 200U);
}

TEST(Gunzip, GivesWhatWasCompressedAndNothingOfAnythingElse) {
  for (const std::string& text : {std::string(), std::string("valve"), kLong})
    EXPECT_EQ(gunzip(gzip(text, 6), kLong.size()), text);
  const std::string compressed = gzip(kLong, 6);
  EXPECT_FALSE(gunzip(compressed, kLong.size() - 1));
  for (std::size_t size = 0; size < compressed.size(); ++size)
    EXPECT_FALSE(gunzip(compressed.substr(0, size), 1 << 20)) << size;
  std::string damaged = compressed;
  char& flipped = damaged[compressed.size() / 2];
  flipped = static_cast<char>(flipped ^ 1);
  EXPECT_FALSE(gunzip(damaged, 1 << 20));
}

TEST(Gzip, IsTakenByThoseWhoSaySo) {
  for (const char* field : {"gzip", "br, gzip", "gzip;q=0.5", "*", "deflate, gzip ; q=1"})
    EXPECT_TRUE(takes_gzip(field)) << field;
  for (const char* field :
       {"", "br", "gzip;q=0", "*;q=0.0", "gzip;x=1", "xgzip", ",,;", "identity"})
    EXPECT_FALSE(takes_gzip(field)) << field;
}

TEST(Negotiated, LongAnswersAreCompressedForThoseWhoTakeIt) {
  const Answer answer{200, Content{"text/csv", kLong}};
  const Answer compressed = negotiated(answer, with_headers({{"accept-encoding", "gzip"}}));
  EXPECT_EQ(said(compressed, "Content-Encoding"), "gzip");
  EXPECT_EQ(said(compressed, "Vary"), "Accept-Encoding");
  EXPECT_EQ(content_type(compressed), "text/csv");
  EXPECT_EQ(inflated(content_bytes(compressed)), kLong);
  const Answer plain = negotiated(answer, with_headers({}));
  EXPECT_EQ(said(plain, "Content-Encoding"), "");
  EXPECT_EQ(content_bytes(plain), kLong);
}

TEST(Negotiated, ShortAnswersAndPicturesStayAsTheyAre) {
  for (const Content& content : {Content{"text/csv", "a,b"}, Content{"image/png", kLong}}) {
    const Answer answer = negotiated({200, content}, with_headers({{"accept-encoding", "gzip"}}));
    EXPECT_EQ(content_bytes(answer), content.bytes);
    EXPECT_EQ(said(answer, "Content-Encoding"), "");
  }
}

TEST(Negotiated, WhatAClientHasIsNotSentAgain) {
  const Answer answer{200, Content{"text/csv", kLong}};
  const std::string tag = said(negotiated(answer, with_headers({})), "ETag");
  EXPECT_TRUE(tag.starts_with("W/\""));
  EXPECT_EQ(said(negotiated(answer, with_headers({{"accept-encoding", "gzip"}})), "ETag"), tag);
  for (const std::string& known : {tag, "\"other\", " + tag, std::string("*")}) {
    const Answer again = negotiated(answer, with_headers({{"if-none-match", known}}));
    EXPECT_EQ(again.status, 304);
    EXPECT_EQ(content_bytes(again), "");
    EXPECT_EQ(said(again, "ETag"), tag);
  }
  EXPECT_EQ(negotiated(answer, with_headers({{"if-none-match", "W/\"other\""}})).status, 200);
}

TEST(Negotiated, OnlyWhatStandsAtAPathHasATag) {
  Request post = with_headers({{"if-none-match", "*"}});
  post.method = "POST";
  EXPECT_EQ(said(negotiated({200, Content{"text/csv", kLong}}, post), "ETag"), "");
  EXPECT_EQ(negotiated({200, Content{"text/csv", kLong}}, post).status, 200);
  EXPECT_EQ(
      said(negotiated(problem(404, ErrorCode::BadReference, "gone"), with_headers({})), "ETag"),
      "");
}

}  // namespace
}  // namespace coapt
