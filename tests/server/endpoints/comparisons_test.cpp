#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

/// A triangle at this height, as numbers.
Json sheet(double z_mm) {
  return {{"mesh",
           {{"vertices_mm", {{0, 0, z_mm}, {1, 0, z_mm}, {0, 1, z_mm}}}, {"faces", {{0, 1, 2}}}}}};
}

Json file(const char* name) {
  return {{"file", {{"name", name}, {"text", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}}};
}

using ComparisonsTest = ServiceTest;

TEST_F(ComparisonsTest, ASheetLiesAsFarFromAnotherAsItWasMoved) {
  const Json request = {
      {"closed", sheet(0.5)}, {"reference", file("flat.obj")}, {"align", "none"}, {"nodes", true}};
  const Answer answer = post("/v1/comparisons", request);
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  const Json found = json_of(answer);
  EXPECT_EQ(found["schema"], "coapt.comparison/1");
  EXPECT_DOUBLE_EQ(found["rms_mm"], 0.5);
  EXPECT_DOUBLE_EQ(found["mean_signed_mm"], 0.5);
  EXPECT_NEAR(found["rms_after_rigid_mm"], 0.0, 1e-12);
  EXPECT_EQ(found["closed"]["source"], "mesh");
  EXPECT_EQ(found["reference"]["source"], "flat.obj");
  EXPECT_EQ(found["nodes"]["signed_mm"], Json({0.5, 0.5, 0.5}));
  EXPECT_FALSE(found["closed"].contains("closure"));
}

TEST_F(ComparisonsTest, AValveIsClosedFirstAndLiesOnItself) {
  const Json valve = {{"valve", stored_valve()}};
  const Answer answer = post("/v1/comparisons", {{"closed", valve}, {"reference", valve}});
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  EXPECT_DOUBLE_EQ(json_of(answer)["max_mm"], 0.0);
  EXPECT_EQ(json_of(answer)["closed"]["closure"], "converged");
}

TEST_F(ComparisonsTest, WhatIsNoShapeIsRefusedWhereItStands) {
  const auto refused = [this](const Json& reference) {
    return refusal(post("/v1/comparisons", {{"closed", sheet(0.0)}, {"reference", reference}}));
  };
  Json both = sheet(0.0), gap = sheet(0.0), points = sheet(0.0);
  both["file"] = file("flat.obj")["file"];
  gap["mesh"]["faces"] = {{0, 1, 3}};
  points["mesh"].erase("faces");
  EXPECT_EQ(refused(Json::object()), (Refused{422, {"/reference"}}));
  EXPECT_EQ(refused(both), (Refused{422, {"/reference"}}));
  EXPECT_EQ(refused(gap), (Refused{422, {"/reference/mesh"}}));
  EXPECT_EQ(refused(points), (Refused{422, {"/reference"}}));
  EXPECT_EQ(refused(file("flat.step")), (Refused{422, {"/reference/file/name"}}));
  EXPECT_EQ(refused({{"valve", "no-such"}}), (Refused{422, {"/reference/valve"}}));
}

TEST_F(ComparisonsTest, AMeshOfMoreVerticesThanTheServiceTakesIsRefused) {
  limits_.vertices = 0;
  EXPECT_EQ(refusal(post("/v1/comparisons", {{"closed", sheet(0.0)}, {"reference", sheet(1.0)}})),
            (Refused{422, {"/closed", "/reference"}}));
}

}  // namespace
}  // namespace coapt
