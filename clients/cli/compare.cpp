#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/method_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "core/valve/patient_frame.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/exchange/import_files.h"
#include "io/exchange/shape_file.h"
#include "io/json/comparison_json.h"
#include "io/mesh/write_vtk.h"
#include "io/picture/distance_map.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kSamePlace_mm = 30.0;        // of the middles of two shapes in one patient
constexpr double kContactThicknesses = 1.25;  // as of coaptation (core/metrics/coaptation.h)

struct CompareArguments {
  std::string closed, reference, picture, mesh;
  std::string alignment = "auto";
  ShapeFileOptions files;
  ClosureOptions closure;
  std::optional<double> contact_mm;
  bool json = false;
};

/// A shape, and what is known of it where it was closed here.
struct Shape {
  LeafletMesh mesh;
  std::optional<double> thickness_mm;
  bool at_rest = true;
  bool in_own_axes = false;  ///< of a valve or a scene; a mesh lies where its file says
  std::optional<PatientFrame> patient = {};
};

Shape closed_shape_of(const Valve& valve, const ClosureOptions& options) {
  const ClosedValve closed = close_and_measure(valve, options);
  const bool is_finite = closed.closure.closed_mm.allFinite();
  note_doubt("compare: " + valve.name, closed.closure);
  return {is_finite ? shape_of(closed) : LeafletMesh{}, valve.tissue.thickness_mm,
          trusted(closed.closure), true, valve.patient};
}

/// A mesh by the end of its name, a scene, or a valve, which is closed.
Expected<Shape> read_shape_argument(const std::string& argument,
                                    const CompareArguments& arguments) {
  const std::string format = format_of(argument);
  std::error_code ignored;
  const bool exists = std::filesystem::exists(argument, ignored);
  if (is_shape_format(format)) {
    const Expected<std::string> bytes = read_input(argument);
    if (!bytes) return bytes.errors();
    Expected<LeafletMesh> mesh = read_shape(*bytes, format, arguments.files);
    if (!mesh) return mesh.errors();
    return Shape{*std::move(mesh), {}};
  }
  if (exists && format != "json")
    return Error{ErrorCode::Unsupported, "",
                 "must end in one of " + shape_format_names() +
                     ", or be a valve or a scene (.json), or the name of a preset"};
  if (exists) {
    const Expected<std::string> text = read_input(argument);
    if (!text) return text.errors();
    if (is_scene_text(*text)) {
      Expected<LeafletMesh> mesh = read_scene_shape(*text);
      if (!mesh) return mesh.errors();
      return Shape{*std::move(mesh), {}, true, true};
    }
  }
  const Expected<Valve> valve = read_valve_argument(argument);
  if (!valve) return valve.errors();
  Shape shape = closed_shape_of(*valve, arguments.closure);
  if (shape.mesh.faces.rows() == 0)
    return Error{ErrorCode::BadGeometry, "",
                 "diverged during closure; there is no closed shape to compare"};
  return shape;
}

Vec3 middle_mm(const Shape& shape) { return shape.mesh.vertices_mm.colwise().mean(); }

/// Valves that know where they lie in the patient go there, beside a mesh or another that knows it. @return whether one did
bool place_in_patient(Shape& closed, Shape& reference) {
  const bool both = closed.in_own_axes && reference.in_own_axes;
  if (both && (!(closed.patient && reference.patient) || closed.patient == reference.patient))
    return false;
  bool placed = false;
  for (Shape* shape : {&closed, &reference}) {
    if (!shape->patient) continue;
    shape->mesh.vertices_mm = to_patient(*shape->patient, shape->mesh.vertices_mm);
    placed = true;
  }
  return placed;
}

