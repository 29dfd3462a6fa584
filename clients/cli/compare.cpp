#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/closing_option.h"
#include "clients/cli/commands.h"
#include "clients/cli/material_option.h"
#include "clients/cli/plan_option.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/exchange/import_files.h"
#include "io/json/json_reader.h"
#include "io/mesh/write_vtk.h"
#include "io/picture/distance_map.h"
#include "io/picture/text.h"
#include "operations/surface_file.h"

namespace coapt {
namespace {

/// What is done to the first shape before it is closed.
struct ShapeRepair {
  PlanOption plan;
  MaterialOption material;
};

struct CompareArguments {
  std::string closed, reference, picture, mesh;
  std::string alignment = "auto";
  ShapeFileOptions files;
  ShapeRepair repair;
  ClosingOption closing;
  std::optional<double> contact_mm;
  ServerOption server;
  bool json = false;
};

/// A mesh by the end of its name, a scene, or a valve, which is closed. Errors: neither.
Expected<bool> is_surface_file(const std::string& argument) {
  std::error_code ignored;
  if (!std::filesystem::exists(argument, ignored)) return is_shape_format(format_of(argument));
  const std::string format = format_of(argument);
  if (format == "json") {
    const Expected<std::string> text = read_input(argument);
    if (!text) return text.errors();
    return is_scene_text(*text);
  }
  if (is_shape_format(format)) return true;
  return Error{ErrorCode::Unsupported, "",
               "must end in one of " + shape_format_names() +
                   ", or be a valve or a scene (.json), or the name of a preset"};
}

AskedRequest shape_to_send(const std::string& argument, const ShapeRepair& repair,
                           const ShapeFileOptions& options, const std::optional<Service>& service) {
  const Expected<bool> is_surface = is_surface_file(argument);
  if (!is_surface) return {.failed = report_errors(argument, is_surface.errors())};
  if (!*is_surface) {
    AskedRequest asked = asked_repair(argument, repair.plan, service);
    if (!asked.failed && is_given(repair.material))
      asked.request["material"] = material_json(repair.material);
    return asked;
  }
  if (is_given(repair.plan) || is_given(repair.material))
    return {.failed = report_errors(
                argument, {Error{ErrorCode::Unsupported, "",
                                 "is a surface; a repair, pressure and tissue (--plan, --ring, "
                                 "--pressure, ...) need a valve, which is closed first"}})};
  Expected<Json> given = file_to_send(argument);
  if (!given) return {.failed = report_errors(argument, given.errors())};
  AskedRequest asked{0, {{"file", *std::move(given)}}, {{"/file", argument}}};
  if (!options.leaflets.empty()) asked.request["leaflet_array"] = options.leaflets;
  if (!options.displacement.empty()) asked.request["displacement_array"] = options.displacement;
  return asked;
}

std::ostream& line(std::ostream& out, const char* label) {
  return out << "  " << std::left << std::setw(11) << label << std::right;
}

std::string in_mm(const Json& value) { return fixed(value.get<double>(), 3) + " mm"; }

void print_shape(std::ostream& out, const char* label, const Json& shape) {
  line(out, label) << shape["nodes"] << " nodes, " << fixed(shape["area_mm2"], 1) << " mm2 (";
  const char* comma = "";
  for (const Json& leaflet : shape["leaflets"]) {
    out << comma << printable(leaflet["name"].get<std::string>()) << ' '
        << fixed(leaflet["area_mm2"], 1);
    comma = ", ";
  }
  out << "), " << percent(shape["contact_share"]) << " of nodes in contact\n";
}

void print_comparison(std::ostream& out, const Json& json) {
  const bool nodes = json["pairing"] == "node_to_node";
  const Json& alignment = json["alignment"];
  out << printable(json["closed"]["source"].get<std::string>()) << " against "
      << printable(json["reference"]["source"].get<std::string>())
      << (nodes ? ", node to node" : ", node to surface");
  if (alignment["rigid"])
    out << ", after a rigid motion of " << fixed(alignment["shift_mm"], 3) << " mm and "
        << fixed(alignment["rotation_deg"], 2) << " degrees";
  out << '\n';
  line(out, "distance") << "rms " << in_mm(json["rms_mm"]) << ", p95 " << in_mm(json["p95_mm"])
                        << ", max " << in_mm(json["max_mm"]) << ", mean with sign "
                        << fixed(json["mean_signed_mm"], 3) << " mm\n";
  if (nodes) {
    if (!alignment["rigid"])
      line(out, "") << "after a rigid alignment the rms distance would be "
                    << in_mm(json["rms_after_rigid_mm"]) << " (--align rigid)\n";
  } else {
    line(out, "back") << "rms " << in_mm(json["back"]["rms_mm"]) << ", p95 "
                      << in_mm(json["back"]["p95_mm"]) << ", max " << in_mm(json["back"]["max_mm"])
                      << ", from the reference's nodes\n";
    line(out, "coverage") << percent(json["beyond_edge_share"])
                          << " of nodes have their closest point on the edge of the reference\n";
  }
  if (!alignment["settled"]) line(out, "") << "the alignment did not converge\n";
  print_shape(out, "closed", json["closed"]);
  print_shape(out, "reference", json["reference"]);
  line(out, "contact") << "within " << fixed(json["contact_distance_mm"], 2)
                       << " mm to another part of the surface\n";
}

/// Rows of three of a list that an operation answered.
template <class Matrix>
Matrix matrix_of(const Json& rows) {
  Matrix matrix(std::ssize(rows), 3);
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Index k = 0; k < 3; ++k)
      rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].get_to(matrix(i, k));
  return matrix;
}

