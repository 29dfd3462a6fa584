#include "search/studies/findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "search/studies/anchor_findings.h"
#include "search/studies/geometry_findings.h"
#include "search/studies/ring_findings.h"
#include "tests/search/studies/study_scene.h"
#include "tests/search/studies/thesis_example.h"

namespace coapt {
namespace {

using Names = std::set<std::string>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Names differing(const std::vector<Finding>& all) {
  Names names;
  for (const Finding& finding : all)
    if (!finding.agrees) names.insert(finding.finding);
  return names;
}

/// What differs after one alteration of the study in which everything agrees.
template <class Alteration>
Names differing_after(const Alteration& alter) {
  ThesisStudy study = study_of_the_thesis();
  alter(study);
  return differing(findings(study));
}

double& at(DisplacementGrid& grid, int t, int p, int a) {
  return grid.area_mm2[static_cast<std::size_t>((t * grid.nodes + p) * grid.nodes + a)];
}

TEST(Findings, AllAgreeInAStudyLikeTheThesiss) {
  const std::vector<Finding> all = findings(study_of_the_thesis());
  Names names;
  for (const Finding& finding : all) {
    EXPECT_TRUE(finding.agrees) << finding.finding << ": " << finding.ours;
    names.insert(finding.finding);
    for (const std::string& text :
         {finding.finding, finding.section, finding.thesis, finding.ours, finding.judged})
      EXPECT_FALSE(text.empty()) << finding.finding;
    EXPECT_EQ(finding.ours.find("n/a"), std::string::npos) << finding.ours;
  }
  EXPECT_EQ(names.size(), all.size()) << "names are unique";
  // Annulus 5, papillary 11, belly 1, ring 9, anchors 3 + 3 classes of 4 + 2.
  EXPECT_EQ(all.size(), 5u + 11u + 1u + 9u + 17u);
}

TEST(Findings, AnchorsComeOnceForEachProtocol) {
  ThesisStudy study = study_of_the_thesis();
  study.anchors.approximation.push_back(anchors_of_the_thesis(Protocol::Closed));
  const std::vector<Finding> all = findings(study);
  EXPECT_EQ(all.size(), 26u + 2u * 17u);
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Finding& finding) {
    return finding.finding == "closed/trigone-smaller-mean-AL";
  }));
}

TEST(Findings, OneAlterationOfTheAnnulusChangesOneFinding) {
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.annulus.area_mm2[0][20] = 40.0; }),
            Names{"dilation-orifice"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.annulus.area_mm2[0][5] = 3.0; }),
            Names{"dilation-hardly-matters-at-first"})
      << "27.45 mm2 from 25 to 30 %";
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.annulus.area_mm2[4][30] = 126.9; }),
            Names{"flattening-matters-far-less-than-dilation"});
  for (const double factor : {0.98, 0.85})
    EXPECT_EQ(differing_after([&](ThesisStudy& s) {
                for (std::size_t d = 0; d <= 30; ++d)
                  s.annulus.area_mm2[1][d] = factor * s.annulus.area_mm2[0][d];
              }),
              Names{"flattening-by-25-percent-shrinks-orifice-5-to-10-percent"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.annulus.area_mm2[0][20] = 60.0; }),
            (Names{"dilation-orifice", "dilation-grows-superlinearly",
                   "flattening-matters-far-less-than-dilation"}));
}

TEST(Findings, OneAlterationOfAPapillaryStudyChangesOneFinding) {
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.papillary.grids[0], 6, 0, 6) = 150.0; }),
            Names{"table-4.1"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.papillary.grids[2], 3, 3, 3) = 150.0; }),
            Names{"displacement-grows-superlinearly-both"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) {
              auto& [al, pm, both] = s.papillary.grids;
              for (int t = 2; t <= 4; ++t)
                for (int p = 2; p <= 4; ++p)
                  for (int a = 0; a <= 6; ++a) std::swap(at(pm, t, p, a), at(al, t, p, a));
            }),
            Names{"posteromedial-more-sensitive"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.papillary.grids[2], 3, 2, 4) = 1.0; }),
            Names{"both-exceed-the-sum"});
}

