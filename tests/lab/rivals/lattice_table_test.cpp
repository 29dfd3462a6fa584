#include "lab/rivals/lattice_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/lab/rivals/lattices.h"

namespace coapt::rivals {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const LatticeTable kSmall{"ring, then size",
                          {{"ring shape", false, 2}, {"size", true, 3}},
                          {0.1, 1, 2, 1e-300, 4, kInfinity}};
const std::string kSmallText =
    "coapt-lattice 1\n"
    "name ring, then size\n"
    "category 2 ring shape\n"
    "ordered 3 size\n"
    "costs 6\n"
    "0.10000000000000001\n"
    "1\n"
    "2\n"
    "1e-300\n"
    "4\n"
    "inf\n";

/// The small lattice's text with the first `from` replaced.
std::string damaged(const std::string& from, const std::string& to) {
  std::string text = kSmallText;
  return text.replace(text.find(from), from.size(), to);
}

struct Malformed {
  std::string text;
  ErrorCode code;
  std::string message;
};

TEST(LatticeTable, VariableZeroIsTheFastest) {
  EXPECT_EQ(index_of(kSmall, std::vector{1, 0}), 1u);
  EXPECT_EQ(index_of(kSmall, std::vector{0, 1}), 2u);
  EXPECT_EQ(index_of(kSmall, std::vector{1, 2}), 5u);
}

TEST(LatticeTable, CombinationsAndIndicesAreInverse) {
  const LatticeTable table = ring_and_anchors();
  for (std::size_t i = 0; i < table.costs.size(); ++i)
    ASSERT_EQ(index_of(table, combination_of(table, i)), i);
}

TEST(LatticeTable, IsWrittenAsItsFormatSays) { EXPECT_EQ(write_lattice(kSmall), kSmallText); }

TEST(LatticeTable, IsReadBackAsItWasWritten) {
  for (const LatticeTable& table : {kSmall, bowl(), ring_and_anchors()}) {
    const Expected<LatticeTable> read = read_lattice(write_lattice(table));
    ASSERT_TRUE(read) << read.errors()[0].message;
    EXPECT_EQ(*read, table);
  }
}

TEST(LatticeTable, IsReadWithoutTheLastLineFeed) {
  EXPECT_TRUE(read_lattice(std::string_view(kSmallText).substr(0, kSmallText.size() - 1)));
}

TEST(LatticeTable, EveryMalformedTextIsAnErrorWithItsLine) {
  const std::string nothing_finite = damaged("costs 6", "costs 6\ninf\ninf\ninf\ninf\ninf\ninf");
  std::string eleven = "coapt-lattice 1\nname n\n";
  for (int k = 0; k < 11; ++k) eleven += "ordered 2 v" + std::to_string(k) + '\n';
  const std::vector<Malformed> all{
      {"", ErrorCode::Unsupported, "line 1: must be 'coapt-lattice 1'"},
      {damaged("lattice 1", "lattice 2"), ErrorCode::Unsupported, "line 1: "},
      {damaged("lattice 1\n", "lattice 1\r\n"), ErrorCode::Unsupported, "line 1: "},
      {damaged("name ring, then size", "name "), ErrorCode::MissingField, "line 2: "},
      {damaged("name", "title"), ErrorCode::MissingField, "line 2: "},
      {damaged("category 2", "category 1"), ErrorCode::OutOfRange, "line 3: a variable has 2 to"},
      {damaged("category 2", "category 0"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2", "category -2"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2", "category two"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2", "category 2.5"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2", "category 1001"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2", "category 99999999999"), ErrorCode::OutOfRange, "line 3: "},
      {damaged("category 2 ring shape", "category 2"), ErrorCode::MissingField, "line 3: "},
      {damaged("category", "colour"), ErrorCode::UnknownField, "line 3: "},
      {damaged("3 size", "3 ring shape"), ErrorCode::BadReference, "line 4: "},
      {damaged("ordered 3 size\n", ""), ErrorCode::OutOfRange, "line 4: there are 2 to 10 "},
      {damaged("costs 6", "costs 5"), ErrorCode::OutOfRange, "line 5: the variables have 6"},
      {damaged("costs 6", "costs"), ErrorCode::OutOfRange, "line 5: "},
      {damaged("\n2\n", "\ntwo\n"), ErrorCode::OutOfRange, "line 8: a cost is"},
      {damaged("\n2\n", "\n\n"), ErrorCode::OutOfRange, "line 8: "},
      {damaged("\n2\n", "\n2 \n"), ErrorCode::OutOfRange, "line 8: "},
      {damaged("\n2\n", "\nnan\n"), ErrorCode::OutOfRange, "line 8: "},
      {damaged("\n2\n", "\n-inf\n"), ErrorCode::OutOfRange, "line 8: "},
      {damaged("\n2\n", "\n1e999\n"), ErrorCode::OutOfRange, "line 8: "},
      {damaged("4\ninf\n", ""), ErrorCode::InputOutput, "line 10: is truncated: 4 of 6 costs"},
      {damaged("inf\n", "inf\n5\n"), ErrorCode::UnknownField, "line 12: "},
      {damaged("inf\n", "inf\n\n"), ErrorCode::UnknownField, "line 12: "},
      {nothing_finite, ErrorCode::OutOfRange, "line 11: one cost at least is finite"},
      {eleven, ErrorCode::OutOfRange, "line 13: there are 2 to 10 variables"},
      {damaged("category 2 ring shape\nordered 3", "ordered 1000 a\nordered 1000 b\nordered 2"),
       ErrorCode::OutOfRange, "line 5: there are 4 to 1000000 combinations"}};
  for (const Malformed& malformed : all) {
    const Expected<LatticeTable> read = read_lattice(malformed.text);
    ASSERT_FALSE(read) << malformed.text;
    EXPECT_EQ(read.errors()[0].code, malformed.code) << malformed.text;
    EXPECT_EQ(read.errors()[0].message.substr(0, malformed.message.size()), malformed.message);
  }
}

TEST(LatticeTable, EveryTruncationBeforeTheLastLineIsAnError) {
  for (std::size_t length = 0; length <= kSmallText.size() - sizeof "inf\n" + 1; ++length)
    EXPECT_FALSE(read_lattice(std::string_view(kSmallText).substr(0, length))) << length;
}

}  // namespace
}  // namespace coapt::rivals
