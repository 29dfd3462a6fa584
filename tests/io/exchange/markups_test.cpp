#include <gtest/gtest.h>

#include "io/exchange/valve_markups.h"
#include "io/json/json.h"
#include "still_valve.h"

namespace coapt {
namespace {

constexpr const char* kStart =
    R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#", "markups": [)";

Error problem(const std::string& text) {
  const Expected<std::vector<Markup>> markups = read_markups(text);
  EXPECT_FALSE(markups) << "was read";
  return markups ? Error{} : markups.errors()[0];
}

TEST(Markups, WhatIsWrittenIsReadBack) {
  const ClosedValve exported = still_valve();
  const std::vector<Markup> markups = valve_markups(exported, closed_shape(exported));
  const Expected<std::vector<Markup>> read = read_markups(write_markups(markups));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), markups.size());
  for (std::size_t i = 0; i < markups.size(); ++i) {
    EXPECT_EQ((*read)[i].type, markups[i].type);
    EXPECT_EQ((*read)[i].name, markups[i].name);
    EXPECT_EQ((*read)[i].labels, markups[i].labels);
    EXPECT_EQ((*read)[i].points_mm, markups[i].points_mm);
  }
}

TEST(Markups, LandmarksHaveSlicerHeartsLabels) {
  const ClosedValve exported = still_valve();
  const Markup marks = landmark_markup(exported.valve, closed_shape(exported));
  EXPECT_EQ(marks.labels, (std::vector<std::string>{"A", "P", "AL", "PM", "ALC", "PMC"}));
  EXPECT_LT((Vec3(marks.points_mm.row(0)) - Vec3(0.0, 14.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((Vec3(marks.points_mm.row(2)) - Vec3(-18.0, 0.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((Vec3(marks.points_mm.row(5)) - Vec3(18.0, 0.0, 0.0)).norm(), 1e-9);
}

TEST(Markups, WhatWasSewnInIsDrawn) {
  ClosedValve exported = still_valve();
  EXPECT_TRUE(repair_markups(exported, closed_shape(exported)).empty());
  exported.plan.steps = {
      Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
      PapillaryApproximation{Side::Posteromedial, Anchor::SaddlePeak, 0.25, 20.0}};
  exported.valve.chordae[1].kind = ChordaKind::Neochorda;
  const std::vector<Markup> sewn = repair_markups(exported, closed_shape(exported));
  ASSERT_EQ(sewn.size(), 3U);
  EXPECT_EQ(sewn[0].name, "ring: generic-classic, size 30 mm");
  EXPECT_EQ(sewn[0].type, MarkupType::ClosedCurve);
  EXPECT_EQ(Vec3(sewn[1].points_mm.row(0)), Vec3(12.0, -2.0, -26.0));
  EXPECT_LT((Vec3(sewn[1].points_mm.row(1)) - Vec3(0.0, 14.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(sewn[2].name, "PM1-A2-strut-1");
  EXPECT_EQ(sewn[2].points_mm.row(1), exported.valve.rest_mm.row(18));
}

TEST(Markups, RasIsTurnedIntoLpsAndUndefinedPointsArePassedOver) {
  const Expected<std::vector<Markup>> read = read_markups(
      std::string(kStart) +
      R"({"type": "ROI", "center": [0, 0, 0]}, {"type": "Fiducial", "name": "papillary", "coordinateSystem": "RAS",
          "controlPoints": [{"label": "AL", "position": [1, 2, 3], "positionStatus": "defined"},
                            {"label": "x", "positionStatus": "undefined"}]}]})");
  ASSERT_TRUE(read) << read.errors()[0].path;
  ASSERT_EQ(read->size(), 1U);
  EXPECT_EQ((*read)[0].labels, std::vector<std::string>{"AL"});
  EXPECT_EQ(Vec3((*read)[0].points_mm.row(0)), Vec3(-1.0, -2.0, 3.0));
}

TEST(Markups, WhatIsWrongIsPointedAt) {
  EXPECT_EQ(problem("{").code, ErrorCode::InvalidJson);
  EXPECT_EQ(problem(R"({"markups": []})").path, "/@schema");
  EXPECT_EQ(problem(R"({"@schema": "other", "markups": []})").code, ErrorCode::Unsupported);
  EXPECT_EQ(problem(std::string(kStart) + R"({"type": "Line"}]})").path,
            "/markups/0/controlPoints");
  EXPECT_EQ(problem(std::string(kStart) +
                    R"({"type": "Line", "coordinateSystem": "IJK", "controlPoints": []}]})")
                .code,
            ErrorCode::Unsupported);
  EXPECT_EQ(problem(std::string(kStart) +
                    R"({"type": "Line", "coordinateUnits": "um", "controlPoints": []}]})")
                .code,
            ErrorCode::Unsupported);
  EXPECT_EQ(problem(std::string(kStart) +
                    R"({"type": "Line", "controlPoints": [{"position": [1, 2, 1e9]}]}]})")
                .path,
            "/markups/0/controlPoints/0/position");
  EXPECT_EQ(problem(std::string(kStart) + R"({"type": "Line", "controlPoints": [4]}]})").code,
            ErrorCode::WrongType);
}

}  // namespace
}  // namespace coapt
