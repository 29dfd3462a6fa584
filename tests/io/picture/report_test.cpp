#include "io/picture/report.h"

#include <gtest/gtest.h>

#include <limits>

#include "io/json/result_json.h"
#include "io/json/version.h"
#include "tests/io/picture/markup.h"
#include "tests/io/picture/undrawn_report.h"
#include "tests/io/plans_scene.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

ClosedValve closed(const std::string& name, double hole_mm) {
  Valve valve = disc_with_hole(15.0, hole_mm, 64);
  valve.name = name;
  const ClosureResult closure = closed_at_rest(valve);
  return {valve, closure, measure(valve, closure)};
}

std::string html_of(const SearchResult& result, const std::vector<ClosedValve>& after = {},
                    const ClosedValve& before = closed("leaky", 5.0)) {
  return undrawn_report({before, after, result, search_request()});
}

RankedPlan ranked_plan(int rank, const std::string& words) {
  RankedPlan plan;
  plan.rank = rank;
  plan.description = {words};
  return plan;
}

/// From one heading to the next.
std::string section(const std::string& html, const std::string& heading) {
  const std::size_t start = html.find("<h2>" + heading + "</h2>");
  if (start == std::string::npos) return "";
  return html.substr(start, html.find("<h2>", start + 4) - start);
}

TEST(Report, BeginsWithTheNoticeTheVerdictAndTheBestPlanInPictures) {
  SearchResult result = search_result();
  result.plans[0].estimates.leak_mm2.execution = Interval{0.1, 1.4};
  const std::string html =
      html_of(result, {closed("leaky", 1.0), closed("leaky", 2.0), closed("leaky", 3.0)});
  EXPECT_EQ(count(html, std::string(kResearchNotice)), 1u);
  const std::vector<std::string> order = {std::string(kResearchNotice),
                                          "The repaired valve leaks less than 5 mm²",
                                          "Annuloplasty ring, size 32 mm, shape generic-classic",
                                          "data:image/png",
                                          "0.1 to 1.4 mm²",
                                          "<h3>Warnings",
                                          "Comparison with the other plans",
                                          "All ranked plans</h2>",
                                          "Evidence, plan by plan",
                                          "How the search went",
                                          "Not modelled",
                                          "How to reproduce"};
  std::size_t at = 0;
  for (const std::string& part : order) {
    const std::size_t found = html.find(part, at);
    ASSERT_NE(found, std::string::npos) << part;
    at = found;
  }
  EXPECT_EQ(count(html, "data:image/png;base64"), 4u) << "two of the first plan, one of each other";
}

TEST(Report, TheTableHasTheFiguresTiesAndMarksOfEveryPlan) {
  SearchResult result = search_result();
  result.plans[0].estimates.leak_mm2.execution = Interval{0.1, 1.4};
  const std::string table = section(html_of(result), "All ranked plans");
  for (const char* cell :
       {"<td>0.0</td>", "<td>0.1 to 1.4</td>", "<td>5.6</td>", "<td>99.2 %</td>", "<td>0.75</td>",
        "<td>4.0</td>", "<td>6.8</td>", "<td>0.61</td>", "<td>n/a</td>"})
    EXPECT_TRUE(contains(table, cell)) << cell;
  EXPECT_EQ(count(table, ">Pareto</span>"), 2u);
  EXPECT_TRUE(contains(table, "own/suture.json"));
  EXPECT_TRUE(contains(table, "UNRELIABLE: not converged, leaflets cross"));
  EXPECT_TRUE(contains(table, "Trade-offs between closure and other objectives"));
  EXPECT_TRUE(contains(table, "Plans without closures over the region are omitted."));
}

TEST(Report, AMarginAsFarAsTheRegionGoesIsSaidToBeMore) {
  SearchResult result = search_result();
  result.plans[0].region.margin_to_leak = {1.0, 5.0, 1.0};
  const std::string table = section(html_of(result), "All ranked plans");
  EXPECT_TRUE(contains(table, "<td>&gt; 1.00</td>"));
  EXPECT_TRUE(contains(table, "<td>&gt; 5.0</td>"));
}

