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

UnitReading reading_of(const Points& annulus) {
  ImportSource source;
  source.annulus_mm = annulus;
  return unit_of(source);
}

TEST(SourceUnits, TheOnlyUnitThatMakesAUsualAnnulusIsTaken) {
  const Points circle = cone_source().annulus_mm;  // 113 mm round
  for (const LengthUnit unit :
       {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch, LengthUnit::Metre}) {
    const UnitReading read = reading_of(circle / in_mm(unit));
    EXPECT_EQ(read.unit, unit) << to_string(unit);
    EXPECT_EQ(read.look, unit == LengthUnit::Inch) << to_string(unit);
  }
}

TEST(SourceUnits, WhatIsUsualInTwoUnitsOrNoneIsLookedAt) {
  const Points circle = cone_source().annulus_mm;
  const UnitReading two = reading_of(circle * (7.5 / 113.0));  // 75 mm in cm, 190 mm in inches
  EXPECT_EQ(two.unit, LengthUnit::Centimetre);
  EXPECT_TRUE(two.look);
  EXPECT_NE(two.reason.find("mm if in in"), std::string::npos) << two.reason;
  for (const double length : {0.02, 0.5, 2.5, 25.0, 400.0})
    EXPECT_TRUE(reading_of(circle * (length / 113.0)).look) << length;
  EXPECT_FALSE(reading_of(circle.topRows(2)).look) << "no annulus, which is refused later";
}

TEST(SourceUnits, LeafletsOfASizeThatNoHeartHasAreRefused) {
  for (const double factor : {0.0001, 20.0}) {
    ImportSource source = cone_source();
    source.annulus_mm.resize(0, 3);
    scale(source, factor);
    const Expected<Valve> valve = import_valve(source, {});
    ASSERT_FALSE(valve) << factor;
    EXPECT_EQ(valve.errors().front().path, "/leaflets") << factor;
  }
}

TEST(SourceUnits, FilesThatStateTheirUnitAreNotGuessed) {
  ImportSource source = cone_source();
  scale(source, 0.1);
  source.unit = LengthUnit::Millimetre;
  EXPECT_EQ(unit_of(source).unit, LengthUnit::Millimetre);
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

TEST(SourceUnits, AMirrorImageIsTurnedRound) {
  const Valve reference = *import_valve(cone_source(), {});
  ImportSource mirrored = cone_source();
  unmirror(mirrored);
  EXPECT_LT((mirrored.annulus_mm.col(0) + cone_source().annulus_mm.col(0)).norm(), 1e-12);
  ImportOptions options;
  options.mirrored = true;
  const Expected<Valve> valve = import_valve(mirrored, options);
  ASSERT_TRUE(valve) << valve.errors().front().message;
  EXPECT_LT((valve->rest_mm - reference.rest_mm).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NE(std::find(valve->provenance.begin(), valve->provenance.end(),
                      "frame: all files mirrored (x reversed); they are a mirror image, as given"),
            valve->provenance.end());
}

TEST(SourceUnits, TheAtriumIsNotTurnedWhereTipsTell) {
  ImportOptions options;
  options.flip = true;
  const Expected<Valve> valve = import_valve(cone_source(), options);
  ASSERT_FALSE(valve);
  EXPECT_EQ(valve.errors()[0].path, "/flip");
}

TEST(SourceUnits, AnAnnulusThatStatesItsUnitIsOfTheFilesOrBroughtToMillimetres) {
  ImportSource alike = cone_source();
  scale(alike, 0.1);
  take_annulus_unit(alike, LengthUnit::Centimetre);
  EXPECT_EQ(alike.unit, LengthUnit::Centimetre);
  ImportSource alone = cone_source();
  const Points annulus = alone.annulus_mm;
  alone.annulus_mm *= 0.1;
  take_annulus_unit(alone, LengthUnit::Centimetre);
  EXPECT_FALSE(alone.unit);
  EXPECT_TRUE(alone.annulus_mm.isApprox(annulus, 1e-12));
  ImportSource labels = cone_source();
  labels.unit = LengthUnit::Millimetre;
  labels.annulus_mm *= 0.1;
  take_annulus_unit(labels, LengthUnit::Centimetre);
  EXPECT_TRUE(labels.annulus_mm.isApprox(annulus, 1e-12));
}

TEST(SourceUnits, TablesOfAnotherUnitBecomeThatOfTheLeaflets) {
  const ImportSource reference = cone_source();
  ImportSource source = reference;
  for (ImportedChorda& chorda : source.chordae) {
    chorda.insertion_mm *= 0.1;
    chorda.tip_mm *= 0.1;
  }
  source.chordae_unit = LengthUnit::Centimetre;
  source.tips_unit = LengthUnit::Millimetre;
  const auto told = take_part_units(source, LengthUnit::Millimetre);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(sentence(told[0]),
            "units: chordae in cm, converted to mm; stated by the names of the columns");
  EXPECT_TRUE(source.chordae[0].tip_mm.isApprox(reference.chordae[0].tip_mm));
  EXPECT_TRUE(source.chordae[0].insertion_mm.isApprox(reference.chordae[0].insertion_mm));
}

TEST(SourceUnits, LeafletsThatAreAsLargeAsTheAnnulusOnlyInMetresAreInMetres) {
  const ImportSource reference = cone_source();
  ImportSource source = reference;
  source.leaflets[0].vertices_mm *= 0.001;
  take_metres(source);
  EXPECT_TRUE(source.leaflets[0].vertices_mm.isApprox(reference.leaflets[0].vertices_mm));
  EXPECT_EQ(source.decisions.size(), 1U);
  for (const double factor : {1.0, 0.1}) {
    ImportSource other = reference;
    other.leaflets[0].vertices_mm *= factor;
    take_metres(other);
    EXPECT_TRUE(other.leaflets[0].vertices_mm.isApprox(factor * reference.leaflets[0].vertices_mm));
    EXPECT_TRUE(other.decisions.empty());
  }
}

}  // namespace
}  // namespace coapt
