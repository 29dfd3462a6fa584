#include "server/client_of.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

std::string behind_proxy(const std::string& fields) {
  return client_of(-1, "GET / HTTP/1.1\r\n" + fields + "\r\n");
}

TEST(ClientOf, IsAnAddressOfIPv4OrANetworkOfIPv6) {
  EXPECT_EQ(client_at("192.0.2.1"), "\xc0" + std::string("\0\2\1", 3));
  EXPECT_EQ(client_at("::ffff:192.0.2.1"), client_at("192.0.2.1"));
  EXPECT_EQ(client_at("2001:db8:0:1::1"), client_at("2001:db8:0:1:ffff::9"));
  EXPECT_NE(client_at("2001:db8:0:1::1"), client_at("2001:db8:0:2::1"));
  for (const char* none : {"", "192.0.2", "192.0.2.1:80", "unknown", "localhost"})
    EXPECT_EQ(client_at(none), "") << none;
}

TEST(ClientOf, ARequestThatAProxyPassedOnIsTheLastAddressWhichTheProxyAdded) {
  const std::string one = client_at("192.0.2.1");
  EXPECT_EQ(behind_proxy("X-Forwarded-For: 192.0.2.1\r\n"), one);
  EXPECT_EQ(behind_proxy("X-Forwarded-For: 203.0.113.9, ::1, 192.0.2.1 \r\n"), one);
  EXPECT_EQ(behind_proxy("X-Forwarded-For: 203.0.113.9\r\nx-forwarded-for: 192.0.2.1\r\n"), one);
  EXPECT_EQ(behind_proxy("X-Forwarded-For: 192.0.2.1, x\r\n"), "")
      << "then of the socket: none here";
  EXPECT_EQ(behind_proxy(""), "");
}

}  // namespace
}  // namespace coapt
