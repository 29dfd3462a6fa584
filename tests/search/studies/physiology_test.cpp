#include "search/studies/physiology.h"

#include <gtest/gtest.h>

#include <set>

#include "core/metrics/annular_force.h"
#include "core/metrics/measure.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

using enum PhysiologyTrial;

double value_of(const PhysiologyValues& values, const char* quantity) {
  return values.*find_quantity(quantity)->value;
}

TEST(PhysiologyRanges, AreOfQuantitiesThatThereAreAndSayTheirSourceOnceForEachKind) {
  std::set<std::tuple<std::string, ValveKind, Species>> known;
  for (const PhysiologyRange& range : physiology_ranges()) {
    EXPECT_NE(find_quantity(range.quantity), nullptr) << range.quantity;
    EXPECT_LT(range.low, range.high) << range.quantity;
    EXPECT_FALSE(std::string(range.source).empty()) << range.quantity;
    for (const ValveKind kind : range.kinds)
      for (const Species species : range.species)
        EXPECT_TRUE(known.insert({range.quantity, kind, species}).second) << range.quantity;
  }
}

TEST(PhysiologyRanges, DependOnTheKindOfValve) {
  EXPECT_LT(find_range("tenting_area", ValveKind::Healthy, Species::Human)->high,
            find_range("tenting_area", ValveKind::Functional, Species::Human)->high);
  EXPECT_EQ(find_range("tenting_area", ValveKind::Healthy, Species::Porcine), nullptr);
  EXPECT_EQ(find_range("no such", ValveKind::Healthy, Species::Human), nullptr);
}

TEST(PhysiologyRow, IsMetBelowAboveUnknownOrWithoutRange) {
  const PhysiologyQuantity& area = *find_quantity("tenting_area");
  PhysiologyValues values;
  const auto verdict = [&](double tenting_area_mm2, ValveKind kind) {
    values.tenting_area_mm2 = tenting_area_mm2;
    return physiology_row(area, values, kind, Species::Human).verdict;
  };
  EXPECT_EQ(verdict(60.0, ValveKind::Healthy), PhysiologyVerdict::Met);
  EXPECT_EQ(verdict(59.9, ValveKind::Healthy), PhysiologyVerdict::Below);
  EXPECT_EQ(verdict(201.0, ValveKind::Healthy), PhysiologyVerdict::Above);
  EXPECT_EQ(verdict(100.0, ValveKind::Prolapse), PhysiologyVerdict::NoRange);
  EXPECT_EQ(verdict(PhysiologyValues::kUnknown, ValveKind::Healthy), PhysiologyVerdict::Unknown);
}

TEST(Kind, IsJudgedByLeakRupturesAndTenting) {
  Valve valve;
  PhysiologyValues values;
  values.leak_mm2 = 4.9;
  values.tenting_area_mm2 = -10.0;
  EXPECT_EQ(kind_of(valve, values), ValveKind::Healthy);
  values.leak_mm2 = 5.1;
  EXPECT_EQ(kind_of(valve, values), ValveKind::Prolapse);
  values.tenting_area_mm2 = 10.0;
  EXPECT_EQ(kind_of(valve, values), ValveKind::Functional);
  Chorda ruptured;
  ruptured.ruptured = true;
  valve.chordae.push_back(ruptured);
  EXPECT_EQ(kind_of(valve, values), ValveKind::Prolapse);
  EXPECT_EQ(species_of(valve), Species::Human);
  valve.name = "porcine-2 remodelled";
  EXPECT_EQ(species_of(valve), Species::Porcine);
}

TEST(Physiology, MusclesTakeWhatTheChordaePull) {
  const Valve& valve = small_preset("human-normal");
  const PhysiologyValues values = physiology_values(valve, {.trials = {Rest}});
  const ClosureResult closure = close_valve(valve);
  EXPECT_EQ(values.leak_mm2, measure(valve, closure).leak.area_mm2);
  // Both pull down and inwards, so their sum is less than the two.
  const double both = values.muscle_anterolateral_n + values.muscle_posteromedial_n;
  EXPECT_GT(both, support_forces(valve, closure).papillary_n.norm());
  EXPECT_LT(both, 1.3 * support_forces(valve, closure).papillary_n.norm());
  EXPECT_TRUE(std::isnan(values.ring_30_mm2));
  EXPECT_TRUE(std::isnan(values.struts_cut_ratio));
}

TEST(Physiology, StrutsThatBearGiveTheirLoadToMarginalChordaeWhenTheyAreCut) {
  Valve valve = small_preset("human-normal");
  const PhysiologyOptions options{.trials = {StrutsCut}};
  const PhysiologyValues taut = physiology_values(valve, options);
  for (Chorda& chorda : valve.chordae)
    if (chorda.kind == ChordaKind::Strut)
      for (ChordaSegment& segment : chorda.segments) segment.rest_length_mm *= 1.4;
  const PhysiologyValues idle = physiology_values(valve, options);
  EXPECT_LT(idle.strut_n, 0.3 * idle.anterior_marginal_n);
  EXPECT_NEAR(idle.struts_cut_ratio, 1.0, 0.1);
  EXPECT_GT(taut.strut_over_marginal, 1.0);
  EXPECT_GT(taut.struts_cut_ratio, 1.5);
  EXPECT_EQ(value_of(taut, "struts_cut_ratio"), taut.struts_cut_ratio);
}

TEST(Physiology, IsTheSameForAnyNumberOfThreadsAndTellsItsTrials) {
  PhysiologyOptions options{.trials = {Pressures}, .threads = 1};
  const Valve& valve = small_preset("human-functional-mr");
  const PhysiologyValues one = physiology_values(valve, options);
  options.threads = 2;
  int told = 0;
  options.progress = [&](int done, int planned) {
    told = done;
    EXPECT_EQ(planned, 4);
  };
  const PhysiologyValues two = physiology_values(valve, options);
  EXPECT_EQ(told, 4);
  EXPECT_EQ(one.leak_mm2, two.leak_mm2);
  EXPECT_EQ(one.leak_200_over_60, two.leak_200_over_60);
  EXPECT_GT(one.leak_60_mm2, one.leak_90_mm2);
  EXPECT_GT(one.leak_90_mm2, one.leak_mm2);
  EXPECT_GT(one.leak_mm2, one.leak_200_mm2);
}

TEST(Physiology, HasARowForEachQuantityOfItsTrials) {
  const Physiology rest = study_physiology(small_preset("human-normal"), {.trials = {}});
  EXPECT_EQ(rest.kind, ValveKind::Healthy);
  EXPECT_TRUE(rest.kind_judged);
  std::size_t expected = 0;
  for (const PhysiologyQuantity& quantity : physiology_quantities())
    if (quantity.trial == Rest) ++expected;
  EXPECT_EQ(rest.rows.size(), expected);
  const Physiology said =
      study_physiology(small_preset("human-normal"),
                       {.trials = {}, .kind = ValveKind::Functional, .species = Species::Porcine});
  EXPECT_EQ(said.kind, ValveKind::Functional);
  EXPECT_FALSE(said.kind_judged);
  EXPECT_FALSE(said.species_judged);
}

}  // namespace
}  // namespace coapt
