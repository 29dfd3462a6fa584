#include "io/exchange/chorda_trees.h"

#include <gtest/gtest.h>

namespace coapt {
namespace {

TracedLine line(const Vec3& start, const Vec3& end) {
  TracedLine traced;
  traced.file = "chords.vtk";
  traced.place = "/lines/?";
  traced.start_mm = start;
  traced.end_mm = end;
  return traced;
}

const Vec3 kTip(-10.0, 0.0, -25.0), kBranch(-8.0, 0.0, -18.0);

/// Two twigs before their trunk, and a straight chorda on the other side.
std::vector<TracedLine> lines() {
  return {line(kBranch, {-9.0, 3.0, -12.0}), line(kBranch, {-9.0, -3.0, -12.0}),
          line(kTip, kBranch), line({10.0, 0.0, -25.0}, {9.0, 0.0, -12.0})};
}

std::vector<LabelledTip> tips() {
  return {{kTip, "AL1", Vec3(-11.0, 0.0, -27.0)}, {{10.0, 0.0, -25.0}, "posteromedial", {}}};
}

TEST(ChordaTrees, LinesHangTogetherWhateverTheirOrder) {
  ProblemList problems;
  const auto chordae = chorda_trees(lines(), tips(), {}, problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(chordae.size(), 2U);
  const ImportedChorda& tree = chordae[0];
  EXPECT_EQ(tree.side, Side::Anterolateral);
  EXPECT_EQ(tree.tip_mm, kTip);
  ASSERT_EQ(tree.segments.size(), 3U);
  EXPECT_FALSE(tree.segments[0].inserts);
  EXPECT_EQ(tree.segments[1].parent, 0);
  EXPECT_EQ(tree.segments[2].parent, 0);
  EXPECT_EQ(tree.insertion_mm, Vec3(-9.0, 0.0, -12.0));
  EXPECT_EQ(chordae[1].side, Side::Posteromedial);
  EXPECT_EQ(chordae[1].segments.size(), 1U);
  EXPECT_EQ(tree.pressed_tip_mm, Vec3(-11.0, 0.0, -27.0));
  EXPECT_FALSE(chordae[1].pressed_tip_mm);
}

TEST(ChordaTrees, RoundedPointsStillMeet) {
  std::vector<TracedLine> rounded = lines();
  rounded[0].start_mm += Vec3(4e-5, -4e-5, 4e-5);
  ProblemList problems;
  EXPECT_EQ(chorda_trees(rounded, tips(), {}, problems)[0].segments.size(), 3U);
}

TEST(ChordaTrees, WithoutLabelsTheLeafletsTellTheSides) {
  ImportSource source;
  source.leaflets = {{Points(1, 3), Faces(0, 3)}, {Points(1, 3), Faces(0, 3)}};
  source.leaflets[0].vertices_mm << 0.0, 8.0, -5.0;
  source.leaflets[1].vertices_mm << 0.0, -8.0, -5.0;
  source.annulus_mm = Points::Zero(1, 3);
  ProblemList problems;
  auto chordae = chorda_trees(lines(), {}, source, problems);
  EXPECT_EQ(chordae[0].side, Side::Anterolateral);
  EXPECT_EQ(chordae[1].side, Side::Posteromedial);
  std::swap(source.leaflets[0], source.leaflets[1]);
  chordae = chorda_trees(lines(), {}, source, problems);
  EXPECT_EQ(chordae[0].side, Side::Posteromedial);
  EXPECT_TRUE(problems.empty());
}

TEST(ChordaTrees, WhatIsNoTreeIsNamedByFileAndPlace) {
  std::vector<TracedLine> wrong = lines();
  wrong.push_back(line({0, 0, 0}, {1, 0, 0}));  // three in a ring
  wrong.push_back(line({1, 0, 0}, {0, 1, 0}));
  wrong.push_back(line({0, 1, 0}, {0, 0, 0}));
  wrong.push_back(line({5, 5, 5}, kBranch));  // the twigs hang on two
  wrong.push_back(line({7, 7, 7}, {7, 7, 7}));
  ProblemList problems;
  (void)chorda_trees(wrong, tips(), {}, problems);
  std::vector<std::string> messages;
  for (const Error& error : problems.listed()) {
    EXPECT_EQ(error.path, "chords.vtk/lines/?");
    messages.push_back(error.message);
  }
  const auto says = [&](const std::string& part) {
    return std::any_of(messages.begin(), messages.end(), [&](const std::string& message) {
      return message.find(part) != std::string::npos;
    });
  };
  EXPECT_TRUE(says("loop of lines"));
  EXPECT_TRUE(says("2 others end"));
  EXPECT_TRUE(says("shorter than"));
  EXPECT_TRUE(says("of unknown side"));
}

}  // namespace
}  // namespace coapt
