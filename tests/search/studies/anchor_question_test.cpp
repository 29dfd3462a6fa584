#include "search/studies/anchor_question.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "search/latin_hypercube.h"
#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

AnchorSummary summary(const std::string& anchor, double mean, Displaced displaced) {
  AnchorSummary made;
  made.protocol = Protocol::Closed;
  made.displaced = displaced;
  made.anchor.name = anchor;
  made.mean_mm2 = mean;
  made.sd_mm2 = 1.0;
  return made;
}

ScannedAnatomy scanned(double trigone, double peak, std::vector<double> shares = {},
                       Displaced displaced = Displaced::Both) {
  ScannedAnatomy made;
  made.shares = std::move(shares);
  made.shares.resize(kScanFactors, 0.5);
  made.competent = true;
  made.summaries = {summary("trigone", trigone, displaced),
                    summary("saddle peak", peak, displaced)};
  return made;
}

const AnchorAnswer& answer_of(const std::vector<AnchorAnswer>& answers, Displaced displaced,
                              AnchorObjective objective) {
  for (const AnchorAnswer& answer : answers)
    if (answer.displaced == displaced && answer.objective == objective) return answer;
  ADD_FAILURE() << "no answer";
  return answers.front();
}

TEST(AnswerAnchorQuestion, CountsWinsAndTiesOfAHundredth) {
  ScannedAnatomy incompetent;
  incompetent.shares.resize(kScanFactors, 0.5);
  const std::vector<AnchorAnswer> answers = answer_anchor_question(
      {scanned(3.0, 4.0), scanned(5.0, 4.0), scanned(3.97, 4.0), scanned(4.03, 4.0),
       scanned(3.0, 4.0), scanned(9.0, 4.0, {}, Displaced::Anterolateral), incompetent});
  EXPECT_EQ(answers.size(), 3u * 5u) << "one protocol";
  const AnchorAnswer& mean = answer_of(answers, Displaced::Both, AnchorObjective::Mean);
  EXPECT_EQ(mean.protocol, Protocol::Closed);
  EXPECT_EQ(mean.anatomies, 5);
  EXPECT_EQ(mean.trigone_wins, 2);
  EXPECT_EQ(mean.ties, 2);
  EXPECT_NEAR(mean.mean_difference, (-1.0 + 1.0 - 0.03 + 0.03 - 1.0) / 5.0, 1e-12);
  EXPECT_TRUE(std::isnan(mean.decided_by.first[0])) << "five samples of seven terms";
  const AnchorAnswer& sd = answer_of(answers, Displaced::Both, AnchorObjective::Sd);
  EXPECT_EQ(sd.ties, 5);
  EXPECT_EQ(sd.trigone_wins, 0);
  EXPECT_EQ(answer_of(answers, Displaced::Both, AnchorObjective::LeakingShare).ties, 5)
      << "nothing on either side";
  EXPECT_EQ(answer_of(answers, Displaced::Anterolateral, AnchorObjective::Mean).anatomies, 1);
  EXPECT_EQ(answer_of(answers, Displaced::Posteromedial, AnchorObjective::Mean).anatomies, 0);
  EXPECT_EQ(answer_of(answers, Displaced::Posteromedial, AnchorObjective::Mean).mean_difference,
            0.0);
}

TEST(AnswerAnchorQuestion, NamesTheFactorThatDecides) {
  std::vector<ScannedAnatomy> scan;
  for (const std::vector<double>& shares : latin_hypercube(60, kScanFactors, 1))
    scan.push_back(scanned(10.0 + 2.0 * shares[0] + shares[3], 10.0, shares));
  const std::vector<AnchorAnswer> answers = answer_anchor_question(scan);
  const SobolIndices& by = answer_of(answers, Displaced::Both, AnchorObjective::Mean).decided_by;
  EXPECT_NEAR(by.first[0], 0.8, 1e-9);
  EXPECT_NEAR(by.first[3], 0.2, 1e-9);
  EXPECT_NEAR(by.total[1], 0.0, 1e-9);
  EXPECT_NEAR(by.effect[0], 2.0, 1e-9);
  EXPECT_NEAR(by.effect[3], 1.0, 1e-9);
}

