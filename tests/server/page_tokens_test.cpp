#include "server/page_tokens.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(PageTokens, ATokenNamesThePlaceInItsListAgain) {
  const PageTokens tokens;
  for (const std::int64_t place : {std::int64_t{1}, std::int64_t{20}, std::int64_t{1} << 62})
    EXPECT_EQ(tokens.place("/v1/jobs", tokens.token("/v1/jobs", place)), place);
}

TEST(PageTokens, ATokenTellsNothingOfThePlace) {
  const PageTokens tokens;
  const std::string one = tokens.token("/v1/jobs", 1), two = tokens.token("/v1/jobs", 2);
  EXPECT_EQ(one.size(), 32u);
  int different = 0;
  for (std::size_t i = 0; i < one.size(); ++i) different += one[i] != two[i];
  EXPECT_GT(different, 16);
}

TEST(PageTokens, WhatWasNotGivenForThisListIsNone) {
  const PageTokens tokens, others;
  const std::string token = tokens.token("/v1/jobs", 3);
  EXPECT_FALSE(tokens.place("/v1/valves", token));
  EXPECT_FALSE(others.place("/v1/jobs", token));
  for (std::size_t i = 0; i < token.size(); ++i) {
    std::string forged = token;
    forged[i] = forged[i] == '0' ? '1' : '0';
    EXPECT_FALSE(tokens.place("/v1/jobs", forged));
  }
  for (const std::string& wrong : {std::string(), std::string("3"), token + "00", token.substr(2),
                                   std::string(32, 'z'), std::string(32, '\0')})
    EXPECT_FALSE(tokens.place("/v1/jobs", wrong));
}

}  // namespace
}  // namespace coapt
