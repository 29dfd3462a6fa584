// Valves out of the files of segmentation tools.
#include "server/endpoints/imports.h"

#include "io/exchange/slicerheart.h"
#include "server/jobs/import_job.h"
#include "tests/io/mesh/cone_scene.h"
#include "tests/server/endpoints/import_scene.h"

namespace coapt {
namespace {

class ImportsTest : public ServiceTest {};

TEST_F(ImportsTest, FilesBecomeAValveThatIsStored) {
  Json request = cone_request();
  request["name"] = "a cone";
  request["provenance"] = {"made up"};
  const Answer answer = post("/v1/valves:import", request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["name"], "a cone");
  EXPECT_EQ(valve["provenance"][0], "made up");
  EXPECT_EQ(decision_about(json_of(answer)["decisions"], "units"),
            (Json{{"subject", "units"},
                  {"value", "mm"},
                  {"reason", "by the annulus's circumference"},
                  {"look", false},
                  {"confidence", 1.0}}));
  EXPECT_EQ(valve["faces"].size(), json_of(answer)["triangles"]);
  EXPECT_EQ(post("/v1/valves:import", request).status, 200);
}

TEST_F(ImportsTest, BinaryFilesComeInBase64) {
  const Answer answer = post("/v1/valves:import", cone_request(true));
  EXPECT_EQ(answer.status, 201) << json_of(answer);
}

TEST_F(ImportsTest, VoxelsBesideTheirHeaderAreJoinedToIt) {
  const std::string header =
      "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n"
      "ElementType = MET_UCHAR\nElementDataFile = v.raw\n";
  Json request = {{"labels", {{"name", "map.mhd"}, {"text", header}}},
                  {"voxels", {{"name", "v.raw"}, {"text", "\1\2\1\2\1\2\1\2"}}},
                  {"chordae_seed", 1}};
  const Answer answer = post("/v1/valves:import", request);
  EXPECT_EQ(answer.status, 422);
  EXPECT_EQ(refusal(answer).paths.front(), "/labels");
  EXPECT_NE(content_bytes(answer).find("span 4.21 mm"), std::string::npos)
      << "both labels were found";
  request.erase("voxels");
  EXPECT_EQ(refusal(post("/v1/valves:import", request)).paths.front(), "/labels/ElementDataFile");
  request["labels"]["text"] = "ObjectType = Image\nElementDataFile = LOCAL\n";
  request["voxels"] = {{"name", "v.raw"}, {"text", ""}};
  EXPECT_EQ(refusal(post("/v1/valves:import", request)).paths.front(), "/voxels");
  request.erase("labels");
  EXPECT_EQ(refusal(post("/v1/valves:import", request)).paths.front(), "/voxels");
}

TEST_F(ImportsTest, AFolderOfSlicerHeartIsAListOfFiles) {
  const Expected<std::vector<NamedFile>> folder =
      write_slicerheart(close_and_measure(small_valve(), {.motion = true}), {.open = true});
  ASSERT_TRUE(folder);
  Json files = Json::array();
  for (const NamedFile& file : *folder)
    files.push_back({{"name", file.name}, {"text", file.bytes}});
  const Answer answer = post("/v1/valves:import", {{"slicerheart", files}, {"triangles", 150}});
  EXPECT_EQ(answer.status, 201) << json_of(answer);
  files = {files.front()};
  const Answer refused = post("/v1/valves:import", {{"slicerheart", files}});
  EXPECT_EQ(refusal(refused).status, 422);
  EXPECT_EQ(refusal(refused).paths.front(), "/slicerheart");
}

TEST_F(ImportsTest, OptionsThatChangeNothingAreSaid) {
  Json request = cone_request();
  request["hidden_mm"] = 5;
  const Answer answer = post("/v1/valves:import", request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json said = decision_about(json_of(answer)["decisions"], "options");
  EXPECT_EQ(said["value"], "hidden height not used");
  EXPECT_EQ(said["look"], true);
}

TEST_F(ImportsTest, ThicknessAndObservationsAreOfTheValve) {
  Json request = cone_request();
  request["thickness_mm"] = 1.4;
  request["observed"] = {{"leak_mm2", {{"value", 30.0}, {"sd", 5.0}}}};
  const Answer answer = post("/v1/valves:import", request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["tissue"]["thickness_mm"], 1.4);
  EXPECT_EQ(valve["observed"]["leak_mm2"]["value"], 30.0);
  request["thickness_mm"] = 11.0;
  EXPECT_EQ(refusal(post("/v1/valves:import", request)), (Refused{422, {"/thickness_mm"}}));
  request["thickness_measured"] = true;
  EXPECT_EQ(refusal(post("/v1/valves:import", request)), (Refused{422, {"/thickness_measured"}}));
  request.erase("thickness_mm");
  EXPECT_EQ(refusal(post("/v1/valves:import", request)), (Refused{422, {"/thickness_measured"}}))
      << "these are sheets";
}

TEST_F(ImportsTest, ChordaeThatWereNotSeenAreDrawn) {
  const Answer answer = post("/v1/valves:import", unseen_request());
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json valve = json_of(get("/v1/valves/" + json_of(answer)["id"].get<std::string>()));
  EXPECT_EQ(valve["drawn_chordae"], (Json{{"seed", 1}, {"tips_given", false}}));
  EXPECT_EQ(json_of(answer)["decisions"].back()["subject"], "chordae");
  Json seen = unseen_request();
  seen["tips"] = {{"name", "tips.csv"}, {"text", "AL,-13,-4,-24\nPM,13,-4,-24\n"}};
  const Answer with_tips = post("/v1/valves:import", seen);
  ASSERT_EQ(with_tips.status, 201) << json_of(with_tips);
  EXPECT_EQ(json_of(with_tips)["decisions"].back()["reason"], "papillary tips as given");
}

TEST_F(ImportsTest, WhatGoesWithDrawnChordaeOnlyIsRefusedWithout) {
  const auto refused = [&](const Json& request) {
    return refusal(post("/v1/valves:import", request));
  };
  Json both = cone_request(), tips = cone_request(), closed = cone_request(),
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
  const auto refused = [&](const Json& request) {
    return refusal(post("/v1/valves:import", request));
  };
  EXPECT_EQ(refused(Json::object()), (Refused{422, {"/leaflets", "/chordae"}}));
  Json wrong = cone_request();
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
  wrong["slicerheart"] = Json::array();
  EXPECT_EQ(refused(wrong), (Refused{422, {"/leaflets", "/annulus", "/chordae"}}));
  wrong = cone_request();
  wrong["leaflets"][0] = {{"name", "a.stl"}};
  wrong["annulus"] = {{"name", "a.csv"}, {"base64", "not base64"}};
  wrong["triangles"] = 99;
  wrong["slack"] = 2.0;
  EXPECT_EQ(refused(wrong), (Refused{422, {"/leaflets/0", "/annulus", "/triangles", "/slack"}}));
}

const std::vector<std::string> kMakers = {"/v1/valves:import", "/v1/imports"};

TEST_F(ImportsTest, AValveThatIsTooLargeIsRefusedBeforeItIsMade) {
  Json request = cone_request();
  limits_.vertices = 190;  // of 300 triangles: 38 stations, five to each
  for (const std::string& path : kMakers) EXPECT_LT(post(path, request).status, 300) << path;
  limits_.vertices = 189;
  request["leaflets"][0]["text"] = "f 1 2 3";
  for (const std::string& path : kMakers)
    EXPECT_EQ(refusal(post(path, request)), (Refused{422, {"/triangles"}})) << "files are not read";
  limits_.vertices = 5000;
  limits_.chordae = 1;
  for (const std::string& path : kMakers)
    EXPECT_EQ(refusal(post(path, cone_request())), (Refused{422, {"/chordae"}})) << path;
}

TEST_F(ImportsTest, ChordaeThatTakeTooManyStepsToDrawAreRefused) {
  limits_.vertex_steps = 1000.0;
  for (const std::string& path : kMakers) {
    const Answer answer = post(path, unseen_request());
    EXPECT_EQ(answer.status, 422) << path;
    EXPECT_NE(content_bytes(answer).find("more than 1000 steps times vertices"), std::string::npos);
  }
}

TEST_F(ImportsTest, AnImportOutOfTimeIsRefused) {
  limits_.request_seconds = 1e-9;
  for (const std::string& path : kMakers)
    for (const Json& request : {cone_request(), unseen_request()}) {
      const Answer answer = post(path, request);
      EXPECT_EQ(answer.status, 503) << path;
      EXPECT_NE(content_bytes(answer).find("coapt valve import"), std::string::npos) << path;
    }
  Json files = Json::array();
  files.push_back(cone_request()["annulus"]);
  EXPECT_EQ(post("/v1/imports:preview", {{"files", files}}).status, 503);
  EXPECT_TRUE(json_of(get("/v1/valves"))["valves"].empty());
  EXPECT_TRUE(json_of(get("/v1/jobs"))["jobs"].empty());
}

TEST_F(ImportsTest, AnImportEndsWithItsClient) {
  limits_.vertex_steps = 1e12;
  Json body = unseen_request();
  body["triangles"] = 9000;  // takes half a minute
  Request request;
  request.body = body.dump();
  request.abandoned = [] { return true; };
  EXPECT_EQ(ImportValve({store(), {limits_}, compute()})(request).status, 503);
}

TEST_F(ImportsTest, WithoutATurnTheyAre503) {
  const Compute::Turn other(compute());
  for (const std::string& path : kMakers) EXPECT_EQ(post(path, cone_request()).status, 503) << path;
  EXPECT_EQ(post("/v1/imports:preview", {{"files", Json::array()}}).status, 503);
}

TEST_F(ImportsTest, LandmarksThatWereSeenAreTaken) {
  Json request = cone_request();
  request["landmarks"] = {{"saddle_peak", {0.0, kTop_mm, 0.0}},
                          {"mid_posterior", {3.0, -17.7, 0.0}}};
  const Answer answer = post("/v1/valves:import", request);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Json decisions = json_of(answer)["decisions"];
  EXPECT_TRUE(std::any_of(decisions.begin(), decisions.end(), [](const Json& of) {
    return of["value"] == "saddle peak, mid-posterior as given";
  }));
  request["landmarks"] = {{"saddle_peak", {0.0, 40.0, 0.0}}};
  EXPECT_EQ(refusal(post("/v1/valves:import", request)),
            (Refused{422, {"/landmarks/saddle_peak"}}));
  request["landmarks"] = {{"apex", {0.0, 40.0}}};
  EXPECT_EQ(refusal(post("/v1/valves:import", request)), (Refused{422, {"/landmarks/apex"}}));
}

TEST_F(ImportsTest, FilesAreLookedAtOneByOne) {
  Json request = cone_request(), files = Json::array();
  files.push_back(request["leaflets"][0]);
  files.push_back(request["annulus"]);
  files.push_back(request["chordae"]);
  files.push_back({{"name", "tips.csv"}, {"text", "AL,-13,-4,-24\nPM,13,-4,-24\n"}});
  files.push_back({{"name", "a.obj"}, {"text", "f 1 2 3"}});
  const Answer answer = post("/v1/imports:preview", {{"files", files}});
  ASSERT_EQ(answer.status, 200);
  const Json seen = json_of(answer)["files"];
  const std::vector<std::string> contents = {"surface", "curve", "chordae", "tips", "unknown"};
  ASSERT_EQ(seen.size(), contents.size());
  for (std::size_t i = 0; i < contents.size(); ++i) EXPECT_EQ(seen[i]["content"], contents[i]);
  const ImportSource source = cone_source();
  EXPECT_EQ(seen[0]["faces"].size(), 3 * static_cast<std::size_t>(source.leaflets[0].faces.rows()));
  EXPECT_EQ(seen[1]["points"].size(), 3 * static_cast<std::size_t>(source.annulus_mm.rows()));
  EXPECT_EQ(seen[2]["points"].size(), 6 * source.chordae.size());
  EXPECT_EQ(seen[3]["labels"], (Json{"AL", "PM"}));
  EXPECT_TRUE(seen[0]["problems"].empty());
  EXPECT_FALSE(seen[4]["problems"].empty());
}

/// A surface of so many polygons of 997 triangles.
Json fans(int count) {
  std::string fan = "f 1", all = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 499; ++i) fan += " 2 3";
  for (int i = 0; i < count; ++i) all += fan + '\n';
  return {{"name", "fans.obj"}, {"text", std::move(all)}};
}

TEST_F(ImportsTest, WhatIsShownOfFilesIsBoundedAltogether) {
  const Json files = {fans(600), fans(600), fans(2)};
  const Json seen = json_of(post("/v1/imports:preview", {{"files", files}}))["files"];
  EXPECT_EQ(seen[0]["faces"].size(), 3u * 997u * 600u);
  EXPECT_EQ(seen[1]["content"], "surface");
  EXPECT_TRUE(seen[1]["faces"].empty());
  EXPECT_NE(seen[1]["problems"][0]["message"].get<std::string>().find("1,000,000 in total"),
            std::string::npos);
  EXPECT_EQ(seen[2]["faces"].size(), 3u * 997u * 2u) << "there is room for it";
}

TEST_F(ImportsTest, WhatIsShownOfFilesIsBounded) {
  Json files = Json::array();
  files.push_back(cone_request()["annulus"]);
  files.push_back(fans(1004));
  files.push_back(files[0]);
  const Json seen = json_of(post("/v1/imports:preview", {{"files", files}}))["files"];
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_EQ(seen[1]["content"], "unknown") << "it is not read to its end";
  EXPECT_TRUE(seen[1]["points"].empty());
  EXPECT_TRUE(seen[1]["faces"].empty());
  EXPECT_NE(seen[1]["problems"][0]["message"].get<std::string>().find("1000000 triangles accepted"),
            std::string::npos);
  EXPECT_FALSE(seen[0]["points"].empty());
  EXPECT_EQ(seen[2], seen[0]) << "there is room for it";
  Json many = Json::array();
  for (int i = 0; i < 101; ++i) many.push_back({{"name", "a.obj"}, {"text", ""}});
  EXPECT_EQ(refusal(post("/v1/imports:preview", {{"files", many}})), (Refused{422, {"/files"}}));
}

TEST_F(ImportsTest, WhatIsWrongWithAFitIsSaidAtOnce) {
  const auto refused = [&](const Json& fit) {
    Json request = cone_request();
    request["fit"] = fit;
    return refusal(post("/v1/imports", request));
  };
  EXPECT_EQ(refused(Json::object()), (Refused{422, {"/fit/surface"}}));
  const Json mesh = {{"name", "a.obj"}, {"text", "v 1 2"}};
  const Refused broken = refused({{"surface", mesh}});
  EXPECT_EQ(broken.status, 422);
  EXPECT_TRUE(broken.paths.front().starts_with("/fit/surface"));
  EXPECT_EQ(refused({{"surface", mesh}, {"known", {"all"}}, {"leak_mm2", -1}, {"side", "front"}}),
            (Refused{422, {"/fit/side", "/fit/leak_mm2", "/fit/known/0"}}));
  EXPECT_EQ(refusal(post("/v1/valves:import", {{"fit", {{"rounds", 1}}}})).paths.back(), "/fit");
}

const Fields kForm = {{"content-type", "multipart/form-data; boundary=x"}};

/// A request as a form, whose files have names.
std::string form_of(const Json& request) {
  std::string form;
  const auto part = [&form](const std::string& name, const std::string& content) {
    form += "--x\r\nContent-Disposition: form-data; name=" + name + "\r\n\r\n" + content + "\r\n";
  };
  for (const auto& [name, value] : request.items())
    for (const Json& one : value.is_array() ? value : Json::array({value}))
      if (one.is_object())
        part(name + "; filename=" + one["name"].get<std::string>(), one["text"]);
      else
        part(name, one.is_string() ? one.get<std::string>() : one.dump());
  return form + "--x--\r\n";
}

TEST_F(ImportsTest, AFormIsTheSameRequest) {
  Json request = unseen_request();
  request.erase("provenance");
  const Answer answer = ask("POST", "/v1/valves:import", form_of(request), kForm);
  ASSERT_EQ(answer.status, 201) << json_of(answer);
  const Answer again = post("/v1/valves:import", request);
  EXPECT_EQ(again.status, 200) << "it is there already";
  EXPECT_EQ(json_of(again)["id"], json_of(answer)["id"]);
  EXPECT_EQ(ask("POST", "/v1/imports", form_of(request), kForm).status, 202);
  const std::shared_ptr<RunningJob> job = board().take();
  const std::optional<JobEnd> end = ImportJob{board(), store(), {limits_}}(*job);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state, JobState::Succeeded);
  for (const char* path : {"/v1/valves:import", "/v1/imports", "/v1/imports:preview"})
    EXPECT_EQ(ask("POST", path, "--x", kForm).status, 400) << path;
}

TEST_F(ImportsTest, FilesAreReadApartToTheSameAnswers) {
  const std::unique_ptr<ReaderProcesses> processes = import_processes(limits_);
  const ImportReader here{limits_}, apart{limits_, processes.get()};
  Json wrong = cone_request();
  wrong["annulus"]["text"] = "x;y;z";
  const std::vector<std::pair<ImportStep, std::string>> asked = {
      {ImportStep::Valve, cone_request().dump()},
      {ImportStep::Valve, unseen_request().dump()},
      {ImportStep::Valve, wrong.dump()},
      {ImportStep::Valve, "{"},
      {ImportStep::Submission, fit_request().dump()},
      {ImportStep::Job, cone_request(true).dump()},
      {ImportStep::Job, fit_request().dump()},
      {ImportStep::Preview, Json{{"files", {cone_request()["annulus"]}}}.dump()},
      {ImportStep::Form, kForm.at("content-type") + '\n' + form_of({{"name", "a"}, {"slack", 1}})},
      {ImportStep::Form, kForm.at("content-type") + "\n--x"},
      {ImportStep::Form, ""}};
  for (const auto& [step, body] : asked) {
    const std::optional<Answer> one = here(step, body, {}, 60.0),
                                other = apart(step, body, {}, 60.0);
    ASSERT_TRUE(one && other);
    EXPECT_EQ(one->status, other->status) << body.substr(0, 100);
    using Unordered = nlohmann::json;  // members have no order for readers
    EXPECT_TRUE(Unordered::parse(content_bytes(*one)) == Unordered::parse(content_bytes(*other)))
        << body.substr(0, 100);
    EXPECT_EQ(content_type(*other),
              one->status < 400 ? "application/json" : "application/problem+json");
  }
  EXPECT_FALSE(
      apart(ImportStep::Valve, cone_request().dump(), {.cancelled = [] { return true; }}, 60.0));
}

TEST_F(ImportsTest, ASurfaceIsReadApartToTheSameMesh) {
  const std::unique_ptr<ReaderProcesses> processes = import_processes(limits_);
  const ImportReader here{limits_}, apart{limits_, processes.get()};
  const NamedFile file{"two\n.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n"};
  const Expected<LeafletMesh> one = read_surface(here, file, {}, {}),
                              other = read_surface(apart, file, {}, {});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->vertices_mm, other->vertices_mm);
  EXPECT_EQ(one->faces, other->faces);
  EXPECT_EQ(one->leaflets, other->leaflets);
  const Expected<LeafletMesh> none = read_surface(apart, {"a.obj", "v 1 2"}, {}, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.errors()[0].path, "/vertices_mm/0");
}