/// "closed: UNRELIABLE: not converged", of either shape; empty where both closures are to be trusted.
std::string doubts_in(const Json& found) {
  std::string doubts;
  for (const char* name : {"closed", "reference"})
    if (found[name].contains("doubt"))
      doubts += (doubts.empty() ? "" : "; ") + std::string(name) + ": " +
                printable(found[name]["doubt"].get<std::string>());
  return doubts;
}

std::string map_vtk(const Json& found, const Json& nodes) {
  const auto as_numbers = [&](const char* name) {
    std::vector<double> numbers;
    for (const Json& value : nodes[name])
      numbers.push_back(value.is_boolean() ? (value.get<bool>() ? 1.0 : 0.0) : value.get<double>());
    return numbers;
  };
  const std::string doubts = doubts_in(found);
  VtkPolyData data{kVtkTitle + (doubts.empty() ? "" : "; " + doubts),
                   matrix_of<Points>(nodes["moved_mm"]),
                   {},
                   matrix_of<Faces>(nodes["faces"]),
                   {},
                   {},
                   {}};
  data.point_data = {{"signed_distance_mm", as_numbers("signed_mm"), false},
                     {"contact", as_numbers("contact"), true}};
  data.face_data = {{"leaflet", as_numbers("leaflets"), true}};
  return write_vtk(data);
}

std::string map_png(const Json& found, const Json& nodes) {
  const auto name_of = [&](const char* shape) {
    return std::filesystem::path(found[shape]["source"].get<std::string>()).filename().string();
  };
  return distance_map_png(
      {matrix_of<Points>(nodes["moved_mm"]), matrix_of<Faces>(nodes["faces"]),
       nodes["signed_mm"].get<std::vector<double>>(), round_range_mm(found["p95_mm"]),
       name_of("closed") + " against " + name_of("reference"),
       std::string(found["pairing"] == "node_to_node" ? "node to node" : "node to surface") +
           (found["alignment"]["rigid"] ? ", aligned" : "") + ": rms " + in_mm(found["rms_mm"]) +
           ", p95 " + in_mm(found["p95_mm"]) + ", max " + in_mm(found["max_mm"]) +
           "; research software, not a medical device",
       doubts_in(found)});
}

/// Says which closures are not to be trusted; whether there is none, and the alignment settled.
bool at_rest(const Json& found) {
  bool trusted = found["alignment"]["settled"];
  for (const char* name : {"closed", "reference"}) {
    const Json& shape = found[name];
    if (!shape.contains("doubt")) continue;
    std::cerr << "coapt: compare: " << printable(shape["source"].get<std::string>()) << ": "
              << shape["doubt"].get<std::string>() << '\n';
    trusted = false;
  }
  return trusted;
}

int write_maps(const CompareArguments& arguments, const Json& found, const Json& nodes) {
  if (!arguments.picture.empty())
    if (const int failed = write_output(arguments.picture, map_png(found, nodes))) return failed;
  return arguments.mesh.empty() ? exit_code::kOk
                                : write_output(arguments.mesh, map_vtk(found, nodes));
}

/// What is wrong with the request in the words of the command line.
int report_compare(const Errors& errors, const std::map<std::string, std::string>& sources) {
  constexpr std::string_view kMaterial = "/closed/material";
  Errors told = errors;
  for (Error& error : told)
    if (error.path.starts_with(kMaterial)) error.path.erase(0, kMaterial.size());
  return report_refusal("compare", told, sources,
                        {{"/accuracy_mm2", "--accuracy"}, {"/pressure_mmhg", "--pressure"}});
}

