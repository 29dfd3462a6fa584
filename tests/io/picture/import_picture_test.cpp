#include "io/picture/import_picture.h"

#include <gtest/gtest.h>

#include "tests/io/mesh/cone_scene.h"
#include "tests/io/picture/decoded_png.h"

namespace coapt {
namespace {

/// Pixels in the colour of what is far from what was given.
long purple_pixels(const DecodedPng& png) {
  long count = 0;
  for (const std::uint32_t pixel : png.pixels) {
    const std::uint32_t red = pixel >> 16 & 0xFFu, green = pixel >> 8 & 0xFFu, blue = pixel & 0xFFu;
    count += red > 0x38u && red < 0x90u && green < 0x38u && blue > 0x48u && blue < 0x98u;
  }
  return count;
}

TEST(ImportPicture, ColoursWhatLiesOffWhatWasGiven) {
  ImportedValve imported = *import_with_decisions(cone_source(), {});
  const DecodedPng good = decode_png(import_picture_png(imported, "a cone"));
  ASSERT_EQ(good.width, 1500);
  imported.valve.rest_mm.bottomRows(imported.valve.rest_mm.rows() / 2).array() *= 0.85;
  const DecodedPng off = decode_png(import_picture_png(imported, "a cone"));
  EXPECT_LT(purple_pixels(good), 200) << "the bar of colours alone";
  EXPECT_GT(purple_pixels(off), 5000);
}

TEST(ImportPicture, IsDrawnOfClosedLeafletsAndOfTipsAlone) {
  ImportSource source = cone_source_with_gaps();
  source.chordae.clear();
  ImportOptions options;
  options.chordae_seed = 1;
  ImportedValve imported = *import_with_decisions(source, options);
  imported.input.closed = true;
  EXPECT_EQ(purple_pixels(decode_png(import_picture_png(imported, ""))), 0);
}

}  // namespace
}  // namespace coapt
