#include "io/picture/study_page.h"

#include <gtest/gtest.h>

#include "io/json/version.h"
#include "tests/io/picture/markup.h"

namespace coapt {
namespace {

Finding finding(const std::string& name, bool agrees) {
  Finding finding;
  finding.finding = name;
  finding.section = "4.3.1";
  finding.thesis = "5 to 10 % less";
  finding.ours = "7 % less";
  finding.judged = "less than a quarter";
  finding.agrees = agrees;
  return finding;
}

TEST(StudyPage, BeginsWithTheVerdictAndTellsAgreementByWordAndSymbol) {
  const std::string html = findings_page(
      "normal",
      {finding("flattening-matters-little", true), finding("b", true), finding("c", false)},
      {{"Annulus", "", "<svg></svg>", {}}}, "3,723 closures");
  EXPECT_EQ(count(html, "2 of 3 findings of the thesis hold on this valve."), 1u);
  EXPECT_EQ(count(html, ">Flattening matters little<"), 1u);
  EXPECT_EQ(count(html, "✓ agrees"), 2u);
  EXPECT_EQ(count(html, "✗ differs"), 1u);
  EXPECT_LT(html.find("2 of 3"), html.find("<table"));
  EXPECT_LT(html.find("</table"), html.find("<svg>"));
  EXPECT_LT(html.find("<svg>"), html.find("3,723 closures"));
}

TEST(StudyPage, IsSelfContainedWithTheNotice) {
  const std::string html = study_page("t", "l", {{"h", "text", "<svg></svg>", {}}});
  EXPECT_EQ(count(html, std::string(kResearchNotice)), 1u);
  for (const char* fetched : {"<script", "<link", "src=", "url("})
    EXPECT_EQ(count(html, fetched), 0u) << fetched;
}

TEST(StudyPage, EscapesEveryFreeText) {
  const std::string hostile = "<img onerror=\"x\"> & ";
  Finding bad = finding(hostile, false);
  bad.section = bad.thesis = bad.ours = bad.judged = hostile;
  const PageSection section{hostile, hostile, "", {{hostile}, {hostile}}};
  for (const std::string& html : {study_page(hostile, hostile, {section}),
                                  findings_page(hostile, {bad}, {section}, hostile)}) {
    EXPECT_EQ(count(html, "<img"), 0u);
    EXPECT_EQ(count(html, "& "), 0u);
  }
}

TEST(StudyPage, SetsColumnsOfWordsLeftAndSplitsParagraphs) {
  const std::string html = study_page(
      "t", "", {{"h", "one\ntwo\n\nthree", "", {{"class", "mm2"}, {"AL", "-1.5"}, {"PM", "n/a"}}}});
  EXPECT_EQ(count(html, "<th scope=\"col\" class=\"text\">class</th><th scope=\"col\">mm2</th>"),
            1u);
  EXPECT_EQ(count(html, "<td class=\"text\">AL</td><td>-1.5</td>"), 1u);
  EXPECT_EQ(count(html, "<p>one two</p>\n<p>three</p>"), 1u);
  EXPECT_EQ(count(html, "class=\"lead\""), 0u);
}

TEST(StudyPage, WithoutFindingsOrSectionsStillStands) {
  EXPECT_EQ(count(findings_page("v", {}, {}, ""), "0 of 0 findings"), 1u);
  EXPECT_EQ(count(study_page("t", "", {{"", "", "", {{}}}}), "</html>"), 1u);
}

}  // namespace
}  // namespace coapt
