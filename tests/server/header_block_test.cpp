#include "server/header_block.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(HeaderLength, EndsWithTheBlankLine) {
  EXPECT_EQ(header_length("GET / HTTP/1.1\r\n\r\nbody"), 18U);
  EXPECT_EQ(header_length("GET / HTTP/1.1\n\nbody"), 16U);
  EXPECT_EQ(header_length("GET / HTTP/1.1\r\nA: b\r\n"), std::nullopt);
  EXPECT_EQ(header_length(""), std::nullopt);
}

TEST(HeaderLength, IsTheSameByteByByte) {
  const std::string header = "GET / HTTP/1.1\r\nA: b\r\n\r\n";
  for (std::size_t size = 1; size < header.size(); ++size) {
    EXPECT_EQ(header_length(header.substr(0, size), size - 1), std::nullopt) << size;
  }
  EXPECT_EQ(header_length(header, header.size() - 1), header.size());
}

TEST(ParseHeader, LeavesValuesAsTheyAre) {
  const auto block =
      parse_header("GET /a HTTP/1.1\r\nHost: x%0d\r\nIdempotency-KEY:\t a  b \r\nX:\nX: 2\r\n\r\n");
  ASSERT_TRUE(block);
  EXPECT_EQ(block->request_line, "GET /a HTTP/1.1");
  EXPECT_EQ(block->fields, (std::map<std::string, std::string>{
                               {"host", "x%0d"}, {"idempotency-key", "a  b"}, {"x", ""}}));
}

TEST(ParseHeader, RefusesWhatReadersWouldDifferAbout) {
  using namespace std::string_literals;
  for (const std::string& wrong :
       {"no colon"s, "A : b"s, ": b"s, " folded: b"s, "A: b\rC: d"s, "A: \0"s, "A: b\x01"s,
        "Host: a\r\nhost: a"s, "Content-Length: 1\r\nContent-Length: 1"s,
        "Transfer-Encoding: chunked\r\nTransfer-Encoding: x"s, "A\xff: b"s}) {
    EXPECT_FALSE(parse_header("GET / HTTP/1.1\r\n" + wrong + "\r\n\r\n")) << wrong;
  }
  EXPECT_FALSE(parse_header("GET /\x01 HTTP/1.1\r\n\r\n"));
}

TEST(ParseHeader, RefusesARequestLineThatReadersCouldReadOtherwise) {
  for (const std::string wrong :
       {"", " POST / HTTP/1.1", "POST  / HTTP/1.1", "POST /  HTTP/1.1", "POST / HTTP/1.1 ",
        "POST\t/ HTTP/1.1", "POST /a b HTTP/1.1", "POST /\ta HTTP/1.1", "POST /", "POST HTTP/1.1",
        "POST  HTTP/1.1", "P(ST / HTTP/1.1", "POST / HTTP/2.0", "POST / HTTP/1.", "POST / HTTP/1.x",
        "POST / http/1.1"})
    EXPECT_FALSE(parse_header(wrong + "\r\n\r\n")) << wrong;
  EXPECT_TRUE(parse_header("OPTIONS * HTTP/1.0\r\n\r\n"));
}

}  // namespace
}  // namespace coapt
