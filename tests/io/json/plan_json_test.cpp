#include "io/json/plan_json.h"

#include "tests/io/json/found.h"

namespace coapt {
namespace {

using enum ErrorCode;

constexpr LeafletPoint kPoint = {Leaflet::Anterior, 0.25, 1.0};

// One of each kind, and both forms of ring and anchor.
RepairPlan full_plan() {
  return {{Annuloplasty{OwnRing{2}}, Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
           Neochorda{"AL1", kPoint, 18.5}, ChordalLengthChange{"a", -1.25}, ChordalExcision{"b"},
           ChordalTransfer{"c", kPoint},
           PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, 24.0},
           PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.9, 25.0},
           EdgeToEdge{EdgeDevice::Clip, 0.4, 6.0},
           LeafletResection{.leaflet = Leaflet::Anterior, .width_mm = 8.0},
           LeafletResection{.shape = ResectionShape::Quadrangular, .sliding = false},
           Annuloplasty{DesignedRing{{"mine", {.p3_inset = 0.05, .saddle = 0.1}}, 30.0}}}};
}

Found found_in_steps(std::string_view steps) {
  return problems_of(
      read_plan(R"({"schema": "coapt.plan/1", "steps": )" + std::string(steps) + "}"));
}

TEST(PlanJson, RoundTripKeepsEveryStep) {
  const std::string text = to_json(full_plan()).dump();
  const auto plan = read_plan(text);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->steps.size(), 12u);
  EXPECT_EQ(to_json(*plan).dump(), text);
  EXPECT_EQ(std::get<OwnRing>(std::get<Annuloplasty>(plan->steps[0]).ring).sizes_below, 2);
  EXPECT_EQ(std::get<CatalogueRing>(std::get<Annuloplasty>(plan->steps[1]).ring).size_mm, 30.0);
  const auto& designed = std::get<DesignedRing>(std::get<Annuloplasty>(plan->steps[11]).ring);
  EXPECT_EQ(designed.shape, (DesignedShape{"mine", {.p3_inset = 0.05, .saddle = 0.1}}));
  EXPECT_EQ(designed.size_mm, 30.0);
  EXPECT_EQ(std::get<Neochorda>(plan->steps[2]).insertion.along, 0.25);
  EXPECT_EQ(std::get<ChordalLengthChange>(plan->steps[3]).change_mm, -1.25);
  EXPECT_EQ(std::get<PapillaryApproximation>(plan->steps[7]).annulus_around, 0.9);
}

TEST(PlanJson, AClipOf02IsReadAndAStitchHasNothingOfAClip) {
  const auto plan = read_plan(R"({"schema": "coapt.plan/1", "steps": [
      {"step": "edge_to_edge", "device": "clip", "along": 0.5, "width_mm": 4},
      {"step": "edge_to_edge", "device": "stitch", "along": 0.3, "width_mm": 4}]})");
  ASSERT_TRUE(plan);
  const auto& clip = std::get<EdgeToEdge>(plan->steps[0]);
  EXPECT_EQ(clip.grasp_mm, 5.0);
  EXPECT_EQ(clip.rows, 2);
  EXPECT_EQ(clip.annulus_drawn_in_percent, 11.0);
  EXPECT_FALSE(to_json(*plan)["steps"][1].contains("grasp_mm"));
}

TEST(PlanJson, OnlyTheFieldsThatMatterAreWritten) {
  const Json plan = to_json(full_plan());
  EXPECT_FALSE(plan["steps"][0].contains("size_mm"));
  EXPECT_FALSE(plan["steps"][1].contains("sizes_below"));
  EXPECT_FALSE(plan["steps"][6].contains("annulus_around"));
  EXPECT_FALSE(plan["steps"][9].contains("sliding"));
  EXPECT_FALSE(plan["steps"][10].contains("leaflet"));
  EXPECT_FALSE(plan["steps"][10].contains("height"));
}