/// Shapes that their frames lay on each other stay there: a rigid motion would hide how far they are apart.
Alignment alignment_of(const std::string& word, bool placed, const Shape& closed,
                       const Shape& reference) {
  if (word == "auto" && placed && (middle_mm(closed) - middle_mm(reference)).norm() < kSamePlace_mm)
    return Alignment::None;
  return word == "none" ? Alignment::None : word == "rigid" ? Alignment::Rigid : Alignment::Auto;
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
  out << json["closed"]["source"].get<std::string>() << " against "
      << json["reference"]["source"].get<std::string>()
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

std::string map_vtk(const ShapeComparison& comparison, const ComparedShape& closed) {
  VtkPolyData data{kVtkTitle, comparison.moved_mm, {}, closed.mesh.faces, {}, {}, {}};
  data.point_data = {{"signed_distance_mm", comparison.signed_mm, false},
                     {"contact", {closed.contact.begin(), closed.contact.end()}, true}};
  data.face_data = {{"leaflet", {closed.mesh.leaflets.begin(), closed.mesh.leaflets.end()}, true}};
  return write_vtk(data);
}

std::string map_png(const ShapeComparison& comparison, const ComparedShape& closed,
                    const ComparedShape& reference) {
  const DistanceSummary& distance = comparison.distance;
  const auto name_of = [](const std::string& source) {
    return std::filesystem::path(source).filename().string();
  };
  return distance_map_png(
      {comparison.moved_mm, closed.mesh.faces, comparison.signed_mm,
       round_range_mm(distance.p95_mm),
       name_of(closed.source) + " against " + name_of(reference.source),
       std::string(comparison.node_to_node ? "node to node" : "node to surface") +
           (comparison.aligned ? ", aligned" : "") + ": rms " + fixed(distance.rms_mm, 3) +
           " mm, p95 " + fixed(distance.p95_mm, 3) + " mm, max " + fixed(distance.max_mm, 3) +
           " mm; research software, not a medical device"});
}

int run(const CompareArguments& arguments) {
  for (const std::string& output : {arguments.picture, arguments.mesh})
    if (const int failed = check_output(output)) return failed;
  Expected<Shape> closed = read_shape_argument(arguments.closed, arguments);
  if (!closed) return report_errors(arguments.closed, closed.errors());
  Expected<Shape> reference = read_shape_argument(arguments.reference, arguments);
  if (!reference) return report_errors(arguments.reference, reference.errors());
  const bool placed = place_in_patient(*closed, *reference);
  const double contact_mm = arguments.contact_mm.value_or(
      kContactThicknesses * closed->thickness_mm.value_or(reference->thickness_mm.value_or(1.0)));
  const ComparedShape ours{arguments.closed, closed->mesh,
                           nodes_in_contact(closed->mesh, contact_mm)};
  const ComparedShape theirs{arguments.reference, reference->mesh,
                             nodes_in_contact(reference->mesh, contact_mm)};
  const ShapeComparison comparison = compare_shapes(
      ours.mesh, theirs.mesh, alignment_of(arguments.alignment, placed, *closed, *reference));
  const Json json = comparison_to_json(comparison, ours, theirs, contact_mm);
  if (arguments.json) {
    std::cout << json.dump(2) << '\n';
  } else {
    print_comparison(std::cout, json);
  }
  if (!arguments.picture.empty())
    if (const int failed = write_output(arguments.picture, map_png(comparison, ours, theirs)))
      return failed;
  if (!arguments.mesh.empty())
    if (const int failed = write_output(arguments.mesh, map_vtk(comparison, ours))) return failed;
  const bool at_rest = closed->at_rest && reference->at_rest && comparison.settled;
  return at_rest ? exit_code::kOk : exit_code::kNotClosed;
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
  add_membrane_option(command, arguments->closure.membrane);
  command.add_option("--map", arguments->picture, "Write a picture of the signed distance (PNG)")
      .check({refuse_standard_output, "FILE"});
  command
      .add_option("-o,--output", arguments->mesh,
                  "Write the closed shape with its signed distance (legacy VTK)")
      .check({refuse_standard_output, "FILE"});
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "Meshes with the same nodes and connectivity are compared node by node; otherwise the "
      "distance is\nmeasured from each node of CLOSED to the surface of REFERENCE after a rigid "
      "alignment. Distances are\npositive on the side to which the reference's normals point (for "
      "a valve, the atrial side). An\nimported valve is placed where it was imaged. The exit code "
      "is 3 if a closure or the alignment did\nnot converge.\n\n"
      "Examples:\n"
      "  coapt compare closed.vtk segmented.stl --map distance.png\n"
      "  coapt compare human-normal fine.ply --json\n"
      "  coapt compare frame_19.vtu frame_20.vtu --contact-mm 0.8 -o distance.vtk");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
