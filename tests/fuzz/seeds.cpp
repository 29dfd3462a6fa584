// Writes what the fuzzers start from: fuzz_seeds FOLDER.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/json/plan_json.h"
#include "io/json/valve_json.h"
#include "tests/fuzz/asked_work.h"
#include "tests/fuzz/endpoint_choice.h"
#include "tests/scenes/small_valve.h"

namespace {

using namespace coapt;

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

RepairPlan one_of_each_step() {
  const LeafletPoint point = {Leaflet::Posterior, 0.5, 1.0};
  return {{Annuloplasty{OwnRing{2}}, Annuloplasty{CatalogueRing{"generic-classic", 30.0}},
           Neochorda{"AL1", point, 18.5}, ChordalLengthChange{"a", -1.25}, ChordalExcision{"b"},
           ChordalTransfer{"c", point},
           PapillaryApproximation{Side::Anterolateral, Anchor::SaddlePeak, 0.25, 24.0},
           PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.9, 25.0},
           EdgeToEdge{EdgeDevice::Clip, 0.4, 6.0},
           LeafletResection{.leaflet = Leaflet::Anterior, .width_mm = 8.0},
           LeafletResection{.shape = ResectionShape::Quadrangular, .sliding = false}}};
}

constexpr std::string_view kReads[] = {"/v1/jobs?page_size=2&page_token=9&state=QUEUED",
                                       "/v1/jobs/job",
                                       "/v1/jobs/wait/result",
                                       "/v1/jobs/job/events?last_event_id=1",
                                       "/v1/jobs/job/result",
                                       "/v1/jobs/job/plans?page_size=1",
                                       "/v1/jobs/job/plans/1",
                                       "/v1/jobs/job/plans/1/mesh?format=ply",
                                       "/v1/jobs/job/plans/1/picture",
                                       "/v1/jobs/job/plans/1/report",
                                       "/v1/jobs/job/report",
                                       "/v1/jobs/job/files",
                                       "/v1/jobs/job/files/report.html",
                                       "/v1/jobs/job/evaluations.csv",
                                       "/v1/valves?page_size=1&page_token=0123",
                                       "/v1/valves/valve",
                                       "/v1/kept-plans?valve=valve&page_size=1",
                                       "/v1/kept-plans/kept",
                                       "/v1/presets",
                                       "/v1/presets/human-normal",
                                       "/v1/rings",
                                       "/healthz/live",
                                       "/metrics",
                                       "/version"};

/// The small valve's leaflets as files of a segmentation tool.
Json an_import() {
  const Valve& valve = small_valve();
  std::ostringstream mesh, annulus;
  const auto row = [](std::ostream& to, const Vec3& point, char between) {
    to << point.x() << between << point.y() << between << point.z();
  };
  for (Index v = 0; v < valve.rest_mm.rows(); ++v) {
    mesh << "v ";
    row(mesh, valve.rest_mm.row(v), ' ');
    mesh << '\n';
  }
  for (const auto face : valve.faces.rowwise())
    mesh << "f " << face[0] + 1 << ' ' << face[1] + 1 << ' ' << face[2] + 1 << '\n';
  for (const int vertex : valve.annulus) {
    row(annulus, valve.rest_mm.row(vertex), ',');
    annulus << '\n';
  }
  const auto file = [](const char* name, const std::ostringstream& text) {
    return Json{{"name", name}, {"text", text.str()}};
  };
  return {{"leaflets", {file("skirt.obj", mesh)}},
          {"annulus", file("annulus.csv", annulus)},
          {"chordae_seed", 1},
          {"triangles", 100}};
}

/// The same as a form.
std::string form_of(const Json& import) {
  std::string form;
  const auto part = [&form](const std::string& name, const std::string& content) {
    form += "--" + std::string(kFormBoundary) + "\r\nContent-Disposition: form-data; name=" + name +
            "\r\n\r\n" + content + "\r\n";
  };
  const auto file = [&part](const std::string& name, const Json& of) {
    part(name + "; filename=" + of["name"].get<std::string>(), of["text"]);
  };
  file("leaflets", import["leaflets"][0]);
  file("annulus", import["annulus"]);
  part("chordae_seed", "1");
  part("triangles", "100");
  return form + "--" + std::string(kFormBoundary) + "--\r\n";
}

