// Valves out of the files of segmentation tools.
#include "server/endpoints/imports.h"

#include <openssl/evp.h>

#include "io/exchange/slicerheart.h"
#include "io/mesh/write_mesh.h"
#include "server/base64.h"
#include "tests/io/mesh/cone_scene.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

using nlohmann::ordered_json;

class ImportsTest : public ServiceTest {};

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(
      reinterpret_cast<unsigned char*>(text.data()),
      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()))));
  return text;
}

std::string row(const Vec3& p) {
  return std::to_string(p.x()) + ',' + std::to_string(p.y()) + ',' + std::to_string(p.z());
}

/// The cone as three files; its leaflet as STL, in base64, if asked.
ordered_json cone_request(bool as_stl = false) {
  const ImportSource source = cone_source();
  std::string annulus, chordae = "id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n";
  for (Index i = 0; i < source.annulus_mm.rows(); ++i)
    annulus += row(source.annulus_mm.row(i)) + '\n';
  for (const ImportedChorda& chorda : source.chordae)
    chordae += chorda.id + (chorda.side == Side::Anterolateral ? ",AL," : ",PM,") +
               row(chorda.insertion_mm) + ',' + row(chorda.tip_mm) + '\n';
  const std::string mesh = *write_mesh(source.leaflets.front(), as_stl ? "stl" : "obj");
  ordered_json leaflet = {{"name", as_stl ? "Skirt.STL" : "skirt.obj"}};
  leaflet[as_stl ? "base64" : "text"] = as_stl ? base64(mesh) : mesh;
  return {{"leaflets", {leaflet}},
          {"annulus", {{"name", "annulus.csv"}, {"text", annulus}}},
          {"chordae", {{"name", "chordae.csv"}, {"text", chordae}}},
          {"triangles", 300}};
}

TEST_F(ImportsTest, FilesBecomeAValveThatIsStored) {
  ordered_json request = cone_request();
  request["name"] = "a cone";
  request["provenance"] = {"made up"};
  const Answer answer = post("/v1/valves:import", request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const ordered_json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["name"], "a cone");
  EXPECT_EQ(valve["provenance"][0], "made up");
  const ordered_json decisions = json_of(answer)["decisions"];
  ASSERT_EQ(decisions.size(), 8U);
  EXPECT_EQ(decisions[0], (ordered_json{{"about", "units"},
                                        {"decision", "mm"},
                                        {"reason", "by the annulus's circumference"}}));
  EXPECT_EQ(valve["faces"].size(), json_of(answer)["triangles"]);
  EXPECT_EQ(post("/v1/valves:import", request).status, 200);
}

TEST_F(ImportsTest, BinaryFilesComeInBase64) {
  const Answer answer = post("/v1/valves:import", cone_request(true));
  EXPECT_EQ(answer.status, 201) << json_of(answer);
}

TEST_F(ImportsTest, AFolderOfSlicerHeartIsAListOfFiles) {
  const Expected<std::vector<NamedFile>> folder =
      write_slicerheart(close_and_measure(small_valve(), {.motion = true}), {.open = true});
  ASSERT_TRUE(folder);
  ordered_json files = ordered_json::array();
  for (const NamedFile& file : *folder)
    files.push_back({{"name", file.name}, {"text", file.bytes}});
  const Answer answer = post("/v1/valves:import", {{"slicerheart", files}, {"triangles", 150}});
  EXPECT_EQ(answer.status, 201) << json_of(answer);
  files = {files.front()};
  const Answer refused = post("/v1/valves:import", {{"slicerheart", files}});
  EXPECT_EQ(refusal(refused).status, 422);
  EXPECT_EQ(refusal(refused).paths.front(), "/slicerheart");
}

/// Two sheets whose chordae nobody has seen.
ordered_json unseen_request() {
  const ImportSource source = cone_source_with_gaps();
  ordered_json request = cone_request();
  request["leaflets"] = ordered_json::array();
  for (const TriangleMesh& sheet : source.leaflets)
    request["leaflets"].push_back({{"name", "sheet.obj"}, {"text", *write_mesh(sheet, "obj")}});
  request.erase("chordae");
  request["chordae_seed"] = 1;
  return request;
}