TEST(Findings, TheOrderOfTheAxesIsThatOfTheMeanGradients) {
  // Transverse and posterior change places.
  const Names names = differing_after([](ThesisStudy& s) {
    DisplacementGrid& grid = s.papillary.grids[0];
    const DisplacementGrid before = grid;
    for (int t = 0; t < 7; ++t)
      for (int p = 0; p < 7; ++p)
        for (int a = 0; a < 7; ++a) at(grid, t, p, a) = before.at(p, t, a);
  });
  EXPECT_TRUE(names.contains("apical-most-then-transverse-then-posterior-AL"));
  EXPECT_FALSE(names.contains("apical-most-then-transverse-then-posterior-PM"));
  EXPECT_FALSE(names.contains("displacement-grows-superlinearly-AL"));
}

TEST(Findings, SynergyOfTwiceTheSumIsTooMuch) {
  EXPECT_EQ(differing_after([](ThesisStudy& s) {
              for (double& area : s.papillary.grids[2].area_mm2) area *= 1.5;
            }),
            Names{"both-exceed-the-sum-by-37-percent"});
}

TEST(Findings, OneAlterationOfBellyOrRingChangesOneFinding) {
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.belly_shift_mm[2].x() = 0.1; }),
            Names{"anterior-leaflet-follows-lateral-displacement"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.belly_shift_mm[1].x() = -1.2; }),
            Names{"anterior-leaflet-follows-lateral-displacement"});
  // 102 instead of 81.9 %: a ninth of 20 points.
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.ring.grids[2][1], 3, 3, 3) = 102.0; }),
            Names{"undersized-ring-always-reduces"});
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.ring.grids[2][1], 3, 3, 3) = 100.05; }),
            Names{})
      << "known to 0.1 mm2";
  EXPECT_EQ(differing_after([](ThesisStudy& s) { at(s.ring.grids[0][3], 0, 0, 0) = 0.2; }),
            Names{"undersized-ring-always-reduces"})
      << "also where the proper size is tight";
  EXPECT_EQ(differing_after([](ThesisStudy& s) {
              for (auto& sizes : s.ring.grids)
                for (std::size_t k = 1; k < 4; ++k)
                  for (double& area : sizes[k].area_mm2) area *= 0.85;
            }),
            Names{"table-4.2"});
}

TEST(Findings, RatioThatFallsWithDisplacementIsFoundForItsSize) {
  const Names names = differing_after([](ThesisStudy& s) {
    DisplacementGrid& ring = s.ring.grids[2][2];
    const DisplacementGrid& proper = s.ring.grids[2][0];
    for (std::size_t i = 0; i < ring.area_mm2.size(); ++i)
      ring.area_mm2[i] = proper.area_mm2[i] * (0.641 - 0.02 * ring.displacement_mm(i).z());
  });
  EXPECT_EQ(names, Names{"ring-ratio-grows-with-displacement-U2"});
}

TEST(Findings, GrowthUnderARingIsThatOfTheLastStepOfItsClass) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(differing_after([&](ThesisStudy& s) {
                // As large 2 mm before the end.
                DisplacementGrid& ring = s.ring.grids[k][1];
                for (int t = 0; t < 4; ++t)
                  for (int p = 0; p < 4; ++p) at(ring, t, p, 2) = ring.at(t, p, 3);
              }),
              Names{std::string("orifice-grows-faster-under-a-ring-") + to_string(kDisplaced[k])});
}

TEST(Findings, LateralSensitivityIsTheShareOfTheApicalOne) {
  // The ratio under U2 no longer depends on the transverse displacement.
  EXPECT_EQ(differing_after([](ThesisStudy& s) {
              DisplacementGrid& ring = s.ring.grids[2][2];
              const DisplacementGrid& proper = s.ring.grids[2][0];
              for (std::size_t i = 0; i < ring.area_mm2.size(); ++i) {
                const Vec3 far = ring.displacement_mm(i) / 6.0;
                ring.area_mm2[i] =
                    proper.area_mm2[i] * 0.641 * (0.4 + 0.1 * far.y() + 0.5 * far.z());
              }
            }),
            Names{"lateral-sensitivity-nears-apical-under-a-ring"});
}

TEST(Findings, OfARingAreLeftOutWhereNothingLeaksUnderTheProperSize) {
  ThesisStudy study = study_of_the_thesis();
  for (auto& sizes : study.ring.grids)
    for (double& area : sizes[0].area_mm2) area = std::min(area, 0.5);
  EXPECT_TRUE(ring_findings(study.ring).empty());
  EXPECT_EQ(findings(study).size(), 26u - 9u + 17u);
}

