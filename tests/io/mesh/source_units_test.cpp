#include "io/mesh/source_units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "cone_scene.h"

namespace coapt {
namespace {

/// A valve's own numbers, those of a valve whose source had another unit.
void expect_same(const Expected<Valve>& valve, const Valve& reference, const std::string& unit) {
  ASSERT_TRUE(valve) << valve.errors().front().message;
  EXPECT_LT((valve->rest_mm - reference.rest_mm).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((valve->patient->origin_mm - reference.patient->origin_mm).norm(), 1e-9);
  EXPECT_NE(std::find(valve->provenance.begin(), valve->provenance.end(), unit),
            valve->provenance.end())
      << unit;
}

TEST(SourceUnits, MetresAndCentimetresAreGuessedFromTheAnnulus) {
  const Valve reference = *import_valve(cone_source(), {});
  ImportSource metres = cone_source(), centimetres = cone_source();
  scale(metres, 0.001);
  scale(centimetres, 0.1);
  const std::string by = "; by the annulus's circumference";
  expect_same(import_valve(cone_source(), {}), reference, "units: mm" + by);
  expect_same(import_valve(metres, {}), reference, "units: m" + by);
  expect_same(import_valve(centimetres, {}), reference, "units: cm" + by);
}

TEST(SourceUnits, GivenUnitsAreTaken) {
  ImportSource centimetres = cone_source();
  scale(centimetres, 0.1);
  expect_same(import_valve(centimetres, {.units = LengthUnit::Centimetre}),
              *import_valve(cone_source(), {}), "units: cm; as given");
}

TEST(SourceUnits, NothingIsGuessedFromWhatIsNoAnnulus) {
  const Points circle = cone_source().annulus_mm;  // 113 mm round
  EXPECT_EQ(guessed_unit(circle), LengthUnit::Millimetre);
  EXPECT_EQ(guessed_unit(0.1 * circle), LengthUnit::Centimetre);
  EXPECT_EQ(guessed_unit(0.001 * circle), LengthUnit::Metre);
  EXPECT_EQ(guessed_unit(0.0001 * circle), std::nullopt);
  EXPECT_EQ(guessed_unit(10.0 * circle), std::nullopt);
  EXPECT_EQ(guessed_unit(circle.topRows(2)), std::nullopt);
  EXPECT_EQ(guessed_unit(circle * std::numeric_limits<double>::quiet_NaN()), std::nullopt);
}

TEST(SourceUnits, LengthsAndPlacesAreScaledDiametersAreNot) {
  ImportSource source = cone_source();
  ImportedChorda& chorda = source.chordae.front();
  chorda.pressed_tip_mm = Vec3(1.0, 2.0, 3.0);
  chorda.segments.push_back({-1, Vec3(4.0, 5.0, 6.0), true, 7.0, 1.5});
  scale(source, 10.0);
  EXPECT_EQ(*chorda.pressed_tip_mm, Vec3(10.0, 20.0, 30.0));
  EXPECT_EQ(chorda.segments[0].end_mm, Vec3(40.0, 50.0, 60.0));
  EXPECT_EQ(chorda.segments[0].rest_length_mm, 70.0);
  EXPECT_EQ(chorda.segments[0].diameter_mm, 1.5);
}

}  // namespace
}  // namespace coapt
