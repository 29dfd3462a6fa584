#include "core/valve/nearest_name.h"

#include <gtest/gtest.h>

#include <vector>

namespace coapt {
namespace {

const std::vector<std::string> kNames = {"human-normal", "human-functional-mr", "ring",
                                         "neochorda"};

TEST(DidYouMean, OffersTheNearestName) {
  EXPECT_EQ(did_you_mean("human-nromal", kNames), "; did you mean \"human-normal\"?");
  EXPECT_EQ(did_you_mean("human-functional", kNames), "; did you mean \"human-functional-mr\"?");
  EXPECT_EQ(did_you_mean("neochord", kNames), "; did you mean \"neochorda\"?");
  EXPECT_EQ(did_you_mean("rnig", kNames), "; did you mean \"ring\"?");
}

TEST(DidYouMean, OffersNothingFarFromAllNames) {
  for (const char* given : {"", "r", "sing-song", "porcine"})
    EXPECT_EQ(did_you_mean(given, kNames), "") << given;
  EXPECT_EQ(did_you_mean(std::string(1'000'000, 'x'), kNames), "");
  EXPECT_EQ(did_you_mean("ring", {}), "");
}

}  // namespace
}  // namespace coapt