TEST(Findings, OneAlterationOfTheAnchorsChangesOneFinding) {
  const auto anchors = [](const auto& alter) {
    return differing_after(
        [&](ThesisStudy& s) { alter(s.anchors.approximation[0].approximations); });
  };
  using All = std::vector<Approximation>;
  EXPECT_EQ(anchors([](All& all) { all[5].repaired = false; }),
            Names{"lookup-clamped/approximation-always-repairs"});
  EXPECT_EQ(anchors([](All& all) {
              for (Approximation& a : all) a.region.angle_sd_mm2 *= 2.0;
            }),
            Names{"lookup-clamped/length-varies-the-region-more-than-angle"});
  EXPECT_EQ(anchors([](All& all) {
              for (Approximation& a : all) a.region.swing_slope_mm2_per_mm *= 4.0;
            }),
            Names{"lookup-clamped/length-matters-more-than-angle"});
  EXPECT_EQ(anchors([](All& all) {
              for (const std::size_t i : {4u, 6u})
                all[i].region.length_sd_mm2 = 2.1;  // PM, trigone
              for (const std::size_t i : {5u, 7u}) all[i].region.length_sd_mm2 = 3.0;
            }),
            Names{"lookup-clamped/trigone-sensitivity-below-2-PM"});
  EXPECT_EQ(anchors([](All& all) { all[0].region.length_sd_mm2 = 3.0; }),
            Names{"lookup-clamped/trigone-less-sensitive-to-length-AL"});
  EXPECT_EQ(anchors([](All& all) {
              for (const std::size_t i : {8u, 10u}) all[i].region.sd_mm2 = 2.5;  // both, trigone
            }),
            Names{"lookup-clamped/trigone-smaller-sd-both"});
  EXPECT_EQ(anchors([](All& all) {
              for (const std::size_t i : {4u, 6u}) all[i].region.mean_mm2 += 3.0;  // PM, trigone
            }),
            Names{"lookup-clamped/trigone-smaller-mean-PM"});
  EXPECT_EQ(anchors([](All& all) { all[9].region.mean_mm2 = all[11].region.mean_mm2; }),
            Names{"lookup-clamped/trigone-smaller-sd-of-means-both"});
}

TEST(Findings, AnchorsWithinAHundredthAreATie) {
  const auto posteromedial_sd = [](double trigone) {
    ApproximationStudy study = anchors_of_the_thesis();
    for (const std::size_t i : {4u, 6u}) study.approximations[i].region.sd_mm2 = trigone;
    for (const Finding& finding : anchor_findings(study))
      if (finding.finding == "lookup-clamped/trigone-smaller-sd-PM") return finding;
    ADD_FAILURE() << "no such finding";
    return Finding{};
  };
  // The saddle peak's is 2 mm2.
  EXPECT_TRUE(posteromedial_sd(1.97).agrees);
  EXPECT_EQ(posteromedial_sd(1.97).ours.find("a tie"), std::string::npos);
  for (const double tie : {1.99, 2.01}) {
    EXPECT_FALSE(posteromedial_sd(tie).agrees) << tie;
    EXPECT_NE(posteromedial_sd(tie).ours.find("a tie"), std::string::npos) << tie;
  }
}

TEST(Findings, LinearGrowthIsNotSuperlinearOnAnyGrid) {
  for (const int nodes : {4, 5, 7}) {
    PapillaryStudy study;
    for (std::size_t k = 0; k < 3; ++k)
      study.grids[k] =
          grid_of(kDisplaced[k], nodes, 6.0 / (nodes - 1), [](const Vec3& d) { return d.sum(); });
    EXPECT_TRUE(
        differing(papillary_findings(study)).contains("displacement-grows-superlinearly-AL"))
        << nodes;
    for (double& area : study.grids[0].area_mm2) area *= area;
    EXPECT_FALSE(
        differing(papillary_findings(study)).contains("displacement-grows-superlinearly-AL"))
        << nodes;
  }
}

TEST(Findings, AnOrificeThatIsNotKnownIsNoAgreement) {
  EXPECT_TRUE(differing_after([](ThesisStudy& s) {
                s.annulus.area_mm2[0][10] = kNaN;
              }).contains("dilation-orifice"));
  EXPECT_EQ(differing_after([](ThesisStudy& s) { s.belly_shift_mm.fill(Vec3::Constant(kNaN)); }),
            Names{"anterior-leaflet-follows-lateral-displacement"});
}

}  // namespace
}  // namespace coapt