TEST(Report, TheEvidenceOfAPlanIsItsMapsItsCurvesAndItsGates) {
  const std::string html = html_of(search_result());
  const std::string evidence = section(html, "Evidence, plan by plan");
  EXPECT_EQ(count(evidence, "<details"), 3u);
  EXPECT_EQ(count(evidence, "<details open>"), 1u);
  EXPECT_EQ(count(evidence, "both muscles, same error"), 2u);
  EXPECT_EQ(count(evidence, "anterolateral alone"), 1u);
  EXPECT_EQ(count(evidence, "With further remodelling"), 2u);
  EXPECT_EQ(count(evidence, "52 % first order, 66 % total"), 1u);
  EXPECT_EQ(count(evidence, "Sensitivity to errors of execution"), 2u)
      << "not of the plan that failed";
  EXPECT_EQ(count(evidence, "Coaptation in nine sections"), 3u);
  EXPECT_EQ(count(evidence, "papillary movement"), 1u) << "each rule once, with its plans";
  EXPECT_EQ(count(evidence, "– not assessed"), 1u);
  EXPECT_EQ(count(evidence, "✗ reject"), 1u);
  EXPECT_TRUE(contains(evidence, "thesis 4.2.3"));
  EXPECT_TRUE(contains(evidence, "<td>0.4</td><td>1.1</td><td>3.2</td>"));
  EXPECT_TRUE(contains(evidence, "1,089 closures over the region of interest, 2 of which failed"));
  EXPECT_EQ(count(evidence, ">nan<") + count(evidence, "=\"nan"), 0u);
}

TEST(Report, AStepOfTheFirstPlanHasACurveOfItsLeakOverItsErrors) {
  SearchResult result = search_result();
  result.plans[0].tolerance = {{0, StepError::RingSize, {-2.0, 0.0, 2.0}, {0.1, 0.2, 4.0}}};
  const std::string evidence = section(html_of(result), "Evidence, plan by plan");
  EXPECT_EQ(count(evidence, "Error of the ring"), 1u);
  EXPECT_EQ(count(evidence, "none or trace below 1 mm²"), 1u);
}

TEST(Report, TellsItsDateOnTheFirstPageAndEverySheet) {
  const std::vector<ClosedValve> after;
  const SearchResult result = search_result();
  const SearchRequest request = search_request();
  const std::string html =
      undrawn_report({closed("leaky", 5.0), after, result, request, 0, "28 November 2026"});
  EXPECT_TRUE(contains(html, "<p class=\"lead\">28 November 2026. "));
  EXPECT_TRUE(contains(html, "@top-right{content:\"28 November 2026"));
  EXPECT_FALSE(contains(html_of(search_result()), "2026. "));
  EXPECT_GT(today().size(), 9u);
}

TEST(Report, ListsWhatMeasurementsWouldSay) {
  SearchResult result = search_result();
  EXPECT_FALSE(contains(html_of(result), "What would say more")) << "too few draws";
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  result.information = {{"widest gap to 0.5 mm", 0.62, 5.6}, {"leaflet thickness", kNone, kNone}};
  const std::string table = section(html_of(result), "What would say more");
  for (const char* part : {"widest gap to 0.5 mm", "62 %", "5.6", "leaflet thickness", "n/a"})
    EXPECT_TRUE(contains(table, part)) << part;
}

TEST(Report, SaysHowTheSearchWent) {
  const std::string search = section(html_of(search_result()), "How the search went");
  for (const char* part : {"6,120 closures in 84.2 s", "12 did not converge", "310 were reused",
                           "1,214 plans tried", "45,678,901", "The search used all its closures.",
                           "random search, expected", "no marginal chorda is ruptured"})
    EXPECT_TRUE(contains(search, part)) << part;
}

