#include "io/picture/heat_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <string>

namespace coapt {
namespace {

/// Where a word stands.
std::array<double, 2> place_of(const std::string& svg, const std::string& word) {
  const std::regex text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>" + word + "<");
  std::smatch found;
  if (!std::regex_search(svg, found, text)) return {NAN, NAN};
  return {std::stod(found[1]), std::stod(found[2])};
}

TEST(HeatMap, WordsOfColumnsStandBelowTheMiddleOfTheirCells) {
  const HeatMap map{"Title", "rows", {"r0", "r1"}, {"c0", "c1"}, {"block"}, {{{1, 2}, {3, 4}}}};
  const PlotBox box{10.0, 20.0, 210.0, 220.0};
  const std::string svg = draw_heat_map(map, {0.0, 4.0, 0}, box);
  for (const auto& [column, lowest, highest] :
       {std::array{"c0", "1", "3"}, std::array{"c1", "2", "4"}}) {
    const auto word = place_of(svg, column), cell = place_of(svg, lowest);
    EXPECT_NEAR(word[0], cell[0], 0.1) << svg;
    EXPECT_NEAR(word[0], place_of(svg, highest)[0], 0.1);
    EXPECT_GT(word[1], cell[1] + 20.0) << "below the lowest row";
    EXPECT_LE(word[1], box.bottom);
  }
  EXPECT_LT(place_of(svg, "c0")[0], place_of(svg, "c1")[0]);
}

}  // namespace
}  // namespace coapt
