#include "search/latin_hypercube.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TEST(LatinHypercube, HasOneSampleInEachStratumOfEachFactor) {
  const std::vector<std::vector<double>> samples = latin_hypercube(50, 4, 7);
  ASSERT_EQ(samples.size(), 50u);
  for (std::size_t f = 0; f < 4; ++f) {
    std::vector<int> in_stratum(50, 0);
    for (const std::vector<double>& sample : samples) {
      ASSERT_EQ(sample.size(), 4u);
      ASSERT_TRUE(sample[f] >= 0.0 && sample[f] < 1.0);
      ++in_stratum[static_cast<std::size_t>(50.0 * sample[f])];
    }
    EXPECT_EQ(in_stratum, std::vector<int>(50, 1));
  }
}

TEST(LatinHypercube, DependsOnItsSeedAlone) {
  EXPECT_EQ(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 5));
  EXPECT_NE(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 6));
}

}  // namespace
}  // namespace coapt
