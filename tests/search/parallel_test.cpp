#include "search/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace coapt {
namespace {

TEST(ForEachIndex, CallsEachIndexOnce) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<int> calls(100, 0);
    for_each_index(100, threads, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(calls, std::vector<int>(100, 1));
  }
}

TEST(ForEachIndex, ThrowsTheExceptionOfTheSmallestIndexAfterAllCalls) {
  std::vector<int> calls(20, 0);
  try {
    for_each_index(20, 2, [&](int i) {
      ++calls[static_cast<std::size_t>(i)];
      if (i >= 7) throw std::runtime_error(std::to_string(i));
    });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "7");
  }
  EXPECT_EQ(calls, std::vector<int>(20, 1));
}

TEST(ForEachIndex, DoesNothingForNoIndices) {
  for_each_index(0, 2, [](int) { FAIL(); });
}

}  // namespace
}  // namespace coapt
