// Part of every program of tests of a tree with faults (mutants.py): COAPT_REACHED=FILE gets a line a test, its name and the
// faults whose places it came to; what a suite makes counts as of its first test.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/mutants/mutant.h"

namespace {

class Reached : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo& test) override {
    std::ofstream file(std::getenv("COAPT_REACHED"), std::ios::app);
    file << test.test_suite_name() << '.' << test.name();
    for (std::size_t k = 0; k < coapt_reached.size(); ++k)
      if (coapt_reached[k].exchange(false)) file << ' ' << k;
    file << '\n';
  }
};

[[maybe_unused]] const bool kListens = [] {
  if (std::getenv("COAPT_REACHED"))
    testing::UnitTest::GetInstance()->listeners().Append(new Reached);
  return true;
}();

}  // namespace
