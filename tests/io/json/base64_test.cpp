#include "io/json/base64.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

/// RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encoded_base64(""), "");
  EXPECT_EQ(encoded_base64("f"), "Zg==");
  EXPECT_EQ(encoded_base64("fo"), "Zm8=");
  EXPECT_EQ(encoded_base64("foo"), "Zm9v");
  EXPECT_EQ(encoded_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded_base64("\xFF\xFE"), "//4=");
}

TEST(Base64, ComesBackAsItWas) {
  for (const std::string& bytes : {std::string(), std::string("a"), std::string("ab"),
                                   std::string("abc"), std::string("\0\xff\n", 3)})
    EXPECT_EQ(decoded_base64(encoded_base64(bytes)), bytes);
  for (const char* text : {"a", "====", "ab==c", "a=bc", "ab\n=", "\xc3\xa4=="})
    EXPECT_EQ(decoded_base64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace coapt
