#include "io/picture/study_csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "io/picture/csv_lines.h"
#include "search/model_draw.h"

namespace coapt {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> lines_of(const std::string& csv) {
  std::vector<std::string> lines;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(CsvLines, TextThatASpreadsheetWouldComputeIsTextThere) {
  CsvLines lines;
  lines << "=HYPERLINK(\"x\",1)"
        << "+1"
        << "-2+3"
        << "@SUM(A1)"
        << "\tx"
        << "a\rb"
        << "P2 = flail"
        << "-2.50" << -1.5;
  EXPECT_EQ(lines.text(),
            "\"'=HYPERLINK(\"\"x\"\",1)\",'+1,'-2+3,'@SUM(A1),'\tx,\"a\rb\",P2 = flail,-2.50,-1.5");
}

/// Each line has as many commas as the header. @pre nothing is quoted.
void expect_even(const std::string& csv, std::size_t rows) {
  const std::vector<std::string> lines = lines_of(csv);
  ASSERT_EQ(lines.size(), rows + 1);
  EXPECT_EQ(csv.back(), '\n');
  for (const std::string& line : lines)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','),
              std::count(lines[0].begin(), lines[0].end(), ','))
        << line;
}

DisplacementGrid two_nodes(Displaced displaced, int sizes, double scale) {
  DisplacementGrid grid{displaced, sizes, 2, 6.0, {}};
  for (int i = 0; i < 8; ++i) grid.area_mm2.push_back(scale * i);
  return grid;
}

TEST(StudyCsv, AnnulusHasARowForEachHeightAndDilationAndNothingWhereThereIsNoOrifice) {
  const AnnulusStudy study{{0.0, 15.0}, {100.0, 50.0}, {{0.0, 1234567.0}, {kMissing, 0.125}}};
  EXPECT_EQ(annulus_csv(study),
            "annular_height_percent,ap_dilation_percent,orifice_mm2\n"
            "100,0,0\n"
            "100,15,1.23457e+06\n"
            "50,0,\n"
            "50,15,0.125\n");
}

TEST(StudyCsv, PapillaryHasPlaceOrificeAndGradient) {
  PapillaryStudy study;
  for (std::size_t k = 0; k < 3; ++k) study.grids[k] = two_nodes(kDisplaced[k], 0, 6.0);
  const std::string csv = papillary_csv(study);
  expect_even(csv, 24);
  const std::vector<std::string> lines = lines_of(csv);
  EXPECT_EQ(lines[1], "AL,0,0,0,0,4,2,1");
  EXPECT_EQ(lines[2], "AL,0,0,6,6,4,2,1");
  EXPECT_EQ(lines[16], "PM,6,6,6,42,4,2,1");
  EXPECT_EQ(lines[17], "both,0,0,0,0,4,2,1");
}

TEST(StudyCsv, RingHasTheRatioToTheProperSizeOrNothing) {
  RingStudy study;
  for (std::size_t k = 0; k < 3; ++k)
    for (int sizes = 0; sizes < 4; ++sizes)
      study.grids[k][static_cast<std::size_t>(sizes)] =
          two_nodes(kDisplaced[k], sizes, 4.0 - sizes);
  const std::string csv = ring_csv(study);
  expect_even(csv, 3 * 4 * 8);
  const std::vector<std::string> lines = lines_of(csv);
  EXPECT_EQ(lines[9], "AL,1,0,0,0,0,") << "tight";
  EXPECT_EQ(lines[10], "AL,1,0,0,6,3,0.75");
  EXPECT_EQ(lines.back(), "both,3,6,6,6,7,0.25");
}

ApproximationStudy one_approximation(const std::string& anchor) {
  ApproximationStudy study;
  study.protocol = Protocol::Optimum;
  study.options.region_points = 17;
  study.anchors = {{anchor, 0.25, {}}};
  Approximation a;
  a.displaced = Displaced::Posteromedial;
  a.displaced_mm = Vec3(1, 2, 3);
  a.displaced_area_mm2 = 40;
  a.repaired = true;
  a.position_mm = Vec3(4, 5, 6);
  a.suture_mm = 30;
  a.movement_mm = 7;
  a.area_mm2 = 2;
  a.region = {8, 9, 10, 11, 12, 13, 14, 0.5, kMissing};
  study.approximations = {a};
  return study;
}

TEST(StudyCsv, ApproximationHasARowForEachConfigurationAndAnchor) {
  const std::string csv = approximation_csv({one_approximation("trigone")});
  expect_even(csv, 1);
  EXPECT_EQ(lines_of(csv)[1],
            "optimum,PM,1,2,3,40,trigone,0.25,true,4,5,6,7,30,2,17,8,9,10,11,12,13,14,0.5,");
}

TEST(StudyCsv, TextWithCommasQuotesOrLineBreaksIsQuoted) {
  const std::string csv = approximation_csv({one_approximation("left, \"upper\"\ncorner")});
  EXPECT_NE(csv.find(",\"left, \"\"upper\"\"\ncorner\",0.25,"), std::string::npos) << csv;
}