int run(const CompareArguments& arguments, const std::optional<Service>& service) {
  for (const std::string& output : {arguments.picture, arguments.mesh})
    if (const int failed = check_output(output)) return failed;
  Json request = {{"align", arguments.alignment}};
  add_closing(arguments.closing, request);
  std::map<std::string, std::string> sources;
  Context here{.limits = OperationLimits::unlimited(), .surface_of = read_surface_file};
  std::map<std::string, std::function<Expected<Valve>(const std::string&)>> valves;
  for (const auto& [name, argument] :
       {std::pair<std::string, std::string>("closed", arguments.closed),
        {"reference", arguments.reference}}) {
    const ShapeRepair repair = name == "closed" ? arguments.repair : ShapeRepair{};
    AskedRequest shape = shape_to_send(argument, repair, arguments.files, service);
    if (shape.failed) return shape.failed;
    shape.request["source"] = argument;
    request[name] = std::move(shape.request);
    const std::string path = "/" + name;
    sources[path] = argument;
    for (const auto& [part, source] : shape.sources) sources[path + part] = source;
    if (shape.here.valve_named) valves[argument] = std::move(shape.here.valve_named);
  }
  if (arguments.contact_mm) request["contact_mm"] = *arguments.contact_mm;
  const bool maps = !arguments.picture.empty() || !arguments.mesh.empty();
  if (maps) request["nodes"] = true;
  here.valve_named = [&](const std::string& name) { return valves.at(name)(name); };
  Expected<Json> found = ask_document(service, "compare", request, here);
  if (!found) return report_compare(found.errors(), sources);
  const Json nodes = found->value("nodes", Json());
  found->erase("nodes");
  if (arguments.json)
    std::cout << json_text(*found, 2) << '\n';
  else
    print_comparison(std::cout, *found);
  const bool trusted = at_rest(*found);
  if (const int failed = write_maps(arguments, *found, nodes)) return failed;
  return trusted ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_compare(Command parent, int& status) {
  const auto arguments = std::make_shared<CompareArguments>();
  Command command =
      parent.add_command("compare", "Measure the distance from a closed shape to a reference");
  constexpr const char* kShapeHelp =
      "Closed shape: a mesh in millimetres (OBJ, PLY, STL, VTK, VTP, VTU), a scene from the "
      "service (coapt.scene/2), or a valve or preset, which is closed first";
  command.add_option("closed", arguments->closed, kShapeHelp).required();
  command.add_option("reference", arguments->reference, "Reference shape, in any of the same forms")
      .required();
  command
      .add_option("--align", arguments->alignment,
                  "Alignment before measuring; auto aligns by iterative closest point, unless the "
                  "meshes share their nodes or the valve's position in the patient is known")
      .one_of({"auto", "none", "rigid"})
      .show_default();
  command
      .add_option("--leaflets", arguments->files.leaflets,
                  "Cell array (.vtk, .vtp, .vtu) that numbers the leaflets")
      .show_default("leaflet, element_sets or segment, else connected components");
  command.add_option(
      "--displacement", arguments->files.displacement,
      "Displacement array (.vtp, .vtu) to add to the points, if the file holds the open valve");
  command
      .add_option(
          "--contact-mm", arguments->contact_mm,
          "Contact distance: nodes closer than this to another part of the surface are in contact")
      .show_default("1.25 x the valve's thickness (1 mm if unknown)")
      .check(number_from(0.001, 100.0));
  add_plan_option(command, arguments->repair.plan);
  add_closing_option(command, arguments->closing);
  add_material_option(command, arguments->repair.material);
  command.add_option("--map", arguments->picture, "Write a picture of the signed distance (PNG)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("-o,--output", arguments->mesh,
                  "Write the closed shape with its signed distance (legacy VTK)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON");
  add_server_option(command, arguments->server);
  command.footer(
      "Meshes with the same nodes and connectivity are compared node by node; otherwise the "
      "distance is\nmeasured from each node of CLOSED to the surface of REFERENCE after a rigid "
      "alignment. Distances are\npositive on the side to which the reference's normals point (for "
      "a valve, the atrial side). An\nimported valve is placed where it was imaged. A repair, "
      "pressure and tissue are those of CLOSED; how\nvalves are closed applies to both shapes. The "
      "exit code is 3 if a closure or the alignment did not\nconverge.\n\n"
      "Examples:\n"
      "  coapt compare closed.vtk segmented.stl --map distance.png\n"
      "  coapt compare human-normal fine.ply --json\n"
      "  coapt compare valve.json after.stl --plan ring.json --pressure 100\n"
      "  coapt compare frame_19.vtu frame_20.vtu --contact-mm 0.8 -o distance.vtk");
  on_run_by(command, "compare", arguments->server, {}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
