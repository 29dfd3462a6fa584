#include "server/endpoints/valves.h"

#include "core/presets/presets.h"
#include "tests/server/endpoints/service_scene.h"

namespace coapt {
namespace {

class ValvesTest : public ServiceTest {};

TEST_F(ValvesTest, AValveIsStoredOnceUnderTheHashOfItsContent) {
  const Answer first = post("/v1/valves", small_document());
  EXPECT_EQ(first.status, 201);
  const std::string id = json_of(first)["id"];
  EXPECT_EQ(header_of(first, "Location"), "/v1/valves/" + id);
  EXPECT_EQ(json_of(first)["vertices"], small_valve().rest_mm.rows());
  EXPECT_EQ(json_of(first)["triangles"], small_valve().faces.rows());
  EXPECT_EQ(json_of(first)["chordae"], small_valve().chordae.size());
  const Answer again = post("/v1/valves", small_document());
  EXPECT_EQ(again.status, 200);
  EXPECT_EQ(json_of(again)["id"], id);
  EXPECT_EQ(json_of(get("/v1/valves/" + id)), small_document());
}

TEST_F(ValvesTest, AWrongValveIsRefusedWithItsProblemsAndNotStored) {
  Json wrong = small_document();
  wrong["pressure_kpa"] = -1;
  wrong["surprise"] = 1;
  EXPECT_EQ(refusal(post("/v1/valves", wrong)), (Refused{422, {"/surprise", "/pressure_kpa"}}));
  EXPECT_EQ(ask("POST", "/v1/valves", "{").status, 400);
  limits_.vertices = 10;
  limits_.chordae = 1;
  EXPECT_EQ(refusal(post("/v1/valves", small_document())),
            (Refused{422, {"/vertices_mm", "/chordae"}}));
}

TEST_F(ValvesTest, ValidationListsProblemsAndStoresNothing) {
  const Answer good = post("/v1/valves:validate", small_document());
  EXPECT_EQ(good.status, 200);
  EXPECT_EQ(json_of(good)["valid"], true);
  EXPECT_TRUE(json_of(good)["problems"].empty());
  Json wrong = small_document();
  wrong["pressure_kpa"] = -1;
  const Answer bad = post("/v1/valves:validate", wrong);
  EXPECT_EQ(bad.status, 200);
  EXPECT_EQ(json_of(bad)["valid"], false);
  EXPECT_EQ(refusal(bad).paths, std::vector<std::string>{"/pressure_kpa"});
  EXPECT_EQ(ask("POST", "/v1/valves:validate", "").status, 400);
  EXPECT_EQ(post("/v1/valves", small_document()).status, 201);
}

TEST_F(ValvesTest, ABodyWaitsForItsTurnToBeRead) {
  const Compute::Turn other(parsing());
  EXPECT_EQ(post("/v1/valves", small_document()).status, 503);
  EXPECT_EQ(post("/v1/valves:validate", small_document()).status, 503);
}

TEST_F(ValvesTest, StoredValvesAreListedNewestFirst) {
  EXPECT_TRUE(json_of(get("/v1/valves"))["valves"].empty());
  const std::string id = json_of(post("/v1/valves", small_document()))["id"];
  Json other = small_document();
  other["name"] = "other";
  post("/v1/valves", other);
  const auto first = json_of(get("/v1/valves?page_size=1"));
  ASSERT_EQ(first["valves"].size(), 1u);
  EXPECT_EQ(first["valves"][0]["name"], "other");
  const std::string token = first["next_page_token"];
  const auto rest = json_of(get("/v1/valves?page_token=" + token));
  EXPECT_EQ(rest["valves"], Json::array({{{"valve", id},
                                          {"name", small_document()["name"]},
                                          {"vertices", small_valve().rest_mm.rows()},
                                          {"triangles", small_valve().faces.rows()}}}));
  EXPECT_EQ(rest["next_page_token"], nullptr);
  EXPECT_EQ(refusal(get("/v1/valves?page_size=101&page_token=1&x=1")),
            (Refused{422, {"?x", "?page_size", "?page_token"}}));
}

TEST_F(ValvesTest, PresetsAreListedAndGot) {
  const auto presets = json_of(get("/v1/presets"))["presets"];
  ASSERT_EQ(presets.size(), preset_names().size());
  EXPECT_EQ(presets[0]["name"], preset_names()[0]);
  for (const auto& listed : presets)
    for (const char* words : {"group", "title", "about"})
      EXPECT_FALSE(listed[words].get<std::string>().empty()) << listed["name"] << words;
  const Answer preset = get(presets[0]["valve"]);
  EXPECT_EQ(preset.status, 200);
  EXPECT_EQ(json_of(preset)["schema"], "coapt.valve/1");
  EXPECT_EQ(get("/v1/presets/nobody").status, 404);
  EXPECT_EQ(get("/v1/valves/nobody").status, 404);
}

TEST_F(ValvesTest, AStoredValveIsRemovedAndForgotten) {
  const std::string id = stored_valve();
  EXPECT_EQ(post("/v1/closures", {{"valve", id}}).status, 200);
  EXPECT_EQ(remove("/v1/valves/" + id).status, 204);
  EXPECT_EQ(remove("/v1/valves/" + id).status, 404);
  EXPECT_EQ(get("/v1/valves/" + id).status, 404);
  EXPECT_EQ(refusal(post("/v1/closures", {{"valve", id}})), (Refused{422, {"/valve"}}));
}

TEST_F(ValvesTest, AValveThatAJobRefersToStays) {
  queued_job("j");
  EXPECT_EQ(remove("/v1/valves/valve").status, 409);
  EXPECT_EQ(get("/v1/valves/valve").status, 200);
}

TEST_F(ValvesTest, RingsHaveTheirShapesAndSizes) {
  const auto rings = json_of(get("/v1/rings"));
  ASSERT_EQ(rings["rings"].size(), 3u);
  EXPECT_EQ(rings["rings"][0]["name"], "generic-classic");
  EXPECT_GT(rings["rings"][0]["ap_over_transverse"], 0.0);
  EXPECT_LT(rings["sizes_mm"]["min"], rings["sizes_mm"]["max"]);
}

}  // namespace
}  // namespace coapt
