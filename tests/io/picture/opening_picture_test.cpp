#include "io/picture/opening_picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/repair/apply_plan.h"
#include "tests/io/picture/decoded_png.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

TEST(OpeningPicture, SaysWhatWasMeasured) {
  const OpeningMeasure measure{450.0, 400.0, 1340.0, 0.96, 1.88, 155.0, 217.0};
  EXPECT_EQ(opening_words(measure),
            (std::vector<std::string>{
                "Opening 4.5 cm²", "mean gradient 1.0 mmHg at 155 ml/s, 1.9 mmHg at 217 ml/s",
                "projected on the annular plane 4.0 cm²; annulus in diastole 13.4 cm²"}));
  OpeningMeasure unknown = measure;
  unknown.opening_area_mm2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(opening_words(unknown).empty());
}

TEST(OpeningPicture, ShowsTheOpeningInBothViewsWhereItIsKnown) {
  const Valve& valve = small_preset("human-normal");
  OpenedValve opened = *open_valve(valve);
  const auto drawn = [&] { return decode_png(opening_picture_png(opened, valve, {})); };
  const DecodedPng known = drawn();
  EXPECT_GT(blue_pixels(known, 0, 960), 1000);
  EXPECT_GT(blue_pixels(known, 960, known.width), 100);
  opened.closure.status = ClosureStatus::StepLimit;
  opened.leak = {};
  opened.measure.opening_area_mm2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(blue_pixels(drawn(), 0, known.width), 0);
  opened.closure.closed_mm(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(drawn().pixels.empty());
}

TEST(OpeningPicture, DrawsNoRimBehindTheAtriumsWall) {
  const Valve& valve = small_preset("human-normal");
  OpenedValve opened = *open_valve(valve);
  const auto blue = [&] {
    return blue_pixels(decode_png(opening_picture_png(opened, valve, {})), 0, 960);
  };
  for (LeakOpening& opening : opened.leak.openings)
    opening.surface.points_mm.col(1).array() += 60.0;
  const long beyond = blue();
  for (LeakOpening& opening : opened.leak.openings) opening.surface = {};
  EXPECT_EQ(beyond, blue());
}

TEST(OpeningPicture, ARepairedValveHasItsRing) {
  const Valve& valve = small_preset("human-normal");
  const RepairPlan plan{{Annuloplasty{CatalogueRing{"generic-classic", 28.0}}}};
  const OpenedValve opened = *open_valve(*apply_plan(valve, plan));
  const std::string png = opening_picture_png(opened, valve, plan);
  EXPECT_EQ(png, opening_picture_png(opened, valve, plan));
  EXPECT_NE(png, opening_picture_png(opened, opened.valve, {}));
}

}  // namespace
}  // namespace coapt
