// "files" of an import: what each of them is, is detected.
#include <gtest/gtest.h>

#include "tests/io/exchange/abaqus_cone.h"
#include "tests/server/endpoints/import_scene.h"

namespace coapt {
namespace {

class DetectedFilesTest : public ServiceTest {
 protected:
  Answer imported(const Json& request) { return post("/v1/valves:import", request); }
  Refused refused(const Json& request) { return refusal(imported(request)); }
};

/// The cone's three files, in any order.
Json cone_files() {
  const Json named = cone_request();
  return {{"files", {named["chordae"], named["leaflets"][0], named["annulus"]}},
          {"triangles", 300}};
}

TEST_F(DetectedFilesTest, MakeTheValveThatNamedPartsMake) {
  const Answer named = imported(cone_request()), detected = imported(cone_files());
  ASSERT_EQ(detected.status, 201) << json_of(detected);
  EXPECT_EQ(json_of(detected)["vertices"], json_of(named)["vertices"]);
  EXPECT_EQ(json_of(detected)["chordae"], json_of(named)["chordae"]);
  EXPECT_EQ(decision_about(json_of(detected)["decisions"], "files")["value"],
            "file 1 of 3 (.csv) is chordae");
}

TEST_F(DetectedFilesTest, WithoutChordaeGetSynthesisedOnes) {
  const Json named = unseen_request();
  Json request = {{"files", named["leaflets"]}, {"triangles", 300}};
  request["files"].push_back(named["annulus"]);
  const Answer answer = imported(request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["drawn_chordae"]["seed"], 1);
  request = cone_files();
  request["chordae_seed"] = 3;
  EXPECT_EQ(refused(request), (Refused{422, {"/chordae_seed"}})) << "it has chordae";
}

TEST_F(DetectedFilesTest, AreNamedByTheirPlaceInTheRequest) {
  Json request = cone_files();
  request["files"][1]["text"] = "f 1 2 3";
  request["files"][2]["text"] = "x;y;z";
  for (const std::string& path : refused(request).paths)
    EXPECT_TRUE(path.starts_with("/files/1") || path.starts_with("/files/2")) << path;
  request = cone_files();
  request["files"].push_back({{"name", "notes.txt"}, {"text", "a, b"}});
  EXPECT_EQ(refused(request), (Refused{422, {"/files/3"}}));
  request["files"] = Json::array();
  EXPECT_EQ(refused(request), (Refused{422, {"/files"}}));
}

TEST_F(DetectedFilesTest, GoBesideNamedPartsThatTheyLack) {
  const Json named = cone_request();
  Json request = {{"files", {named["chordae"], named["annulus"]}},
                  {"leaflets", named["leaflets"]},
                  {"triangles", 300}};
  EXPECT_EQ(imported(request).status, 201);
  request["annulus"] = named["annulus"];
  EXPECT_EQ(refused(request), (Refused{422, {"/annulus"}})) << "there would be two";
}

TEST_F(DetectedFilesTest, AreSortedOneByOneWhateverTheirNames) {
  const Json named = cone_request();
  Json request = cone_files();
  request["slicerheart"] = Json::array();
  EXPECT_EQ(refused(request), (Refused{422, {"/files"}})) << "either of both";
  request.erase("slicerheart");
  request["files"].erase(2);
  request["annulus"] = named["annulus"];
  request["tips"] = {{"name", "tips.mrk.json"}, {"text", "{}"}};
  EXPECT_TRUE(refused(request).paths.front().starts_with("/tips"))
      << "nothing that is given is left out";
}

TEST_F(DetectedFilesTest, AreNoFiniteElementModelOfAnyValve) {
  Json request = {{"files", {{{"name", "model.inp"}, {"text", abaqus_cone()}}}}};
  EXPECT_EQ(refused(request), (Refused{422, {"/files/0"}})) << "only mitral valves are stored";
  request["observed"] = {{"leak_mm2", {{"value", 30.0}, {"sd", 5.0}}}};
  EXPECT_EQ(refused(request), (Refused{422, {"/observed"}}));
  request.erase("observed");
  request["files"][0]["text"] = "*NODE\n1, a, b, c\n";
  EXPECT_TRUE(refused(request).paths.front().starts_with("/files/0"));
  request["flip"] = true;
  request["tips"] = cone_request()["annulus"];
  EXPECT_EQ(refused(request), (Refused{422, {"/tips", "/flip"}})) << "both are of mitral valves";
  request["files"].push_back(cone_request()["annulus"]);
  EXPECT_EQ(refused(request), (Refused{422, {"/files/0"}}));
}

TEST_F(DetectedFilesTest, TheGridOfTheImagesIsOfLabelMapsAlone) {
  Json request = cone_files();
  request["grid"] = {{"size", {4, 4, 4}},
                     {"to_lps_mm", {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
  EXPECT_EQ(refused(request), (Refused{422, {"/labels"}}));
  request["grid"]["to_lps_mm"] = {{1, 0, 0, 0}, {0, 1, 0, 0}};
  EXPECT_EQ(refused(request), (Refused{422, {"/grid"}}));
}

}  // namespace
}  // namespace coapt
