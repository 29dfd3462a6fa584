#include <gtest/gtest.h>

#include "io/json/result_json.h"
#include "io/picture/picture.h"
#include "tests/scenes/sheets.h"

namespace coapt {
namespace {

ClosedValve closed(const std::string& name, double hole_mm) {
  Valve valve = disc_with_hole(15.0, hole_mm, 64);
  valve.name = name;
  const ClosureResult closure = closed_at_rest(valve);
  return {valve, closure, measure(valve, closure)};
}

RankedPlan ranked_plan(int rank, const std::string& words) {
  RankedPlan plan;
  plan.rank = rank;
  plan.description = {words};
  plan.orifice_area_mm2 = plan.leak_mm2 = {1.25, 2.5, 0.75, 9.5};
  return plan;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Report, HasThePlansTheNoticeTheCommandAndThePictures) {
  SearchResult result;
  result.plans = {ranked_plan(1, "first ring"), ranked_plan(2, "second ring")};
  result.best_cost_history = {5.0, 4.0, 4.0, 1.0};
  result.closures = 4;
  const std::string html =
      plan_report_html(closed("leaky", 5.0), {closed("leaky", 1.0), closed("leaky", 2.0)}, result,
                       "coapt plan leaky.json --seed 1");
  EXPECT_TRUE(contains(html, std::string(kResearchNotice)));
  EXPECT_TRUE(contains(html, "coapt plan leaky.json --seed 1"));
  for (const char* part : {"first ring", "second ring", "1.2", "2.5 ± 0.8 mm²", "9.5", "<svg",
                           "What is not modelled", "4 closures"})
    EXPECT_TRUE(contains(html, part)) << part;
  EXPECT_LT(html.find("data:image/png"), html.find("<table>")) << "the picture comes first";
}

TEST(Report, IsSelfContainedAndWithoutScripts) {
  SearchResult result;
  result.plans = {ranked_plan(1, "ring")};
  const std::string html = plan_report_html(closed("v", 5.0), {closed("v", 1.0)}, result, "c");
  EXPECT_FALSE(contains(html, "<script"));
  EXPECT_FALSE(contains(html, "src=\"http"));
  EXPECT_FALSE(contains(html, "<link"));
  EXPECT_FALSE(contains(html, "url("));
}

TEST(Report, EscapesEveryFreeText) {
  const std::string hostile = "<img src=x onerror=\"alert('1')\">";
  ClosedValve before = closed(hostile, 5.0);
  before.valve.provenance = {hostile};
  SearchResult result;
  result.plans = {ranked_plan(1, hostile), ranked_plan(2, hostile)};
  result.plans[0].warnings = {hostile};
  result.plans[1].warnings = {hostile};
  const std::string html = plan_report_html(before, {before, before}, result, hostile);
  EXPECT_FALSE(contains(html, "<img src=x"));
  EXPECT_TRUE(contains(html, "&lt;img src=x onerror=&quot;alert(&#39;1&#39;)&quot;&gt;"));
}

TEST(Report, OfASearchWithoutPlansShowsTheValve) {
  SearchResult result;
  result.stop = SearchStop::Cancelled;
  const std::string html = plan_report_html(closed("v", 5.0), {}, result, "c");
  EXPECT_TRUE(contains(html, "The search ended before any plan was scored."));
  EXPECT_TRUE(contains(html, "It was cancelled"));
  EXPECT_TRUE(contains(html, "data:image/png"));
  EXPECT_FALSE(contains(html, "<svg"));
}

TEST(Report, SaysWhenAPlanDidNotConvergeOrCrossed) {
  SearchResult result;
  result.plans = {ranked_plan(1, "ring")};
  result.plans[0].status = ClosureStatus::StepLimit;
  result.plans[0].crossing = true;
  const std::string html = plan_report_html(closed("v", 5.0), {}, result, "c");
  EXPECT_TRUE(contains(html, "closure: step_limit"));
  EXPECT_TRUE(contains(html, "leaflets pass through each other"));
}

}  // namespace
}  // namespace coapt
