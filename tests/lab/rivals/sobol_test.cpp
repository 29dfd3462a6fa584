#include "lab/rivals/sobol.h"

#include <gtest/gtest.h>

#include <set>

namespace coapt::rivals {
namespace {

using Row = std::vector<double>;

// By hand: dimension 1 has the directions 1/2, 1/4, 1/8. Dimension 2 has degree 1, m = 1, then
// m_k = 2 m_(k-1) xor m_(k-1) = 1, 3, 5, that is 1/2, 3/4, 5/8. Dimension 3 has x^2 + x + 1 and
// m = 1, 3, then 2 * 3 xor 4 * 1 xor 1 = 7: 1/2, 3/4, 7/8. In Gray code order the directions taken
// are 1, 2, 1, 3, 1, 2, 1.
TEST(Sobol, TheFirstPointsAreThoseWorkedOutByHand) {
  SobolSequence sequence(3);
  EXPECT_EQ(sequence.next(), (Row{0.0, 0.0, 0.0}));
  EXPECT_EQ(sequence.next(), (Row{0.5, 0.5, 0.5}));
  EXPECT_EQ(sequence.next(), (Row{0.75, 0.25, 0.25}));
  EXPECT_EQ(sequence.next(), (Row{0.25, 0.75, 0.75}));
  EXPECT_EQ(sequence.next(), (Row{0.375, 0.375, 0.625}));
  EXPECT_EQ(sequence.next(), (Row{0.875, 0.875, 0.125}));
  EXPECT_EQ(sequence.next(), (Row{0.625, 0.125, 0.875}));
  EXPECT_EQ(sequence.next(), (Row{0.125, 0.625, 0.375}));
}

TEST(Sobol, AShiftFlipsTheSameDigitsOfEveryPoint) {
  SobolSequence sequence(2, {0x80000000U, 0x40000000U});  // the halves, the quarters
  EXPECT_EQ(sequence.next(), (Row{0.5, 0.25}));
  EXPECT_EQ(sequence.next(), (Row{0.0, 0.75}));
  EXPECT_EQ(sequence.next(), (Row{0.25, 0.0}));
  EXPECT_EQ(sequence.next(), (Row{0.75, 0.5}));
}

/// Among the first `count` points, the cells of width 1/count that dimension `d` falls into.
std::size_t cells_met(SobolSequence sequence, std::size_t d, int count) {
  std::set<int> cells;
  for (int i = 0; i < count; ++i) cells.insert(static_cast<int>(sequence.next()[d] * count));
  return cells.size();
}

TEST(Sobol, EveryDimensionMeetsEachIntervalOnceShiftedOrNot) {
  const std::vector<std::uint32_t> shift(12, 0x9e3779b9U);
  for (std::size_t d = 0; d < 12; ++d)
    for (const int count : {2, 16, 1024}) {
      EXPECT_EQ(cells_met(SobolSequence(12), d, count), static_cast<std::size_t>(count)) << d;
      EXPECT_EQ(cells_met(SobolSequence(12, shift), d, count), static_cast<std::size_t>(count))
          << d;
    }
}

// Sobol's property A (1976), which Joe and Kuo's numbers have: a wrong one of the table breaks it.
TEST(Sobol, TheFirst4096PointsMeetEveryOrthantOf12DimensionsOnce) {
  SobolSequence sequence(12);
  std::set<unsigned> orthants;
  for (int i = 0; i < 4096; ++i) {
    unsigned orthant = 0;
    for (const double share : sequence.next()) orthant = 2 * orthant + (share >= 0.5 ? 1U : 0U);
    orthants.insert(orthant);
  }
  EXPECT_EQ(orthants.size(), 4096u);
}

}  // namespace
}  // namespace coapt::rivals
