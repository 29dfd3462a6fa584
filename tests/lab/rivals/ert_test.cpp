#include "lab/rivals/ert.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coapt::rivals {
namespace {

// Two lattices, two seeds; the second run never gets below 1 mm2.
const std::vector<MeasuredRun> kRuns = {
    {"a", "x", 1, {{10, 3.0}, {40, 0.0}}, 100},
    {"a", "y", 1, {{20, 1.5}}, 100},
    {"b", "x", 1, {{5, 6.0}}, 50},
};

double time_of(const std::vector<Ert>& rows, const std::string& method, double target) {
  for (const Ert& row : rows)
    if (row.method == method && row.target_mm2 == target) return row.closures;
  return -1.0;
}

TEST(Ert, CountsTheClosuresOfRunsThatFailed) {
  const std::vector<Ert> rows = expected_running_times(kRuns);
  EXPECT_EQ(time_of(rows, "a", 5.0), (10.0 + 20.0) / 2.0);
  EXPECT_EQ(time_of(rows, "a", 2.0), (40.0 + 20.0) / 2.0);
  EXPECT_EQ(time_of(rows, "a", 1.0), 40.0 + 100.0);
  EXPECT_EQ(time_of(rows, "a", 1e-9), 140.0);
  EXPECT_TRUE(std::isinf(time_of(rows, "b", 5.0)));
}

TEST(Ert, IsOfOneLatticeIfAsked) {
  const std::vector<Ert> rows = expected_running_times(kRuns, "y");
  EXPECT_EQ(time_of(rows, "a", 2.0), 20.0);
  EXPECT_EQ(time_of(rows, "b", 2.0), -1.0) << "no run of it there";
}

TEST(Ert, SharesRiseToThoseReached) {
  const std::vector<ReachedShares> shares = reached_shares(kRuns);
  // Of 14 pairs of a: 1 at 10 closures, 2 more at 20, 6 more at 40.
  EXPECT_EQ(shares[0].closures, (std::vector<double>{10.0, 20.0, 40.0}));
  EXPECT_DOUBLE_EQ(shares[0].share.front(), 1.0 / 14.0);
  EXPECT_DOUBLE_EQ(shares[0].share.back(), 9.0 / 14.0);
  EXPECT_TRUE(shares[1].share.empty());
}

TEST(Ert, CsvNamesItsColumns) {
  EXPECT_EQ(ert_csv({{"a", 0.2, 12.0, 3, 4}, {"b", 1e-9, HUGE_VAL, 0, 4}}),
            "method,target_mm2,ert_closures,successes,seeds\na,0.2,12.0,3,4\nb,0,inf,0,4\n");
}

}  // namespace
}  // namespace coapt::rivals
