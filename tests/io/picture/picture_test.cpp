#include "io/picture/picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/metrics/coaptation.h"
#include "io/picture/distance_map.h"
#include "io/picture/section_map.h"
#include "tests/io/picture/decoded_png.h"
#include "tests/scenes/sheets.h"
#include "tests/scenes/small_preset.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

ClosedValve closed(Valve valve) {
  const ClosureResult closure = closed_at_rest(valve);
  const ValveMeasure measured = measure(valve, closure);
  return {std::move(valve), closure, measured};
}

TEST(ClosurePicture, ShowsAHoleInTheBlueOfLeaksAndASoundDiscWithout) {
  const DecodedPng leaking = decode_png(closure_picture_png(closed(disc_with_hole(15.0, 5.0))));
  ASSERT_EQ(leaking.width, 1600);
  const DecodedPng sound = decode_png(closure_picture_png(closed(disc_with_hole(15.0, 0.4))));
  EXPECT_EQ(blue_pixels(sound, 0, sound.width), 0);
  // A hole of radius 5 less half a millimetre and half of its rim's line, at 20.5 pixels a millimetre: (700 - 84) / 30.
  const double expected = std::numbers::pi * 4.6 * 4.6 * 20.533 * 20.533;
  const auto blue = static_cast<double>(blue_pixels(leaking, 0, 960));
  EXPECT_LT(blue, 1.1 * expected);
  EXPECT_GT(blue, 0.8 * expected) << "label and leader cover some of it";
}

TEST(ClosurePicture, ShowsALeakThatTissueHides) {
  const ClosedValve flail = close_and_measure(small_preset("human-p2-prolapse"));
  ASSERT_GT(flail.measure.leak.area_mm2, 20.0);
  EXPECT_GT(blue_pixels(decode_png(closure_picture_png(flail)), 0, 960), 2000);
}

TEST(SectionMap, HoldsLeafletsThatBillowAndTipsThatLieAside) {
  ClosedValve valve = closed(small_valve());
  const Box box{960.0, 110.0, 608.0, 510.0};
  for (const double billow_mm : {0.0, 30.0})
    for (const double aside_mm : {-60.0, 0.0, 60.0}) {
      ClosedValve moved = valve;
      moved.closure.closed_mm.col(2).array() += billow_mm;
      for (PapillaryHead& head : moved.valve.heads) head.tip_mm.y() += aside_mm;
      const SectionMap map = section_map({box, section_scale(box, moved)}, moved);
      std::vector<Vec3> points;
      for (const SectionLine& line :
           cut(moved.valve.faces, moved.closure.closed_mm, mid_valve_plane(moved.valve)))
        points.insert(points.end(), line.points_mm.begin(), line.points_mm.end());
      for (const PapillaryHead& head : moved.valve.heads) points.push_back(head.tip_mm);
      for (const Vec3& point : points) {
        EXPECT_GT(map(point).x(), box.x + 6.0);
        EXPECT_LT(map(point).x(), box.x + box.width - 6.0);
        EXPECT_GT(map(point).y(), box.y + 40.0);
        EXPECT_LT(map(point).y(), box.y + box.height - 60.0);
      }
    }
}

TEST(ClosurePicture, IsTheSameEveryTime) {
  const ClosedValve valve = closed(small_valve());
  EXPECT_EQ(closure_picture_png(valve), closure_picture_png(valve));
}

TEST(ClosurePicture, HostileNamesAndMissingChordaeDoNoHarm) {
  ClosedValve valve = closed(small_valve());
  const DecodedPng plain = decode_png(closure_picture_png(valve));
  valve.valve.name = "\xFF\xC0 broken \n" + std::string(5000, 'W');
  valve.closure.branch_points_mm.clear();
  const DecodedPng hostile = decode_png(closure_picture_png(valve));
  ASSERT_EQ(hostile.pixels.size(), plain.pixels.size());
  // The caption and the notice, below the drawings, are still there and the same.
  const auto bottom = [](const DecodedPng& png) {
    return std::vector<std::uint32_t>(png.pixels.end() - 200 * png.width, png.pixels.end());
  };
  EXPECT_EQ(bottom(hostile), bottom(plain));
}

TEST(ClosurePicture, OfAClosureThatFlewApartSaysSo) {
  ClosedValve valve = closed(disc_with_hole(15.0, 5.0));
  valve.closure.status = ClosureStatus::Diverged;
  valve.closure.closed_mm(3, 1) = std::numeric_limits<double>::infinity();
  valve.measure = measure(valve.valve, valve.closure);
  const DecodedPng picture = decode_png(closure_picture_png(valve));
  EXPECT_FALSE(picture.pixels.empty());
  EXPECT_EQ(blue_pixels(picture, 0, picture.width), 0);
}

TEST(ClosurePicture, OfAClosureThatIsNotToBeTrustedWarns) {
  ClosedValve valve = closed(disc_with_hole(15.0, 5.0));
  const auto warned = [&] { return warns(decode_png(closure_picture_png(valve))); };
  EXPECT_FALSE(warned());
  valve.closure.crossing = true;
  EXPECT_TRUE(warned());
  valve.closure.crossing = false;
  valve.closure.status = ClosureStatus::StepLimit;
  EXPECT_TRUE(warned());
}

TEST(DistanceMap, SaysWhatIsNotToBeTrusted) {
  const ClosedValve disc = closed(disc_with_hole(15.0, 5.0));
  DistanceMap map{disc.closure.closed_mm,
                  disc.valve.faces,
                  std::vector<double>(disc.valve.rest_mm.rows(), 0.0),
                  1.0,
                  "disc",
                  ""};
  const auto warned = [&] { return warns(decode_png(distance_map_png(map))); };
  EXPECT_FALSE(warned());
  map.doubt = "closed: UNRELIABLE: leaflets cross";
  EXPECT_TRUE(warned());
}

TEST(ComparisonPicture, ShowsBeforeLeftAndAfterRightInOneScale) {
  const ClosedValve leaking = closed(disc_with_hole(15.0, 5.0));
  const ClosedValve sound = closed(disc_with_hole(15.0, 0.4));
  const DecodedPng picture = decode_png(comparison_picture_png(leaking, sound));
  EXPECT_GT(blue_pixels(picture, 0, 650), 1000);
  EXPECT_EQ(blue_pixels(picture, 650, 1300), 0);
  // The same hole is as large beside a larger valve as beside itself, if that sets the scale of
  // both.
  const ClosedValve large = closed(disc_with_hole(25.0, 5.0));
  const DecodedPng twice = decode_png(comparison_picture_png(large, large));
  const DecodedPng mixed = decode_png(comparison_picture_png(leaking, large));
  const auto left = static_cast<double>(blue_pixels(mixed, 0, 650));
  EXPECT_NEAR(left, static_cast<double>(blue_pixels(twice, 650, 1300)), 0.02 * left);
}

}  // namespace
}  // namespace coapt