TEST_F(ImportsTest, ChordaeThatWereNotSeenAreDrawn) {
  const Answer answer = post("/v1/valves:import", unseen_request());
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const ordered_json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["drawn_chordae"], (ordered_json{{"seed", 1}, {"tips_given", false}}));
  EXPECT_EQ(json_of(answer)["decisions"].back()["about"], "chordae");
  ordered_json seen = unseen_request();
  seen["tips"] = {{"name", "tips.csv"}, {"text", "AL,-13,-4,-24\nPM,13,-4,-24\n"}};
  const Answer with_tips = post("/v1/valves:import", seen);
  ASSERT_EQ(with_tips.status, 201) << json_of(with_tips);
  EXPECT_EQ(json_of(with_tips)["decisions"].back()["reason"], "papillary tips as given");
}

TEST_F(ImportsTest, WhatGoesWithDrawnChordaeOnlyIsRefusedWithout) {
  const auto refused = [&](const ordered_json& request) {
    return refusal(post("/v1/valves:import", request));
  };
  ordered_json both = cone_request(), tips = cone_request(), closed = cone_request(),
               far = unseen_request();
  both["chordae_seed"] = 1;
  EXPECT_EQ(refused(both), (Refused{422, {"/chordae_seed"}}));
  tips["tips"] = {{"name", "tips.csv"}, {"text", "AL,-13,-4,-24\n"}};
  EXPECT_EQ(refused(tips), (Refused{422, {"/tips"}}));
  closed["closed"] = true;
  closed["hidden_mm"] = 16.0;
  EXPECT_EQ(refused(closed), (Refused{422, {"/hidden_mm"}}));
  closed["hidden_mm"] = 3.0;
  EXPECT_EQ(refused(closed).paths.front(), "/closed");
  far["tips"] = {{"name", "tips.csv"}, {"text", "AL,-13,-4,-240\nPM,13,-4,-24\n"}};
  EXPECT_TRUE(refused(far).paths.front().starts_with("/tips"));
}

TEST_F(ImportsTest, EveryProblemIsTold) {
  const auto refused = [&](const ordered_json& request) {
    return refusal(post("/v1/valves:import", request));
  };
  EXPECT_EQ(refused(ordered_json::object()), (Refused{422, {"/leaflets", "/chordae"}}));
  ordered_json wrong = cone_request();
  wrong["leaflets"][0]["text"] = "f 1 2 3";
  wrong["annulus"]["text"] = "x;y;z";
  wrong["chordae"]["text"] = "id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z\n1,AL,a,0,0,0,0,0\n";
  const Refused parts = refused(wrong);
  EXPECT_EQ(parts.status, 422);
  for (const char* part : {"/leaflets/0", "/annulus", "/chordae"})
    EXPECT_TRUE(std::any_of(parts.paths.begin(), parts.paths.end(), [&](const std::string& path) {
      return path.starts_with(part);
    })) << part;

  wrong = cone_request();
  wrong["slicerheart"] = ordered_json::array();
  EXPECT_EQ(refused(wrong), (Refused{422, {"/leaflets", "/annulus", "/chordae"}}));
  wrong = cone_request();
  wrong["leaflets"][0] = {{"name", "a.stl"}};
  wrong["annulus"] = {{"name", "a.csv"}, {"base64", "not base64"}};
  wrong["triangles"] = 99;
  wrong["slack"] = 2.0;
  EXPECT_EQ(refused(wrong), (Refused{422, {"/leaflets/0", "/annulus", "/triangles", "/slack"}}));
}

TEST_F(ImportsTest, AValveThatIsTooLargeIsRefused) {
  limits_.vertices = 100;
  EXPECT_EQ(refusal(post("/v1/valves:import", cone_request())), (Refused{422, {"/vertices_mm"}}));
}

TEST(Base64, ComesBackAsItWas) {
  for (const std::string& bytes : {std::string(), std::string("a"), std::string("ab"),
                                   std::string("abc"), std::string("\0\xff\n", 3)})
    EXPECT_EQ(decoded_base64(base64(bytes)), bytes);
  for (const char* text : {"a", "====", "ab==c", "a=bc", "ab\n=", "\xc3\xa4=="})
    EXPECT_EQ(decoded_base64(text), std::nullopt) << text;
}

}  // namespace
}  // namespace coapt
