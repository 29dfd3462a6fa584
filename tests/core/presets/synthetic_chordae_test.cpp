#include "core/presets/synthetic_chordae.h"

#include <gtest/gtest.h>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/valve/validate.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

Valve human() { return shared_preset("human-normal", 400); }
const Points kUnseen = Points(0, 3);

TEST(SyntheticChordae, TheSameSeedGivesTheSameValveAndAnotherAnother) {
  const Expected<Valve> one = with_synthetic_chordae(human(), 7, kUnseen);
  const Expected<Valve> again = with_synthetic_chordae(human(), 7, kUnseen);
  const Expected<Valve> other = with_synthetic_chordae(human(), 8, kUnseen);
  ASSERT_TRUE(one);
  ASSERT_TRUE(again);
  ASSERT_TRUE(other);
  EXPECT_EQ(one->chordae, again->chordae);
  EXPECT_NE(one->chordae, other->chordae);
  EXPECT_EQ(one->drawn_chordae, (DrawnChordae{7, false}));
  EXPECT_TRUE(validate(*one).empty());
}

TEST(SyntheticChordae, EveryDrawHasBothMusclesAndAllKindsWithinAnatomy) {
  for (int seed = 0; seed < 12; ++seed) {
    const Expected<Valve> drawn = with_synthetic_chordae(human(), seed, kUnseen);
    ASSERT_TRUE(drawn) << seed;
    int marginal[2] = {0, 0}, others[2] = {0, 0};
    for (const Chorda& chorda : drawn->chordae) {
      const int side =
          drawn->heads[static_cast<std::size_t>(chorda.head)].side == Side::Anterolateral ? 0 : 1;
      ++(chorda.kind == ChordaKind::Marginal ? marginal : others)[side];
    }
    for (const int side : {0, 1}) {
      EXPECT_GE(marginal[side], 3) << seed;
      EXPECT_LE(marginal[side], 7) << seed;
      EXPECT_EQ(others[side], 3) << seed;
    }
  }
}

TEST(SyntheticChordae, TheMeanAnatomyIsCompetentWhereTheValveWas) {
  const Expected<Valve> mean = with_synthetic_chordae(human(), 0, kUnseen);
  ASSERT_TRUE(mean);
  const ClosureResult closed = close_valve(*mean);
  EXPECT_EQ(closed.status, ClosureStatus::Converged);
  EXPECT_FALSE(closed.crossing);
  EXPECT_LT(measure(*mean, closed).leak.area_mm2, 2.0);
}

TEST(SyntheticChordae, TipsThatWereSeenStayInEveryDraw) {
  Points tips(2, 3);
  tips << -13.0, -4.0, -24.0, 12.0, -5.0, -22.0;
  const Expected<Valve> seen = with_synthetic_chordae(human(), 3, tips);
  ASSERT_TRUE(seen);
  EXPECT_TRUE(seen->drawn_chordae->tips_given);
  const Expected<Valve> other = redrawn_chordae(*seen, 4);
  ASSERT_TRUE(other);
  ASSERT_EQ(seen->heads.size(), other->heads.size());
  for (std::size_t i = 0; i < seen->heads.size(); ++i)
    EXPECT_EQ(seen->heads[i].tip_mm, other->heads[i].tip_mm);
  EXPECT_NE(seen->chordae, other->chordae);
}

TEST(SyntheticChordae, DiseaseMovesTheTipsOfEveryDrawAlike) {
  Valve valve = human();
  for (PapillaryHead& head : valve.heads)
    if (head.side == Side::Posteromedial) head.tip_mm += Vec3(3.0, -2.0, -4.0);
  const Expected<Valve> drawn = with_synthetic_chordae(valve, 5, kUnseen);
  ASSERT_TRUE(drawn);
  for (const PapillaryHead& head : drawn->heads) {
    const Vec3 by = head.side == Side::Posteromedial ? Vec3(3.0, -2.0, -4.0) : Vec3::Zero();
    EXPECT_LT((head.tip_mm - head.rest_mm - by).norm(), 1e-12);
  }
}

TEST(SyntheticChordae, TipsThatAreNoneAreRefused) {
  Points one_side(2, 3), above(2, 3);
  one_side << 13.0, -4.0, -24.0, 12.0, -5.0, -22.0;
  above << -13.0, -4.0, 24.0, 12.0, -5.0, -22.0;
  EXPECT_EQ(with_synthetic_chordae(human(), 1, one_side).errors().front().path, "/tips_mm");
  EXPECT_EQ(with_synthetic_chordae(human(), 1, above).errors().front().path, "/tips_mm/0");
}

TEST(SyntheticChordae, LengthsAreTakenWithinABudgetOrNotAtAll) {
  const Expected<Valve> spent = with_synthetic_chordae(human(), 1, kUnseen, {1000.0});
  ASSERT_FALSE(spent);
  EXPECT_EQ(spent.errors().front().code, ErrorCode::OutOfRange);
  EXPECT_TRUE(spent.errors().front().message.starts_with(
      "the closure that determines chordal lengths takes more than 1000"));
  const Expected<Valve> within = with_synthetic_chordae(human(), 1, kUnseen, {1e9});
  ASSERT_TRUE(within);
  EXPECT_EQ(within->chordae, with_synthetic_chordae(human(), 1, kUnseen)->chordae);
}

}  // namespace
}  // namespace coapt
