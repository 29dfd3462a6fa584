#include <array>
#include <vector>

#include "operations/surface_file.h"
#include "operations/table.h"
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

/// A polygon of so many triangles that are all the same two.
Json fan(int triangles) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2";
  for (int i = 0; i < triangles; ++i) text += i % 2 == 0 ? " 3" : " 2";
  return {{"file", {{"name", "fan.obj"}, {"text", text + '\n'}}}};
}

/// A triangle so many times, as numbers.
Json repeated(int triangles) {
  Json shape = sheet(0.0);
  shape["mesh"]["faces"] = std::vector(static_cast<std::size_t>(triangles), std::array{0, 1, 2});
  return shape;
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

TEST_F(ComparisonsTest, AValveIsClosedAsClosuresAre) {
  const Json valve = {{"valve", stored_valve()}};
  Json softer = valve;
  softer["material"] = {{"pressure_mmhg", 60.0}};
  const Answer moved = post("/v1/comparisons", {{"closed", softer}, {"reference", valve}});
  ASSERT_EQ(moved.status, 200) << json_of(moved);
  EXPECT_GT(json_of(moved)["max_mm"], 0.0);
  const Answer finer =
      post("/v1/comparisons", {{"closed", valve}, {"reference", valve}, {"certainty", "sure"}});
  ASSERT_EQ(finer.status, 200) << json_of(finer);
  EXPECT_GT(json_of(finer)["closed"]["nodes"], json_of(moved)["closed"]["nodes"]);
}

TEST_F(ComparisonsTest, HowValvesAreClosedIsRefusedWhereItCannotBe) {
  const Json valve = {{"valve", stored_valve()}};
  EXPECT_EQ(refusal(post("/v1/comparisons", {{"closed", sheet(0.5)},
                                             {"reference", sheet(0.0)},
                                             {"method", "thesis"},
                                             {"certainty", "sure"}})),
            (Refused{422, {"/method", "/certainty"}}));
  EXPECT_EQ(refusal(post("/v1/comparisons", {{"closed", valve},
                                             {"reference", sheet(0.0)},
                                             {"accuracy_mm2", 1.0},
                                             {"converge", Json::object()}})),
            (Refused{422, {"/converge"}}));
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

TEST_F(ComparisonsTest, AMeshOfMoreTrianglesThanTheServiceTakesIsRefused) {
  limits_.vertices = 1;  // 20 vertices, 40 triangles
  const auto answer = [this](const Json& closed) {
    return post("/v1/comparisons", {{"closed", closed}, {"reference", sheet(1.0)}});
  };
  EXPECT_EQ(answer(repeated(40)).status, 200);
  EXPECT_EQ(refusal(answer(repeated(41))), (Refused{422, {"/closed"}}));
  EXPECT_EQ(answer(fan(40)).status, 200);
  const Answer refused = answer(fan(41));
  EXPECT_EQ(refusal(refused), (Refused{422, {"/closed/file/faces"}})) << "while it is read";
  EXPECT_NE(content_bytes(refused).find("more than the 40 triangles accepted"), std::string::npos);
}

TEST_F(ComparisonsTest, FilesAreReadInATurnAndNotWithTheBody) {
  const Json wrong = {{"closed", sheet(0.0)}, {"reference", file("flat.step")}};
  EXPECT_EQ(post("/v1/comparisons", wrong).status, 422);
  const Compute::Turn other(compute());
  EXPECT_EQ(post("/v1/comparisons", wrong).status, 503) << "it is not known what is wrong with it";
  EXPECT_EQ(post("/v1/comparisons", {{"closed", 1}, {"reference", file("flat.obj")}}).status, 422);
}

TEST_F(ComparisonsTest, OneThatIsOutOfTimeIsRefused) {
  Context context{.limits = OperationLimits::unlimited()};
  context.limits.seconds = 0.0;
  const auto task = read_compare({{"closed", sheet(0.0)}, {"reference", repeated(200)}}, context);
  ASSERT_TRUE(task);
  const auto answer = task->run(context);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.errors()[0].code, ErrorCode::Busy);
}

TEST_F(ComparisonsTest, ASurfaceCostsItsVerticesOrHalfOfItsTriangles) {
  Context context{.limits = OperationLimits::unlimited(), .surface_of = read_surface_file};
  const auto asked = [&](const Json& closed) {
    return *read_compare({{"closed", closed}, {"reference", sheet(1.0)}}, context);
  };
  EXPECT_EQ(asked(sheet(0.0)).vertices, 3);
  EXPECT_EQ(asked(repeated(200)).vertices, 100);
  EXPECT_FALSE(asked(repeated(200)).read_files) << "there are none";
  const OperationTask of_a_file = asked(fan(200));
  ASSERT_TRUE(of_a_file.read_files);
  EXPECT_EQ(*of_a_file.read_files(context), 100);
  EXPECT_TRUE(of_a_file.run(context));
  EXPECT_TRUE(asked(fan(200)).run(context)) << "which reads it, where nobody did";
}

}  // namespace
}  // namespace coapt
