#include "io/exchange/feb.h"

#include <gtest/gtest.h>

#include "still_valve.h"

namespace coapt {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(Feb, NodesAreVerticesBranchPointsAndHeads) {
  const std::string feb = write_feb(small_valve());
  EXPECT_EQ(count(feb, "<node id="), 24U + 1U + 2U);
  EXPECT_NE(feb.find("<node id=\"1\">18,0,0</node>"), std::string::npos);
  EXPECT_NE(feb.find("<node id=\"25\">-12,-4,-21</node>"), std::string::npos);
  EXPECT_NE(feb.find("<node id=\"27\">12,-2,-26</node>"), std::string::npos);
  EXPECT_EQ(count(feb, "<elem id="), 32U);
}

TEST(Feb, ASpringIsSlackUntilItsRestLengthAndPullsFromThereOn) {
  Valve valve = small_valve();
  ChordaSegment& segment = valve.chordae[1].segments[0];
  segment.rest_length_mm += 2.0;  // 2 mm longer than it is far
  segment.diameter_mm = 2.0;
  const std::string feb = write_feb(valve);
  const std::size_t at = feb.find("name=\"2.1 PM1-A2-strut-1\" type=\"nonlinear spring\"");
  ASSERT_NE(at, std::string::npos);
  const std::string spring = feb.substr(at, 600);
  EXPECT_NE(spring.find("<pt>1,0</pt>"), std::string::npos) << spring;
  EXPECT_NE(spring.find("<pt>2,0</pt>"), std::string::npos) << spring;
  // 40 MPa x pi mm2 over the rest length.
  const double newtons = 40.0 * 3.14159265358979 / segment.rest_length_mm;
  const std::size_t last = spring.find("<pt>3,");
  ASSERT_NE(last, std::string::npos) << spring;
  EXPECT_NEAR(std::stod(spring.substr(last + 6)), newtons, 1e-6);
}

TEST(Feb, PressurePushesTowardsTheAtriumInMpa) {
  const std::string feb = write_feb(small_valve());
  EXPECT_NE(feb.find("<pressure lc=\"1\">-0.016</pressure>"), std::string::npos);
}

TEST(Feb, WhatStaysIsHeldAndWhatTravelsFollowsTheCurve) {
  Valve valve = small_valve();
  EXPECT_EQ(count(write_feb(valve), "prescribed displacement"), 0U);
  valve.annulus_mm.row(3) += Eigen::RowVector3d(0.5, -0.25, 1.0);
  const std::string feb = write_feb(valve);
  EXPECT_EQ(count(feb, "prescribed displacement"), 3U);
  EXPECT_NE(feb.find("<value lc=\"1\">-0.25</value>"), std::string::npos);
}

TEST(Feb, RupturedChordaeLeaveNothingBehind) {
  Valve valve = small_valve();
  valve.chordae[0].ruptured = true;
  const std::string feb = write_feb(valve);
  EXPECT_EQ(count(feb, "<DiscreteSet"), 1U);
  EXPECT_EQ(count(feb, "<node id="), 24U + 1U);  // without its branch point and head
}

TEST(Feb, NamesCannotBreakTheFile) {
  Valve valve = small_valve();
  valve.name = "<a> & --\"b\"\n";
  valve.chordae[0].id = "c--d<&>\"";
  const std::string feb = write_feb(valve);
  EXPECT_NE(feb.find("Valve _a_ _ -__b__"), std::string::npos);
  EXPECT_NE(feb.find("1.1 c-_d____"), std::string::npos);
}

}  // namespace
}  // namespace coapt
