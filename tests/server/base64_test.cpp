#include "server/base64.h"

#include "tests/server/endpoints/import_scene.h"

namespace coapt {
namespace {

TEST(Base64, ComesBackAsItWas) {
  for (const std::string& bytes : {std::string(), std::string("a"), std::string("ab"),
                                   std::string("abc"), std::string("\0\xff\n", 3)})
    EXPECT_EQ(decoded_base64(base64(bytes)), bytes);
  for (const char* text : {"a", "====", "ab==c", "a=bc", "ab\n=", "\xc3\xa4=="})
    EXPECT_EQ(decoded_base64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace coapt