TEST_F(ImportsTest, ASurfaceToFitHasNoMoreThanTheServiceTakes) {
  Json request = fit_request();
  ASSERT_EQ(post("/v1/imports", request).status, 202);
  std::string fans = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", fan = "f 1";
  for (int i = 0; i < 499; ++i) fan += " 2 3";  // 997 triangles
  const int most = 40 * limits_.vertices;
  for (int i = 0; i <= most / 997; ++i) fans += fan + '\n';
  request["fit"]["surface"] = {{"name", "fans.obj"}, {"text", fans}};
  const Answer answer = post("/v1/imports", request);
  EXPECT_EQ(refusal(answer), (Refused{422, {"/fit/surface/faces"}}));
  EXPECT_NE(content_bytes(answer).find(std::to_string(most) + " triangles accepted"),
            std::string::npos);
}

TEST_F(ImportsTest, AnAnswerOfAReaderThatIsNoDocumentIsAnErrorOfItsOwn) {
  const ReaderProcesses confused([](std::string_view) -> std::string { return "200{"; },
                                 limits_.import_bytes);
  const ImportReader reader{limits_, &confused};
  Request request;
  request.body = cone_request().dump();
  const Answer answer = ImportValve({store(), reader, compute()})(request);
  EXPECT_EQ(answer.status, 422);
  EXPECT_NE(content_bytes(answer).find("the answer of the reading process"), std::string::npos);
  const Expected<LeafletMesh> surface = read_surface(reader, {"a.obj", ""}, {}, {});
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.errors()[0].code, ErrorCode::InputOutput);
}

TEST_F(ImportsTest, AReaderThatDiesIsTheProblemOfItsRequest) {
  // As a fault of a reader of files would end it.
  const ReaderProcesses dying([](std::string_view) -> std::string { std::abort(); },
                              limits_.import_bytes);
  Request request;
  request.body = cone_request().dump();
  const ImportReader reader{limits_, &dying};
  const Answer answer = ImportValve({store(), reader, compute()})(request);
  EXPECT_EQ(answer.status, 422);
  EXPECT_EQ(json_of(answer)["problems"][0]["code"], "input_output");
  EXPECT_NE(content_bytes(answer).find("coapt valve import"), std::string::npos);
  ASSERT_EQ(post("/v1/imports", cone_request()).status, 202);
  const std::shared_ptr<RunningJob> job = board().take();
  const std::optional<JobEnd> end = ImportJob{board(), store(), reader}(*job);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state, JobState::Failed);
}

}  // namespace
}  // namespace coapt