TEST(Report, CostsFarAboveTheBestAreNotDrawn) {
  SearchResult result = search_result();
  const std::string usual = html_of(result);
  result.progress.insert(result.progress.begin(), {0, 1e6});
  EXPECT_TRUE(html_of(result) == usual);
}

TEST(Report, ListsWhatIsNotModelledAndWhatReproducesIt) {
  const std::string html = html_of(search_result());
  for (const std::string& sentence : not_modelled())
    EXPECT_TRUE(contains(section(html, "Limits"), sentence)) << sentence;
  const std::string reproduce = section(html, "How to reproduce");
  for (const std::string& part : {search_request().command, search_request().valve_hash,
                                  std::string(version()), std::string("18446744073709551615")})
    EXPECT_TRUE(contains(reproduce, part)) << part;
}

TEST(Report, IsSelfContainedAndWithoutScripts) {
  const std::string html = html_of(search_result(), {closed("v", 1.0)});
  for (const char* fetched : {"<script", "src=\"http", "<link", "url(", "@import"})
    EXPECT_FALSE(contains(html, fetched)) << fetched;
}

TEST(Report, ItsDrawingsAreWellFormed) {
  const std::string html = html_of(search_result());
  std::size_t drawings = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1))
    EXPECT_EQ(markup_error(html.substr(at, html.find("</svg>", at) + 6 - at)), "") << ++drawings;
  EXPECT_EQ(count(html, "<svg"), 5u) << "trade-offs, three plans, progress";
}

TEST(Report, EscapesEveryFreeText) {
  const std::string hostile = "<img src=x onerror=\"alert('1')\">";
  ClosedValve before = closed(hostile, 5.0);
  before.valve.provenance = {hostile};
  SearchResult result = search_result();
  for (RankedPlan& plan : result.plans) {
    plan.name = hostile;
    plan.description = plan.warnings = {hostile};
    for (Gate& gate : plan.gates) gate.rule = gate.finding = gate.source = hostile;
    for (LeakMap& map : plan.region.maps) map.muscle = hostile;
    for (RemodellingCurve& curve : plan.region.remodelling) curve.direction = hostile;
  }
  for (CutBranches& cut : result.cut) cut.what = cut.why = hostile;
  SearchRequest request = search_request();
  request.command = request.valve_hash = hostile;
  const std::string html = undrawn_report({before, {before, before}, result, request});
  EXPECT_FALSE(contains(html, "<img src=x"));
  EXPECT_TRUE(contains(html, "&lt;img src=x onerror=&quot;alert(&#39;1&#39;)&quot;&gt;"));
}

TEST(Report, OfASearchWithoutPlansShowsTheValve) {
  SearchResult result;
  result.stop = SearchStop::Cancelled;
  const std::string html = html_of(result);
  EXPECT_TRUE(contains(html, "The search ended before any plan was scored."));
  EXPECT_TRUE(contains(html, "The search was cancelled; this is the best plan so far."));
  EXPECT_TRUE(contains(html, "data:image/png"));
  EXPECT_FALSE(contains(html, "<svg"));
}

TEST(Report, SaysWhenNoPlanIsAcceptable) {
  SearchResult result = search_result();
  result.any_acceptable = false;
  EXPECT_TRUE(
      contains(html_of(result),
               "No plan is acceptable; plans are listed from the least to the most unfavourable."));
}

TEST(Report, OfAPlanThatWasClosedOnlyOnceHasNoMaps) {
  SearchResult result;
  result.plans = {ranked_plan(1, "ring")};
  result.plans[0].region = plans_scene::third().region;
  const std::string html = html_of(result);
  EXPECT_FALSE(contains(html, "Frame: the plan"));
  EXPECT_FALSE(contains(html, "Trade-offs between closure and other objectives"));
  EXPECT_TRUE(contains(html, "Leak with errors of execution</dt><dd>n/a<small>"));
  EXPECT_TRUE(contains(html, "This plan was not closed with errors of execution"));
}

}  // namespace
}  // namespace coapt