TEST(AnswerAnchorQuestion, AnAnchorThatRepairsNothingHasNoMovementToCompare) {
  std::vector<ScannedAnatomy> scan = {scanned(3.0, 4.0), scanned(3.0, 4.0)};
  scan[1].summaries[0].movement_mm = std::numeric_limits<double>::quiet_NaN();
  const std::vector<AnchorAnswer> answers = answer_anchor_question(scan);
  EXPECT_EQ(answer_of(answers, Displaced::Both, AnchorObjective::Movement).anatomies, 1);
  EXPECT_EQ(answer_of(answers, Displaced::Both, AnchorObjective::Mean).anatomies, 2);
}

TEST(AnchorObjectives, TakeTheirValueOfASummaryAndHaveNames) {
  AnchorSummary s;
  s.mean_mm2 = 1.0;
  s.sd_mm2 = 2.0;
  s.length_sd_mm2 = 3.0;
  s.movement_mm = 4.0;
  s.leaking_share = 5.0;
  for (std::size_t i = 0; i < kAnchorObjectives.size(); ++i) {
    EXPECT_EQ(value_of(s, kAnchorObjectives[i]), 1.0 + static_cast<double>(i));
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_STRNE(to_string(kAnchorObjectives[i]), to_string(kAnchorObjectives[j]));
  }
}

TEST(ScannedAnatomy, SetsTheFactorsAndLeavesTheRestOfItsCentre) {
  ParametricValve centre;
  centre.slack.strut = 1.05;
  centre.anterior_height_mm = 24.0;
  centre.tissue.thickness_mm = 0.9;
  const std::vector<double> shares = {0.0, 1.0, 0.5, 0.2, 1.0, 1.0};
  const ParametricValve d = scanned_anatomy(centre, shares);
  EXPECT_EQ(d.tip_spread_mm, 18.0);
  EXPECT_EQ(d.tip_posterior_mm, 7.0);
  EXPECT_EQ(d.tip_depth_mm, 25.0);
  EXPECT_DOUBLE_EQ(d.trigone_share, 0.59);
  EXPECT_EQ(*d.saddle_height_mm, 10.0);
  const Proportions heights = proportions(centre, centre.ap_mm, centre.al_pm_mm);
  EXPECT_NEAR(*d.anterior_height_mm, 1.1 * 24.0, 1e-12);
  EXPECT_NEAR(*d.posterior_height_mm, 1.1 * heights.posterior_height_mm, 1e-12);
  EXPECT_NEAR(*d.lateral_height_mm, 1.1 * heights.lateral_height_mm, 1e-12);
  EXPECT_NEAR(*d.commissure_height_mm, 1.1 * heights.commissure_height_mm, 1e-12);
  EXPECT_EQ(d.slack, centre.slack);
  EXPECT_EQ(d.tissue.thickness_mm, 0.9);
  EXPECT_EQ(d.ap_mm, centre.ap_mm);
}

TEST(ScanAnchors, LeavesOutWhatLeaksUndisturbed) {
  OrificeTableOptions leaks;
  leaks.known[key_of({})] = {5.5, 0.0, true};
  std::vector<std::vector<double>> shares;
  for (const int at_once : {1, 2}) {
    AnchorQuestionOptions options;
    options.anatomies = 2;
    options.at_once = at_once;
    int progressed = 0;
    options.progress = [&](int done, int planned) {
      EXPECT_EQ(done, ++progressed);
      EXPECT_EQ(planned, 2);
    };
    const std::vector<ScannedAnatomy> scan = scan_anchors(
        ParametricValve{}, [&](const Valve&) { return small_table(leaks); }, options);
    EXPECT_EQ(progressed, 2);
    ASSERT_EQ(scan.size(), 2u);
    for (const ScannedAnatomy& scanned : scan) {
      EXPECT_EQ(scanned.shares.size(), static_cast<std::size_t>(kScanFactors));
      EXPECT_FALSE(scanned.competent);
      EXPECT_TRUE(scanned.summaries.empty());
      EXPECT_EQ(scanned.closures, 0);
      shares.push_back(scanned.shares);
    }
    EXPECT_TRUE(answer_anchor_question(scan).empty());
  }
  EXPECT_EQ(shares[2], shares[0]) << "at once, in the same order";
  EXPECT_EQ(shares[3], shares[1]);
}

}  // namespace
}  // namespace coapt
