#include "server/chunk_framing.h"

#include <gtest/gtest.h>

#include <string>

namespace coapt {
namespace {

TEST(ChunkFraming, EndsWithTheEmptyChunk) {
  for (const std::string body : {"0\r\n\r\n", "3\r\nabc\r\n0\r\n\r\n",
                                 "0A;name=\"x y\"\r\n0\r\n\r\n34567\r\n1\r\n0\r\n000\r\n\r\n"}) {
    ChunkFraming whole, in_bytes;
    EXPECT_TRUE(whole.follow(body)) << body;
    EXPECT_TRUE(whole.has_ended()) << body;
    for (std::size_t i = 0; i < body.size(); ++i) {
      EXPECT_FALSE(in_bytes.has_ended()) << body << i;
      EXPECT_TRUE(in_bytes.follow(body.substr(i, 1))) << body << i;
    }
    EXPECT_TRUE(in_bytes.has_ended()) << body;
    EXPECT_FALSE(whole.follow("x"));
  }
}

TEST(ChunkFraming, RefusesWhatAReaderCouldTakeForAnotherSize) {
  for (const std::string body :
       {"0x3\r\nabc\r\n", "+3\r\nabc\r\n", "-3\r\nabc\r\n", " 3\r\nabc\r\n", "3 x\r\nabc\r\n",
        "3 \r\nabc\r\n", "\r\n", ";x\r\n", "3\nabc\n", "3\r\nabcd\r\n", "3;\x01\r\n",
        "0\r\ntrailer: x\r\n\r\n", "0\r\n\n", "1234567890abcdef\r\n"})
    EXPECT_FALSE(ChunkFraming().follow(body)) << body;
}

}  // namespace
}  // namespace coapt