TEST(PlanJson, DoingNothingIsAPlan) { EXPECT_EQ(found_in_steps("[]"), Found{}); }

TEST(PlanJson, WhatAResectionOfThatShapeHasNotIsRefused) {
  EXPECT_EQ(found_in_steps(R"([{"step": "leaflet_resection", "shape": "quadrangular", "along": 0.5,
                       "width_mm": 31, "height": 0.7, "sliding": true},
                      {"step": "leaflet_resection", "shape": "triangular", "along": 0.5,
                       "leaflet": "posterior", "width_mm": 10, "height": 0.2},
                      {"step": "leaflet_resection", "shape": "round"},
                      {"step": "edge_to_edge", "device": "glue", "along": 0, "width_mm": 1}])"),
            (Found{{OutOfRange, "/steps/0/width_mm"},
                   {UnknownField, "/steps/0/height"},
                   {OutOfRange, "/steps/1/height"},
                   {BadReference, "/steps/2/shape"},
                   {BadReference, "/steps/3/device"},
                   {OutOfRange, "/steps/3/along"},
                   {OutOfRange, "/steps/3/width_mm"}}));
}

TEST(PlanJson, ProblemsOfAllStepsAreListed) {
  EXPECT_EQ(found_in_steps(R"([{"step": "annuloplasty", "shape": "own", "sizes_below": 7},
                      {"step": "annuloplasty", "shape": "generic-classic", "size_mm": 31},
                      {"step": "annuloplasty", "shape": "own", "size_mm": 30},
                      {"step": "neochorda", "head": "AL1", "length_mm": 41,
                       "insertion": {"leaflet": "middle", "along": 1.5, "height": "free edge"}},
                      {"step": "resection"},
                      {"chorda": "a"},
                      7])"),
            (Found{{OutOfRange, "/steps/0/sizes_below"},
                   {OutOfRange, "/steps/1/size_mm"},
                   {MissingField, "/steps/2/sizes_below"},
                   {UnknownField, "/steps/2/size_mm"},
                   {BadReference, "/steps/3/insertion/leaflet"},
                   {OutOfRange, "/steps/3/insertion/along"},
                   {WrongType, "/steps/3/insertion/height"},
                   {OutOfRange, "/steps/3/length_mm"},
                   {BadReference, "/steps/4/step"},
                   {MissingField, "/steps/5/step"},
                   {WrongType, "/steps/6"}}));
}

TEST(PlanJson, OnlyAnAnnulusPointHasAPlace) {
  const std::string start =
      R"([{"step": "papillary_approximation", "side": "posteromedial", "suture_length_mm": 24, )";
  EXPECT_EQ(found_in_steps(start + R"("anchor": "annulus_point"}])"),
            (Found{{MissingField, "/steps/0/annulus_around"}}));
  EXPECT_EQ(found_in_steps(start + R"("anchor": "saddle_peak", "annulus_around": 0.5}])"),
            (Found{{UnknownField, "/steps/0/annulus_around"}}));
  EXPECT_EQ(found_in_steps(start + R"("anchor": "apex"}])"),
            (Found{{BadReference, "/steps/0/anchor"}}));
}

TEST(PlanJson, AtMostAHundredSteps) {
  Json steps = Json::array();
  for (int i = 0; i < 100; ++i) steps.push_back({{"step", "chordal_excision"}, {"chorda", "a"}});
  EXPECT_EQ(found_in_steps(steps.dump()), Found{});
  steps.push_back(steps[0]);
  EXPECT_EQ(found_in_steps(steps.dump()), (Found{{OutOfRange, "/steps"}}));
}

TEST(PlanJson, OtherSchemasAreNotSupported) {
  EXPECT_EQ(problems_of(read_plan(R"({"schema": "coapt.valve/1", "steps": []})")),
            (Found{{Unsupported, "/schema"}}));
  EXPECT_EQ(problems_of(read_plan("not a plan")), (Found{{InvalidJson, ""}}));
}

}  // namespace
}  // namespace coapt
