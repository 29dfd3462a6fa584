// Cases of a small valve, of each exam a few.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "search/training/exam_a.h"
#include "search/training/exam_b.h"
#include "search/training/scripted_raters.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

constexpr int kCases = 6;  // so many that a rule of theirs that is left out shows

class TrainingCases : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    valve = new Valve(small_preset("human-normal"));
    for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
      cases_a.push_back(*make_exam_a(*valve, seed));
      cases_b.push_back(*make_exam_b(*valve, seed + 1));
    }
  }
  static void TearDownTestSuite() {
    cases_a.clear();
    cases_b.clear();
    delete valve;
    valve = nullptr;
  }
  static inline Valve* valve = nullptr;
  static inline std::vector<ExamACase> cases_a;
  static inline std::vector<ExamBCase> cases_b;
};

double apart_mm(const Points& one, const Points& other) {
  return std::sqrt((one - other).rowwise().squaredNorm().mean());
}

TEST_F(TrainingCases, OfExamALookAlikeAndCloseDifferently) {
  const FreeEdge edge = *free_edge(*valve);
  for (const ExamACase& made : cases_a)
    for (std::size_t i = 0; i < kChoices; ++i) {
      EXPECT_TRUE(trusted(made.choices[i].closed.closure));
      EXPECT_LE(scaled(made.choices[i].half_speed, {}), 0.5);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_LT(apart_mm(made.choices[i].flaccid_mm, made.choices[j].flaccid_mm), 0.3);
        const double edge_mm = edge_difference_mm(edge, made.choices[i].closed.closure.closed_mm,
                                                  made.choices[j].closed.closure.closed_mm);
        EXPECT_TRUE(edge_mm >= 1.0 || made.differences[i][j].leak_mm2 >= 10.0);
        EXPECT_GE(made.smallest_difference, 1.0);
        EXPECT_DOUBLE_EQ(made.differences[i][j].edge_mm, edge_mm);
      }
    }
}

TEST_F(TrainingCases, AreTheirLesionsAndNothingElse) {
  for (const ExamACase& made : cases_a)
    for (const CaseChoice& choice : made.choices) {
      const Valve& changed = choice.closed.valve;
      EXPECT_EQ(changed.rest_mm, valve->rest_mm);
      EXPECT_EQ(changed.annulus_mm, valve->annulus_mm);
      const Valve again = *with_lesions(*valve, choice.lesions);
      EXPECT_EQ(again.chordae, changed.chordae);
      for (std::size_t h = 0; h < again.heads.size(); ++h)
        EXPECT_EQ(again.heads[h].tip_mm, changed.heads[h].tip_mm);
    }
}

TEST_F(TrainingCases, AreTheSameForTheSameSeed) {
  const ExamACase again = *make_exam_a(*valve, 1);
  EXPECT_EQ(again.answer, cases_a[0].answer);
  for (std::size_t i = 0; i < kChoices; ++i)
    EXPECT_EQ(again.choices[i].closed.closure.closed_mm,
              cases_a[0].choices[i].closed.closure.closed_mm);
  EXPECT_NE(cases_a[1].choices[0].closed.closure.closed_mm,
            cases_a[0].choices[0].closed.closure.closed_mm);
}

TEST_F(TrainingCases, OfExamBHaveAllThreeTruthsByWhatThePullReached) {
  for (const ExamBCase& made : cases_b) {
    std::set<Mobility> kinds;
    for (const SegmentTruth& truth : made.truths) {
      const double change_mm = truth.height_mm - truth.normal_mm;
      EXPECT_EQ(truth.mobility, change_mm > 2.0    ? Mobility::Prolapsing
                                : change_mm < -2.0 ? Mobility::Tethered
                                                   : Mobility::Normal);
      EXPECT_GE(std::abs(std::abs(change_mm) - 2.0), 0.25);
      kinds.insert(truth.mobility);
    }
    EXPECT_EQ(kinds.size(), 3u);
    EXPECT_LT(made.flaccid_difference_mm, 0.3);
  }
}

TEST_F(TrainingCases, LongerChordaeLetOnlyTheirSegmentRise) {
  const FreeEdge edge = *free_edge(*valve);
  const SegmentHeights before = pulled_heights_mm(*valve, edge);
  const Valve longer = *with_lesions(*valve, {{{Segment::P2, std::nullopt, 1.15}}, {}});
  const SegmentHeights after = pulled_heights_mm(longer, edge);
  for (const Segment segment : kAllSegments) {
    const auto s = static_cast<std::size_t>(segment);
    if (segment == Segment::P2)
      EXPECT_GT(after[s] - before[s], 3.0);
    else
      EXPECT_NEAR(after[s], before[s], 0.3);
  }
}

TEST_F(TrainingCases, WhoPullsKnowsMoreThanWhoLooks) {
  const KnownValve known = known_valve(*valve);
  std::mt19937_64 engine(1);
  int by_pulling = 0;
  for (const ExamACase& made : cases_a)
    by_pulling += choose_by_pulling(made, known, 0.0, engine) == made.answer ? 1 : 0;
  EXPECT_GE(by_pulling, kCases - 1);
  for (const ExamBCase& made : cases_b) {
    const auto judged = judge_by_pulling(made, 0.0, 2.0, engine);
    for (std::size_t s = 0; s < kSegments; ++s) EXPECT_EQ(judged[s], made.truths[s].mobility);
  }
}

TEST(TrainingCase, OfExamBHasNoSegmentWithinTheMarginOfTheLimit) {
  const ExamBRules rules{.margin_mm = 0.3};  // so wide that draws are rejected for it
  const Expected<ExamBCase> made = make_exam_b(small_preset("human-normal"), 1, rules);
  ASSERT_TRUE(made);
  for (const SegmentTruth& truth : made->truths)
    EXPECT_GE(std::abs(std::abs(truth.height_mm - truth.normal_mm) - rules.limit_mm),
              rules.margin_mm);
}

TEST(TrainingCase, SaysWhyThereIsNone) {
  const Valve& valve = shared_preset("human-normal", 150);
  const auto none = make_exam_a(valve, 1, {.edge_mm = 100.0, .leak_mm2 = 1e6, .most_draws = 3});
  ASSERT_FALSE(none);
  EXPECT_NE(none.errors()[0].message.find("of 3 valves"), std::string::npos);
  Valve bare = valve;
  for (Chorda& chorda : bare.chordae) chorda.ruptured = true;
  EXPECT_EQ(make_exam_b(bare, 1).errors()[0].path, "/chordae");
}

TEST(Chordae, BelongToTheSegmentOfTheirMiddle) {
  const Valve& valve = small_preset("human-normal");
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Marginal) continue;
    const std::string place = '-' + std::string(to_string(segment_of(valve, chorda))) + '-';
    EXPECT_NE(chorda.id.find(place), std::string::npos) << chorda.id;
  }
}

}  // namespace
}  // namespace coapt
