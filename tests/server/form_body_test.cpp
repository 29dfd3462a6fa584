#include "server/form_body.h"

#include <gtest/gtest.h>

#include "io/json/parse_json.h"

namespace coapt {
namespace {

constexpr std::string_view kType = "multipart/form-data; boundary=\"x-y\"";

std::string part(const std::string& disposition, const std::string& content) {
  return "--x-y\r\nContent-Disposition: form-data; " + disposition +
         "\r\nContent-Type: text/plain\r\n\r\n" + content + "\r\n";
}

TEST(FormBody, FilesAndFieldsAreTheSameRequestAsJson) {
  const std::string body = part("name=\"leaflets\"; filename=\"a.obj\"", "v 1\r\n2") +
                           part("name=\"leaflets\"; filename=\"p.obj\"", std::string("\0\xff", 2)) +
                           part("name=\"annulus\"; filename=\"ring.csv\"", "1,2,3") +
                           part("name=\"triangles\"", "300") + part("name=\"name\"", "12") +
                           part("name=\"label_numbers\"", "{\"anterior\": [2]}") +
                           part("name=\"fit.side\"", "middle") + "--x-y--\r\n";
  const Expected<std::string> json = json_of_form(body, kType);
  ASSERT_TRUE(json) << json.errors()[0].message;
  const Json expected = {
      {"leaflets",
       {{{"name", "a.obj"}, {"base64", "diAxDQoy"}}, {{"name", "p.obj"}, {"base64", "AP8="}}}},
      {"annulus", {{"name", "ring.csv"}, {"base64", "MSwyLDM="}}},
      {"triangles", 300},
      {"name", "12"},
      {"label_numbers", {{"anterior", {2}}}},
      {"fit", {{"side", "middle"}}}};
  EXPECT_EQ(*parse_json(*json), *parse_json(expected.dump()));
}

TEST(FormBody, NamesInOtherEncodingsAreTakenWithAMarkInTheirPlace) {
  const std::string body = part("name=\"annulus\"; filename=\"R\xe4nder.csv\"", "1,2,3") +
                           part("name=\"x\xff\"", "\xfe") + "--x-y--\r\n";
  const Expected<std::string> json = json_of_form(body, kType);
  ASSERT_TRUE(json);
  const Expected<Json> document = parse_json(*json);
  ASSERT_TRUE(document) << *json;
  EXPECT_EQ((*document)["annulus"]["name"], "R\xef\xbf\xbdnder.csv");
}

TEST(FormBody, WhatIsNotWholeIsRefused) {
  const std::string whole = part("name=\"a\"", "1") + "--x-y--\r\n";
  EXPECT_TRUE(json_of_form(whole, kType));
  for (std::size_t length = 0; length + 4 < whole.size(); ++length)
    EXPECT_FALSE(json_of_form(whole.substr(0, length), kType)) << length;
  EXPECT_FALSE(json_of_form(whole, "multipart/form-data"));
  EXPECT_FALSE(json_of_form(part("filename=\"a\"", "1") + "--x-y--", kType));
  EXPECT_FALSE(json_of_form(part("name=\"a\"", "1") + part("name=\"a\"", "2") + "--x-y--", kType));
  EXPECT_FALSE(json_of_form(
      part("name=\"leaflets.a\"", "1") + part("name=\"leaflets\"", "2") + "--x-y--", kType))
      << "an object and a list";
}

}  // namespace
}  // namespace coapt