TEST(StudyCsv, TableOfAPageIsItsRowsWithTheSameQuotes) {
  EXPECT_EQ(table_csv({{"name", "mm2"}, {"a, \"b\"", "1.5"}, {"", "n/a"}}),
            "name,mm2\n\"a, \"\"b\"\"\",1.5\n,n/a\n");
  EXPECT_EQ(table_csv({}), "");
}

TEST(StudyCsv, AnAnchorThatRepairsNothingHasNoMovement) {
  ApproximationStudy study = one_approximation("trigone");
  study.approximations.front().repaired = false;
  EXPECT_EQ(lines_of(anchors_csv(summarise(study)))[1],
            "optimum,PM,trigone,0.25,1,0,8,9,0,11,12,13,14,,,0.5,");
}

TEST(StudyCsv, AnchorsHaveARowForEachSummary) {
  const std::string csv = anchors_csv(summarise(one_approximation("trigone")));
  expect_even(csv, 1);
  EXPECT_EQ(lines_of(csv)[1], "optimum,PM,trigone,0.25,1,1,8,9,0,11,12,13,14,7,30,0.5,");
}

TEST(StudyCsv, ScanHasTheAnatomyBesideEachSummary) {
  ScannedAnatomy left_out, scanned;
  scanned.shares = {0.0, 1.0, 0.5, 0.0, 1.0, 1.0};
  scanned.summaries = summarise(one_approximation("trigone"));
  const std::string csv = anchor_scan_csv({left_out, scanned});
  expect_even(csv, 1);
  EXPECT_EQ(lines_of(csv)[1].substr(0, 34), "1,18,7,25,0.5,10,1.1,optimum,PM,tr");
  EXPECT_EQ(lines_of(csv)[0].substr(0, 22), "anatomy,tip spread mm,");
}

TEST(StudyCsv, AnswersHaveARowForEachFactor) {
  AnchorAnswer answer;
  answer.displaced = Displaced::Both;
  answer.objective = AnchorObjective::LengthSensitivity;
  answer.anatomies = 30;
  answer.trigone_wins = 12;
  answer.ties = 3;
  answer.mean_difference = -0.5;
  answer.decided_by = {{0.1, 0.2, 0.3, 0.4, 0.5, kMissing},
                       {0.6, 0.7, 0.8, 0.9, 1.0, kMissing},
                       {-1.5, 2.0, 3.0, 4.0, 5.0, kMissing},
                       0.75};
  const std::vector<std::string> lines = lines_of(anchor_answers_csv({answer}));
  ASSERT_EQ(lines.size(), 1u + kScanFactors);
  EXPECT_EQ(lines[1],
            "closed,both,length sensitivity,30,12,3,-0.5,0.75,tip spread mm,0.1,0.6,-1.5");
  EXPECT_EQ(lines[6],
            "closed,both,length sensitivity,30,12,3,-0.5,0.75,\"reserve, factor of leaflet "
            "heights\",,,");
}

TEST(StudyCsv, GeneralityAndSharesHaveTheirCounts) {
  const Finding finding{"table-4.1", "4.3.1", "", "1.2 / 3.4", "", true};
  EXPECT_EQ(generality_csv({{"human", "v", {finding}, 100, 2}}),
            "kind,valve,configurations,untrusted,finding,agrees,ours\n"
            "human,v,100,2,table-4.1,true,1.2 / 3.4\n");
  EXPECT_EQ(finding_shares_csv({{"table-4.1", "", 5, 3}, {"table-4.1", "human", 2, 1}}),
            "finding,kind,valves,agree\n"
            "table-4.1,all,5,3\n"
            "table-4.1,human,2,1\n");
}

TEST(StudyCsv, DrawsOfTheModelHaveTheirFactors) {
  ModelStudy study;
  study.draws = {{std::vector<double>(kModelParameters, 0.5), true, 2.5},
                 {std::vector<double>(kModelParameters, 0.0), false, 4.0}};
  study.draws[0].figures = ModelFigures{.value = {30.0, 150.5, 3.25}};
  study.draws[0].closed_shape = {6.5, 150.5, 4.0};
  EXPECT_EQ(model_draws_csv(study),
            "bending rigidity,insertion zone,leaflet thickness,moduli below the transition,moduli "
            "above the transition,circumferential transition,radial transition,chordal "
            "modulus,chordal length,trusted,leak_mm2,"
            "unrepaired_leak_mm2,unrepaired_tenting_area_mm2,unrepaired_widest_gap_mm,"
            "unrepaired_tenting_height_mm,unrepaired_coaptation_mm\n"
            "1,1,1,1,1,1,1,1,1,true,2.5,30,150.5,3.25,6.5,4\n"
            "0.2,0.65,0.65,0.5,0.5,0.65,0.65,0.5,0.95,false,4,,,,,\n");
}

}  // namespace
}  // namespace coapt
