// Closures, scenes, files and pictures: what is answered at once of a valve and a plan.

#include "io/exchange/formats.h"
#include "io/json/result_json.h"
#include "operations/table.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class ClosuresTest : public ServiceTest {};

const std::vector<std::string> kPaths = {"/v1/closures", "/v1/scenes", "/v1/exports",
                                         "/v1/pictures"};

/// A request to any of them.
Json request_to(const std::string& path) {
  Json request = {{"valve", small_document()}};
  if (path == "/v1/exports") request["format"] = "ply";
  return request;
}

Json plan_of(const Json& step) { return {{"schema", "coapt.plan/1"}, {"steps", {step}}}; }

TEST_F(ClosuresTest, AClosureIsThatOfTheValve) {
  const Answer answer = post("/v1/closures", {{"valve", small_document()}});
  EXPECT_EQ(answer.status, 200);
  Json json = json_of(answer);
  const ClosureResult closure = close_valve(small_valve());
  const Json same = closure_to_json(small_valve(), closure, measure(small_valve(), closure), 0.0);
  for (const char* key : {"schema", "status", "leak_mm2", "leak", "coaptation", "annulus"})
    EXPECT_EQ(json[key], same[key]) << key;
  EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(ClosuresTest, AClosureOfTooManyStepsIsRefused) {
  limits_.vertex_steps = 1000.0;
  for (const std::string& path : kPaths) {
    const Answer answer = post(path, request_to(path));
    EXPECT_EQ(answer.status, 422) << path;
    EXPECT_NE(content_bytes(answer).find("more than 1000 steps times vertices"), std::string::npos);
  }
}

TEST_F(ClosuresTest, ARequestOutOfTimeIsRefused) {
  limits_.request_seconds = 1e-9;
  for (const std::string& path : kPaths) {
    const Answer answer = post(path, request_to(path));
    EXPECT_EQ(answer.status, 503) << path;
    EXPECT_NE(content_bytes(answer).find("POST /v1/plans"), std::string::npos) << path;
  }
}

TEST_F(ClosuresTest, AValveMayBeWrittenThereOrNamed) {
  const auto leak_of = [&](const Json& valve) {
    return json_of(post("/v1/closures", {{"valve", valve}}))["leak_mm2"];
  };
  const Json written = leak_of(small_document());
  EXPECT_TRUE(written.is_number());
  EXPECT_EQ(leak_of(stored_valve()), written);
  EXPECT_EQ(refusal(post("/v1/closures", {{"valve", "nobody"}})), (Refused{422, {"/valve"}}));
}

TEST_F(ClosuresTest, APlanIsAppliedAndWarnedOf) {
  const Json ring = {{"step", "annuloplasty"}, {"shape", "own"}, {"sizes_below", 6}};
  const Json before = json_of(post("/v1/closures", request_to("/v1/closures")));
  Json request = request_to("/v1/closures");
  request["plan"] = plan_of(ring);
  const Answer answer = post("/v1/closures", request);
  ASSERT_EQ(answer.status, 200) << json_of(answer);
  EXPECT_LT(json_of(answer)["annulus"]["area_mm2"], before["annulus"]["area_mm2"]);
  EXPECT_FALSE(json_of(answer)["warnings"].empty());
}

TEST_F(ClosuresTest, ProblemsPointIntoTheRequest) {
  for (const std::string& path : kPaths) {
    Json wrong_valve = request_to(path);
    wrong_valve["valve"]["pressure_kpa"] = -1;
    EXPECT_EQ(refusal(post(path, wrong_valve)), (Refused{422, {"/valve/pressure_kpa"}})) << path;
    Json impossible = request_to(path);
    impossible["plan"] = plan_of({{"step", "chordal_excision"}, {"chorda", "none"}});
    EXPECT_EQ(refusal(post(path, impossible)), (Refused{422, {"/plan/steps/0/chorda"}})) << path;
    Json wrong_plan = request_to(path);
    wrong_plan["plan"] = plan_of({{"step", "fly"}});
    wrong_plan["surprise"] = 1;
    EXPECT_EQ(refusal(post(path, wrong_plan)), (Refused{422, {"/plan/steps/0/step", "/surprise"}}))
        << path;
  }
}

TEST_F(ClosuresTest, AMissingValveIsSaidAndWhatIsNoJsonIs400) {
  for (const std::string& path : kPaths) {
    Json request = request_to(path);
    request.erase("valve");
    EXPECT_EQ(refusal(post(path, request)), (Refused{422, {"/valve"}})) << path;
    for (const char* text : {"{", "", R"({"valve": NaN})"})
      EXPECT_EQ(ask("POST", path, text).status, 400) << path << ' ' << text;
    EXPECT_EQ(ask("POST", path, std::string(100'000, '[')).status, 400) << path;
  }
}

TEST_F(ClosuresTest, AValveThatIsTooLargeIsRefused) {
  limits_.vertices = 10;
  for (const std::string& path : kPaths)
    EXPECT_EQ(refusal(post(path, request_to(path))), (Refused{422, {"/valve/vertices_mm"}}))
        << path;
}

TEST_F(ClosuresTest, WithoutATurnTheyAre503) {
  const Compute::Turn other(compute());
  for (const std::string& path : kPaths) EXPECT_EQ(post(path, request_to(path)).status, 503);
}

TEST_F(ClosuresTest, ASceneHasItsClosureAndTheFramesAskedFor) {
  Json request = request_to("/v1/scenes");
  request["frames"] = 3;
  const Json scene = json_of(post("/v1/scenes", request));
  EXPECT_EQ(scene["schema"], "coapt.scene/2");
  EXPECT_EQ(scene["closure"]["schema"], "coapt.closure/2");
  EXPECT_EQ(scene["motion_mm"].size(), 3u);
  EXPECT_TRUE(json_of(post("/v1/scenes", request_to("/v1/scenes")))["motion_mm"].empty());
  request["frames"] = 61;
  EXPECT_EQ(refusal(post("/v1/scenes", request)), (Refused{422, {"/frames"}}));
}

TEST_F(ClosuresTest, FilesSayHowTheClosureWentAndUnderWhichNameToBeSaved) {
  for (const FileFormat& format : file_formats()) {
    Json request = request_to("/v1/exports");
    request["format"] = format.name;
    const Answer answer = post("/v1/exports", request);
    ASSERT_EQ(answer.status, 200) << format.name;
    EXPECT_EQ(std::get<Content>(answer.body).type, format.media_type);
    EXPECT_EQ(header_of(answer, "Coapt-Closure"), "converged");
    EXPECT_EQ(header_of(answer, "Content-Disposition"),
              std::string("attachment; filename=\"valve.") + format.name + '"');
  }
  Json request = request_to("/v1/exports");
  request["format"] = "exe";
  EXPECT_EQ(refusal(post("/v1/exports", request)), (Refused{422, {"/format"}}));
}

TEST_F(ClosuresTest, ALabelMapIsDrawnOnTheGridThatIsAskedFor) {
  Json request = request_to("/v1/exports");
  request["format"] = "nii";
  request["valve"]["patient_frame"] = {{1, 0, 0, 5}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  request["grid"] = {{"size", {60, 50, 40}},
                     {"to_lps_mm", {{1, 0, 0, -25}, {0, 1, 0, -25}, {0, 0, 1, -35}}}};
  const Answer answer = post("/v1/exports", request);
  ASSERT_EQ(answer.status, 200);
  EXPECT_EQ(std::get<Content>(answer.body).bytes.size(), 352U + 60 * 50 * 40);
  request["grid"]["to_lps_mm"][0][3] = 500;
  EXPECT_EQ(refusal(post("/v1/exports", request)), (Refused{422, {"/grid"}})) << "beside it";
  for (const auto& [member, wrong] : {std::pair("size", Json{60, 50}),
                                      {"size", {1000, 1000, 1000}},
                                      {"size", {60, 50, 0}},
                                      {"to_lps_mm", {{1, 0, 0, 0}, {0, 1, 0, 0}}},
                                      {"to_lps_mm", {{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}}}}) {
    Json bad = request;
    bad["grid"][member] = wrong;
    EXPECT_EQ(post("/v1/exports", bad).status, 422) << wrong;
  }
}

TEST_F(ClosuresTest, VoxelsAreCountedForEachLabelMapThatIsAskedFor) {
  Json request = {{"valve", small_document()}, {"formats", {"ply", "nrrd", "nii", "nii.gz"}}};
  request["grid"] = {{"size", {60, 50, 40}},
                     {"to_lps_mm", {{1, 0, 0, -25}, {0, 1, 0, -25}, {0, 0, 1, -35}}}};
  Context context{.limits = OperationLimits::unlimited()};
  EXPECT_DOUBLE_EQ(read_export_files(request, context)->seconds, 25e-9 * 3 * 60 * 50 * 40);
  request["grid"]["size"] = {320, 320, 320};
  EXPECT_TRUE(read_export_files(request, context)) << "without limits each has its own";
  const Answer refused = post("/v1/exports:files", request);
  EXPECT_EQ(refusal(refused), (Refused{422, {"/grid"}})) << "before it is closed";
  EXPECT_NE(content_bytes(refused).find("for each of 3 label maps"), std::string::npos);
  request["formats"] = {"ply", "stl"};
  EXPECT_EQ(read_export_files(request, context)->seconds, 0.0);
  EXPECT_EQ(post("/v1/exports:files", request).status, 200) << "none is a label map";
}

TEST_F(ClosuresTest, APictureIsAPng) {
  const Answer answer = post("/v1/pictures", request_to("/v1/pictures"));
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(std::get<Content>(answer.body).type, "image/png");
  EXPECT_EQ(bytes_of(answer).substr(0, 4), "\x89PNG");
  EXPECT_EQ(header_of(answer, "Coapt-Closure"), "converged");
}

}  // namespace
}  // namespace coapt
