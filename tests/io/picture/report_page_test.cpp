// The report as a page: its first sheet, its structure, how it prints, and what it makes of odd results.
#include <gtest/gtest.h>

#include <limits>

#include "io/picture/report.h"
#include "io/picture/report_page_style.h"
#include "tests/io/picture/markup.h"
#include "tests/io/picture/undrawn_report.h"
#include "tests/io/plans_scene.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

ClosedValve leaking(const std::string& name, double hole_mm = 5.0) {
  Valve valve = disc_with_hole(15.0, hole_mm, 64);
  valve.name = name;
  const ClosureResult closure = closed_at_rest(valve);
  return {valve, closure, measure(valve, closure)};
}

std::string page_of(const SearchResult& result, int about = 0,
                    const ClosedValve& before = leaking("leaky")) {
  return undrawn_report({before, {}, result, search_request(), about});
}

/// Up to the evidence.
std::string first_sheet(const std::string& html) {
  return html.substr(0, html.find("<section id=\"ranked\""));
}

TEST(FirstPage, HasTheFiguresThatMatterWithTheirUncertainty) {
  SearchResult result = search_result();
  result.plans[0].estimates.leak_mm2.execution = Interval{0.1, 1.4};
  const std::string page = first_sheet(page_of(result));
  for (const char* part :
       {"<dd>0.3 (0.1 to 1.4) mm²<small>with errors of execution (5 to 95 %); before 52.0",
        "Leak with errors of execution</dt><dd>0.1 to 1.4 mm²<small>5 to 95 %<",
        "<dd>99.2 %<small>of 1,089 closures", "<dd>0.75 mm · 4.0°<small>",
        "<dd>6.8 mm<small>minimum 4.8; before 2.6", "<dd>0.61 N<small>before 0.48 N",
        "<dd>2.1 sizes<small>", "<dd>4.6 / 11.5 mm<small>"})
    EXPECT_TRUE(contains(page, part)) << part;
}

TEST(FirstPage, SaysWhatToWatchAndWhatIsNotAssessed) {
  const std::string page = first_sheet(page_of(search_result()));
  EXPECT_TRUE(contains(page, "posteromedial muscle moved by 11 mm; more than 10 mm is unusual"));
  EXPECT_TRUE(contains(page, "the plan leaks more than 5 mm² with some error of execution"));
  EXPECT_TRUE(contains(page, "Not assessed: filling."));
}

TEST(FirstPage, SaysWhichPlansCannotBeToldApart) {
  SearchResult result = search_result();  // 1 and 2 are of one class
  EXPECT_TRUE(contains(first_sheet(page_of(result)), "It is the simplest of 2 equivalent plans."));
  EXPECT_TRUE(contains(first_sheet(page_of(result, 2)), "It is one of 2 equivalent plans."));
  EXPECT_FALSE(contains(first_sheet(page_of(result, 3)), "equivalent"));
  result.plans[1].of_class = 3;
  result.plans[0].probability_outranks_next = 0.97;
  EXPECT_TRUE(contains(first_sheet(page_of(result)),
                       "It is better than plan 2 with a probability of 97.0 %."));
}

TEST(FirstPage, StatesTheWidestErrorThatIsKnownOfTheLeak) {
  SearchResult result = search_result();
  Estimate& leak = result.plans[0].estimates.leak_mm2;
  leak.numerical = Interval{0.0, 1.2};
  result.before_estimates.leak_mm2.numerical = Interval{48.0, 56.0};
  EXPECT_TRUE(contains(first_sheet(page_of(result)),
                       "<dd>0.3 ± 0.9 mm²<small>± numerical error; before 52 ± 4 mm²<"));
  leak.tissue = Interval{0.1, 7.5};
  EXPECT_TRUE(contains(first_sheet(page_of(result)),
                       "<dd>0 (0 to 8) mm²<small>with tissue error (5 to 95 %); "
                       "before 52 ± 4 mm², ± numerical error<"));
  EXPECT_FALSE(contains(first_sheet(page_of(result)), "tissue, ring placement"));
  result.plans[0].model.reset();
  EXPECT_TRUE(contains(first_sheet(page_of(result)), "Other errors (imaging, tissue, ring"));
}

TEST(FirstPage, SaysWhenTheSearchWasStoppedEarly) {
  SearchResult result = search_result();
  result.stop = SearchStop::Cancelled;
  EXPECT_TRUE(contains(first_sheet(page_of(result)), "The search was cancelled"));
  result.stop = SearchStop::TimeLimit;
  EXPECT_TRUE(contains(first_sheet(page_of(result)), "reached its time limit"));
}

TEST(FirstPage, OfAPlanWhoseClosureFailedTrustsNoFigure) {
  const std::string page = first_sheet(page_of(search_result(), 3));
  EXPECT_TRUE(contains(page, "The closure of this plan failed"));
  EXPECT_FALSE(contains(page, "leaks less than 5 mm² with a probability"));
  EXPECT_TRUE(contains(page, "n/a"));
}

TEST(FirstPage, OfAPlanThatWasNotVariedSaysThatItIsNotKnown) {
  SearchResult result = search_result();
  result.plans[0].region = plans_scene::third().region;
  result.plans[0].region.failures = 0;
  const std::string page = first_sheet(page_of(result));
  EXPECT_TRUE(contains(page, "is unknown whether this plan is acceptable"));
  EXPECT_FALSE(contains(page, "leaks less than 5 mm² with a probability"));
}

