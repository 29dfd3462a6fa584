#include "io/json/parse_json.h"

#include "io/json/json_reader.h"
#include "tests/io/json/found.h"

namespace coapt {
namespace {

using enum ErrorCode;

Found found(std::string_view text) { return problems_of(parse_json(text)); }

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(ParseJson, GivesTheDocument) {
  const auto json = parse_json(R"({"a": [1, -2, 0.5, -0.0, true, null, "x"], "b": {}})");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(), R"({"a":[1,-2,0.5,-0.0,true,null,"x"],"b":{}})");
}

TEST(ParseJson, MembersComeInTheOrderOfTheirNames) {
  const auto json = parse_json(R"({"b": {"d": [1], "c": 2}, "a": {}})");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->dump(), R"({"a":{},"b":{"c":2,"d":[1]}})");
}

TEST(ParseJson, NumbersThatJsonDoesNotKnowAreRefusedWhereTheyStand) {
  EXPECT_EQ(found(R"({"a": [1, NaN]})"), (Found{{InvalidJson, "/a/1"}}));
  EXPECT_EQ(found(R"({"a": {"b": Infinity}})"), (Found{{InvalidJson, "/a/b"}}));
  EXPECT_EQ(found("[1, 2, +1]"), (Found{{InvalidJson, "/2"}}));
  EXPECT_EQ(found(R"({"a": 1e400})"), (Found{{OutOfRange, "/a"}}));
  EXPECT_EQ(found("-1e400"), (Found{{OutOfRange, ""}}));
}

TEST(ParseJson, WhatIsNotJsonIsRefused) {
  EXPECT_EQ(found(""), (Found{{InvalidJson, ""}}));
  EXPECT_EQ(found("{"), (Found{{InvalidJson, ""}}));
  EXPECT_EQ(found("[] []"), (Found{{InvalidJson, ""}}));
  EXPECT_EQ(found("// comment\n[]"), (Found{{InvalidJson, ""}}));
  EXPECT_EQ(found("[\"\xff\xfe\"]"), (Found{{InvalidJson, "/0"}}));
  EXPECT_EQ(found("[\"\xed\xa0\x80\"]"), (Found{{InvalidJson, "/0"}}));
  EXPECT_EQ(found(R"(["\ud800"])"), (Found{{InvalidJson, "/0"}}));
  EXPECT_EQ(found(std::string_view("[\0]", 3)), (Found{{InvalidJson, "/0"}}));
}

TEST(ParseJson, MessagesAreReadableWhateverTheInput) {
  std::string text = "[\"";
  for (int i = 0; i < 1000; ++i) text += static_cast<char>(0x80 + i % 128);
  const auto json = parse_json(text);
  ASSERT_FALSE(json);
  const std::string& message = json.errors().front().message;
  EXPECT_LE(message.size(), 203u);
  for (const char c : message) EXPECT_TRUE(c >= ' ' && c <= '~');
}

TEST(ParseJson, ANameGivenTwiceIsNamed) {
  EXPECT_EQ(found(R"({"a": 1, "b": [{"c": 1, "c": 2, "d/": 3, "d/": 4}], "a": 2})"),
            (Found{{InvalidJson, "/b/0/c"}, {InvalidJson, "/b/0/d~1"}, {InvalidJson, "/a"}}));
}

TEST(ParseJson, NestingIsLimitedTo32Levels) {
  EXPECT_TRUE(parse_json(nested(32)));
  std::string path;
  for (int i = 0; i < 32; ++i) path += "/0";
  EXPECT_EQ(found(nested(33)), (Found{{InvalidJson, path}}));
  EXPECT_EQ(found(nested(1'000'000)), (Found{{InvalidJson, path}}));
  EXPECT_EQ(found(std::string(30'000'000, '[')), (Found{{InvalidJson, path}}));
}

TEST(ParseJson, SizeIsLimitedTo64MiB) {
  const std::string nesting(100'000'000, '[');
  EXPECT_EQ(found(nesting), (Found{{InvalidJson, ""}}));
  EXPECT_TRUE(parse_json("1" + std::string((64u << 20) - 1, ' ')));
  EXPECT_EQ(found("1" + std::string(64u << 20, ' ')), (Found{{InvalidJson, ""}}));
}

TEST(ParseJson, ValuesAreLimitedAsAsked) {
  static_assert(kMaxJsonValues == 8'000'000, "unless asked otherwise");
  EXPECT_TRUE(parse_json("[1, {}]", 3));
  const auto refused = parse_json("[1, {}]", 2);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors()[0].message, "is more than the 2 values accepted");
}

TEST(ParseJson, DoesNotEndAtANul) {
  using namespace std::string_literals;
  for (const std::string& text : {"{}\0"s, "{}\0 rubbish {"s, "{\0}"s, "\0{}"s, "[\"a\0\"]"s})
    EXPECT_EQ(found(text).size(), 1u) << text;
}

TEST(ParseJson, NamesAreLimitedTo256Bytes) {
  const auto named = [](std::size_t size) { return "{\"" + std::string(size, 'a') + "\": 1}"; };
  EXPECT_TRUE(parse_json(named(256)));
  EXPECT_EQ(found(named(257)), (Found{{InvalidJson, ""}}));
}

TEST(TakeApart, LeavesNothingInside) {
  Json document = *parse_json(R"({"a": [[1, "long enough for a string of its own"], {}], "b": 2})");
  take_apart(document);
  EXPECT_EQ(document, Json::object());
  Json number = 3;
  take_apart(number);
  EXPECT_EQ(number, 3);
}

}  // namespace
}  // namespace coapt
