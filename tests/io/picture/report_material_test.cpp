#include "io/picture/report_material.h"

#include <gtest/gtest.h>

#include "core/repair/apply_plan.h"
#include "core/valve/parametric.h"
#include "tests/io/plans_scene.h"
#include "tests/scenes/small_preset.h"

namespace coapt {
namespace {

Valve coarse_valve() {
  ParametricValve dimensions;
  dimensions.triangles = 150;
  Valve valve = *make_parametric_valve(dimensions);
  valve.name = "<picture 1 0> & \"co\"";
  return valve;
}

/// The scene's words on plans of this valve that are closed: a suture, a ring, nothing.
SearchResult closed_search(const Valve& valve) {
  SearchResult result = search_result();
  result.closed_before = std::make_shared<const ClosedValve>(close_and_measure(valve));
  PapillaryApproximation suture;
  suture.suture_length_mm =
      0.9 * (papillary_tip_mm(valve, suture.side) - anchor_mm(valve, suture)).norm();
  const std::vector<RepairPlan> plans = {
      {{suture}}, {{Annuloplasty{OwnRing{.sizes_below = 1}}}}, {}};
  EXPECT_EQ(result.plans.size(), plans.size());
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const Expected<Valve> repaired = apply_plan(valve, plans[i]);
    EXPECT_TRUE(repaired) << repaired.errors()[0].message;
    if (!repaired) return {};
    result.plans[i].closed = std::make_shared<const ClosedValve>(
        with_repair(close_and_measure(*repaired), valve, plans[i]));
  }
  return result;
}

TEST(ReportMaterial, MakesTheReportsOnAllPlansAndOnOneByteForByte) {
  const Valve valve = coarse_valve();
  const SearchResult result = closed_search(valve);
  const ReportMaterial made = report_material(result, search_request());
  const std::string material = write_report_material(made);
  const PlanPictures pictures = pictures_of(result);
  ASSERT_EQ(*report_pages(material), 4u);
  std::size_t reports_size = 0;
  for (const int about : {0, 3}) {
    const std::string report = plan_report_html(
        {pictures.before, pictures.after, result, search_request(), about, today()});
    const Expected<std::string> page =
        report_page(material, static_cast<std::size_t>(about), valve);
    ASSERT_TRUE(page);
    EXPECT_TRUE(*page == report) << "report " << about;
    reports_size += report.size();
  }
  EXPECT_LT(material.size(), reports_size / 2) << "a fourth of all four";
}

TEST(ReportMaterial, OfASearchWithoutPlansThereIsOneReport) {
  const Valve valve = coarse_valve();
  SearchResult result = closed_search(valve);
  result.plans.clear();
  const std::string material = write_report_material(report_material(result, search_request()));
  ASSERT_EQ(*report_pages(material), 1u);
  EXPECT_TRUE(*report_page(material, 0, valve) == plan_report_html(result, search_request()));
  EXPECT_FALSE(report_page(material, 1, valve));
}

TEST(ReportMaterial, WhatIsCutShortOrOfAnotherValveIsRefused) {
  const Valve valve = coarse_valve();
  const std::string material =
      write_report_material(report_material(closed_search(valve), search_request()));
  for (std::size_t size = 0; size < material.size(); size += 1 + material.size() / 97)
    EXPECT_FALSE(report_page(material.substr(0, size), 1, valve)) << size;
  const Expected<std::string> other = report_page(material, 1, small_preset("human-functional-mr"));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.errors()[0].code, ErrorCode::Unsupported);
}

}  // namespace
}  // namespace coapt
