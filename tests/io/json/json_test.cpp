#include "io/json/json.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(JsonText, MovesNoTerminalAndIsTheSameWhenParsed) {
  const Json json = {{"a\xC2\x9B"
                      "b",
                      "\x1B\x7F\xC2\x80\xC2\x9F\xC2\xA0"},
                     {"direction", "\xE2\x80\xA9\xE2\x80\xAA\xE2\x80\xAE\xE2\x80\xAF"},
                     {"isolates", "\xE2\x81\xA5\xE2\x81\xA6\xE2\x81\xA9\xE2\x81\xAA"}};
  const std::string text = json_text(json);
  EXPECT_EQ(
      text,
      "{\"a\\u009bb\":\"\\u001b\\u007f\\u0080\\u009f\xC2\xA0\",\"direction\":\"\xE2\x80\xA9"
      "\\u202a\\u202e\xE2\x80\xAF\",\"isolates\":\"\xE2\x81\xA5\\u2066\\u2069\xE2\x81\xAA\"}");
  EXPECT_EQ(Json::parse(text), json);
}

TEST(JsonText, OtherTextIsAsTheLibraryWritesIt) {
  const Json json = {{"mm²", "二尖瓣 🫀 \"quoted\" \\"}, {"numbers", {1, 0.1, nullptr}}};
  EXPECT_EQ(json_text(json), json.dump());
  EXPECT_EQ(json_text(json, 2), json.dump(2));
}

TEST(JsonText, BytesThatAreNotUtf8AreReplaced) {
  EXPECT_EQ(json_text(Json("a\xFF\xC2")), "\"a\xEF\xBF\xBD\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace coapt