/// Requests to each endpoint: small valves inside, jobs and valves that fuzz_endpoints has in its store.
void write_requests(const std::filesystem::path& folder) {
  const Json valve = Json::parse(write_valve(small_valve()));
  const Json plan = to_json(RepairPlan{{Annuloplasty{OwnRing{1}}}});
  const Json search = {
      {"evaluations", 10},
      {"seed", 1},
      {"plans", 2},
      {"region_points", 5},
      {"evidence", false},
      {"rules", {{"fixed", plan}, {"forbidden", {"neochorda", "annuloplasty:own"}}}},
      {"weights", {{"movement", 0.5}}}};
  const Json study = {{"name", "approximation"},
                      {"protocols", {"closed"}},
                      {"displacement_step_mm", 6},
                      {"region_points", 17},
                      {"scan_sites", 0}};
  const Json import = an_import();
  Json fitted = import;
  fitted["fit"] = {{"surface", import["leaflets"][0]}, {"rounds", 1}};
  const std::array<Json, kBodyPaths.size()> bodies = {
      valve,
      valve,
      {{"valve", valve}, {"plan", plan}},
      {{"valve", kStoredValve}, {"plan", plan}, {"frames", 2}},
      {{"valve", kStoredValve}, {"plan", plan}, {"format", "glb"}, {"open", false}},
      {{"valve", kStoredValve}, {"plan", plan}},
      {{"valve", kStoredValve}, {"plans", {plan, plan}}, {"region_points", 1}},
      {{"valve", kStoredValve}, {"plans", {plan}}, {"region_points", 2}},
      {{"valve", valve}, {"search", search}},
      {{"valve", kStoredValve}, {"study", study}},
      Json::object(),
      {{"valve", kStoredValve}, {"plan", plan}},
      {{"name", "A plan"}, {"valve", kStoredValve}, {"plan", plan}},
      {{"name", "Another name"}},
      import,
      fitted,
      {{"files", {import["leaflets"][0], import["annulus"]}}},
      {{"valve", kStoredValve}},
      {{"valve", kStoredValve}},
      {{"cases", Json::array()}, {"answers", Json::array()}},
      {{"valve", kStoredValve}, {"draws", 2}},
      {{"valve", kStoredValve},
       {"observed", {{"leak_mm2", {{"value", 50}, {"sd", 10}, {"source", "planimetry"}}}}}},
      {{"closed", {{"valve", kStoredValve}}}, {"reference", {{"file", import["leaflets"][0]}}}},
      {{"valve", kStoredValve}, {"formats", {"vtk", "slicerheart"}}},
      {{"valve", kStoredValve}, {"surface", {{"file", import["leaflets"][0]}}}, {"rounds", 1}},
      {{"valve", kStoredValve}, {"draws", 1}}};
  char choice = 'a';
  for (const Json& body : bodies) {
    write(folder / std::string(1, choice), choice + body.dump());
    ++choice;
  }
  write(folder / "form", choice + form_of(import));
  ++choice;
  int number = 0;
  for (const std::string_view path : kReads)
    write(folder / ("get-" + std::to_string(number++)), choice + std::string(path));
  for (const char* path : {"/v1/jobs/wait", "/v1/valves/valve"})
    write(folder / ("delete-" + std::to_string(number++)),
          static_cast<char>(choice + 1) + std::string(path));
}

void write_answers(const std::filesystem::path& folder) {
  const std::array<Work, kAskedKinds> works = asked_works();
  for (std::size_t kind = 0; kind < works.size(); ++kind)
    write(folder / std::to_string(kind), static_cast<char>(kind) + works[kind].compute(0, 1, 1));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  write(folder / "valve" / "small.json", write_valve(small_valve()));
  write(folder / "plan" / "each_step.json", to_json(one_of_each_step()).dump(1));
  for (const RepairStep& step : one_of_each_step().steps) {
    write(folder / "plan" / (std::to_string(step.index()) + ".json"),
          to_json(RepairPlan{{step}}).dump());
  }
  write_requests(folder / "endpoints");
  write_answers(folder / "answers");
}
