#include "core/repair/repair_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/repair/apply_plan.h"
#include "io/json/plan_json.h"
#include "io/picture/picture.h"
#include "tests/io/picture/decoded_png.h"
#include "tests/scenes/sheets.h"
#include "tests/scenes/small_valve.h"

namespace coapt {
namespace {

ClosedValve marked(const Valve& valve, const RepairMarks& marks = {}) {
  const ClosureResult closure = closed_at_rest(valve);
  return {.valve = valve, .closure = closure, .measure = measure(valve, closure), .repair = marks};
}

Valve repaired(const RepairPlan& plan) {
  const Expected<Valve> valve = apply_plan(small_valve(), plan);
  EXPECT_TRUE(valve);
  return valve ? *valve : Valve{};
}

const RepairPlan kSuture{
    {PapillaryApproximation{Side::Posteromedial, Anchor::SaddlePeak, 0.25, 16.4013}}};
const RepairPlan kRing{{Annuloplasty{OwnRing{2}}}};
const RepairPlan kNeochorda{{Neochorda{"PM1", {Leaflet::Posterior, 0.7, 1.0}, 20.0}}};

TEST(RepairMarks, OfASutureAreItsAnchorAndTheTipBeforeAndAfter) {
  const RepairMarks marks = repair_marks(small_valve(), repaired(kSuture), kSuture);
  ASSERT_EQ(marks.sutures.size(), 1u);
  EXPECT_EQ(marks.annulus_before_mm.rows(), 0);
  const SutureMark& suture = marks.sutures[0];
  EXPECT_LT((suture.anchor_mm - Vec3(0.0, 14.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((suture.tip_before_mm - Vec3(12.0, -2.0, -26.0)).norm(), 1e-9);
  EXPECT_LT((suture.tip_mm - Vec3(6.0, 6.0, -13.0)).norm(), 1e-3);  // halfway
}

TEST(RepairMarks, OfARingAreTheAnnulusThatItDrewIn) {
  const RepairMarks marks = repair_marks(small_valve(), repaired(kRing), kRing);
  EXPECT_EQ(marks.annulus_before_mm, small_valve().annulus_mm);
  EXPECT_TRUE(marks.sutures.empty());
}

TEST(RepairMarks, OfNoRepairAreNone) {
  const RepairMarks marks = repair_marks(small_valve(), small_valve(), {});
  EXPECT_TRUE(marks.sutures.empty());
  EXPECT_EQ(marks.annulus_before_mm.rows(), 0);
}

/// The green of sutures and neochordae (palette::kAdded), which nothing else has.
bool is_added(std::uint32_t pixel) {
  const int red = pixel >> 16 & 0xFF, green = pixel >> 8 & 0xFF, blue = pixel & 0xFF;
  return red < 0x20 && green > 0x78 && green < 0x9c && blue > 0x50 && blue < 0x70;
}

long added_pixels(const std::string& png) {
  const DecodedPng picture = decode_png(png);
  return std::count_if(picture.pixels.begin(), picture.pixels.end(), is_added);
}

TEST(ClosurePicture, ShowsSuturesRingsAndNeochordaeOfARepairAndNothingElse) {
  EXPECT_EQ(added_pixels(closure_picture_png(marked(small_valve()))), 0);
  const auto picture = [](const RepairPlan& plan) {
    const Valve valve = repaired(plan);
    return closure_picture_png(marked(valve, repair_marks(small_valve(), valve, plan)));
  };
  EXPECT_GT(added_pixels(picture(kSuture)), 500) << "two views, legend";
  EXPECT_GT(added_pixels(picture(kNeochorda)), 200);
  EXPECT_NE(picture(kRing), closure_picture_png(marked(repaired(kRing))));
}

TEST(ComparisonPicture, DrawsTheRepairInTheViewsOfAfterAlone) {
  const Valve valve = repaired(kSuture);
  const ClosedValve after = marked(valve, repair_marks(small_valve(), valve, kSuture));
  const DecodedPng picture = decode_png(comparison_picture_png(marked(small_valve()), after));
  ASSERT_FALSE(picture.pixels.empty());
  long left = 0, right = 0;
  for (int y = 70; y < 980; ++y)  // the views, not the legend
    for (int x = 0; x < picture.width; ++x) {
      if (is_added(picture.pixels[static_cast<std::size_t>(y * picture.width + x)]))
        ++(x < picture.width / 2 ? left : right);
    }
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 300);
}

TEST(FirstPagePictures, AreDrawnAlsoOfValvesThatFlewApartOrHaveNoHeads) {
  ClosedValve broken = marked(small_valve());
  broken.closure.closed_mm(3, 1) = std::numeric_limits<double>::quiet_NaN();
  broken.measure = measure(broken.valve, broken.closure);
  ClosedValve disc = marked(disc_with_hole(15.0, 3.0));
  for (const ClosedValve* before : {&broken, &disc})
    for (const ClosedValve* after : {&broken, &disc}) {
      EXPECT_EQ(decode_png(atrial_pair_png(*before, *after)).width, 1920);
      EXPECT_EQ(decode_png(section_change_png(*before, *after)).width, 940);
    }
}

}  // namespace
}  // namespace coapt