TEST(Report, OfOnePlanHasItInFrontAndItsEvidenceAlone) {
  const std::string html = page_of(search_result(), 2);
  EXPECT_TRUE(contains(html, "<h1>Repair plan 2 of 3 for leaky</h1>"));
  EXPECT_TRUE(contains(html, "<h2>Plan 2 of 3</h2>"));
  EXPECT_TRUE(contains(html, "id=\"plan-2\""));
  EXPECT_FALSE(contains(html, "id=\"plan-1\""));
  EXPECT_EQ(count(html, "<div class=\"plan-evidence\">"), 1u);
  EXPECT_TRUE(contains(html, "Plan 2 as a file"));
  EXPECT_EQ(count(first_sheet(html), "<tr class=\"this\">"), 1u);
}

TEST(Report, ItsHeadingsGoDownOneLevelAtATime) {
  const std::string html = page_of(search_result());
  int level = 0, seen = 0;
  for (std::size_t at = html.find("<h"); at != std::string::npos; at = html.find("<h", at + 1)) {
    const char digit = html[at + 2];
    if (digit < '1' || digit > '6') continue;
    EXPECT_LE(digit - '0', level + 1) << html.substr(at, 60);
    level = digit - '0';
    ++seen;
  }
  EXPECT_GT(seen, 12);
  EXPECT_EQ(count(html, "<h1>"), 1u);
}

TEST(Report, EveryLinkHasItsTargetOnceAndEveryHeaderItsScope) {
  const std::string html = page_of(search_result());
  for (std::size_t at = html.find("href=\"#"); at != std::string::npos;
       at = html.find("href=\"#", at + 1)) {
    const std::string target = html.substr(at + 7, html.find('"', at + 7) - at - 7);
    EXPECT_EQ(count(html, "id=\"" + target + "\""), 1u) << target;
  }
  EXPECT_EQ(count(html, "<th>") + count(html, "<th class"), 0u);
}

TEST(Report, PrintsTheNoticeTheNameAndPageNumbersOnEverySheet) {
  const std::string html = page_of(search_result());
  const std::string page = html.substr(html.find("@page{"), 900);
  EXPECT_TRUE(contains(page, "@top-left{content:\"leaky\""));
  EXPECT_TRUE(contains(page, "@bottom-left{content:\"coapt is research software"));
  EXPECT_TRUE(contains(page, "not for clinical decisions"));
  EXPECT_TRUE(contains(page, "counter(page)"));
}

TEST(ReportPageStyle, ANameCannotLeaveItsString) {
  const std::string style = report_page_style("a\"}</style><b>\\\n{;");
  EXPECT_FALSE(contains(style, "</style"));
  EXPECT_FALSE(contains(style, "<b>"));
  EXPECT_TRUE(contains(style, "content:\"a\\22 \\7d \\3c \\2f style\\3e \\3c b\\3e \\5c "));
}

TEST(Report, ALongNameIsCutBetweenItsLetters) {
  std::string name;
  for (int i = 0; i < 400; ++i) name += "ä";
  const std::string html = page_of(search_result(), 0, leaking(name));
  EXPECT_FALSE(contains(html, "\xEF\xBF\xBD")) << "no broken letter";
  EXPECT_TRUE(contains(html, "ä…</h1>"));
}

TEST(Report, OfFiftyPlansKeepsItsFirstSheetShort) {
  SearchResult result = search_result();
  result.plans.assign(50, plans_scene::first());
  for (int i = 0; i < 50; ++i) result.plans[static_cast<std::size_t>(i)].rank = i + 1;
  const std::string all = page_of(result), one = page_of(result, 37);
  EXPECT_EQ(count(first_sheet(all), "<th scope=\"row\">"), 5u);
  EXPECT_EQ(count(first_sheet(one), "<th scope=\"row\">"), 5u);
  EXPECT_TRUE(contains(first_sheet(one), "45 more in"));
  EXPECT_EQ(count(all, "<div class=\"plan-evidence\">"), 50u);
  EXPECT_EQ(count(one, "<div class=\"plan-evidence\">"), 1u);
}

TEST(Report, OfNothingButUnknownFiguresSaysSo) {
  SearchResult result = search_result();
  ClosedValve before = leaking("leaky");
  before.closure.closed_mm(0, 0) = kUnknown;
  before.measure = measure(before.valve, before.closure);
  result.before.measure = before.measure;
  result.any_acceptable = false;
  result.random_progress.clear();
  for (Progress& at : result.progress) at.cost = kUnknown;
  for (RankedPlan& plan : result.plans) {
    plan.measure = before.measure;
    plan.status = ClosureStatus::Diverged;
    plan.cost = plan.subset_cost = plan.probability_outranks_next = kUnknown;
    plan.effort = {kUnknown, kUnknown, kUnknown, 1};
    plan.region = plans_scene::third().region;
  }
  const std::string html =
      plan_report_html({before, {before, before, before}, result, search_request()});
  const std::string text = without_pictures(html);
  for (const char* broken : {">nan", "nan ", "=\"nan", "inf ", "NaN"})
    EXPECT_FALSE(contains(text, broken)) << broken;
  EXPECT_TRUE(contains(html, "The closure of this plan failed"));
  EXPECT_TRUE(contains(html, "No plan is acceptable"));
}

TEST(Report, OfAPlanWithoutStepsSaysNoRepair) {
  SearchResult result;
  result.plans.resize(1);
  result.plans[0].rank = 1;
  const std::string html = page_of(result);
  EXPECT_TRUE(contains(html, "<strong>No repair</strong>"));
  EXPECT_FALSE(contains(html, "Comparison with the other plans"));
}

}  // namespace
}  // namespace coapt
