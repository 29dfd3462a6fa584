#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/import_inputs.h"
#include "clients/cli/observed_options.h"
#include "core/valve/printable.h"
#include "io/command_line/command_line.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/exchange/decisions_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/imaged_state.h"
#include "io/mesh/text_scan.h"
#include "io/picture/import_picture.h"
#include "operations/import_request.h"

namespace coapt {
namespace {

struct ValveImportArguments {
  ImportInputs inputs;
  PatientAxes axes = PatientAxes::LPS;  // if given
  int seed = 1;
  bool seed_given = false;
  LengthUnit units = LengthUnit::Millimetre;  // if given
  std::string name, thickness;
  std::vector<std::string> provenance;
  bool closed = false;
  ImagedState state = ImagedState::Open;  // if given
  ImportOptions options;
  ObservedOptions observed;
  std::string output, picture;
  bool json = false, strict = false;
};

constexpr const char* kSynthesise = "synthesise";

/// Whether it is a number or the word measured.
bool take_thickness(const std::string& text, ImportOptions& options) {
  options.thickness_measured = text == "measured";
  if (text.empty() || options.thickness_measured) return true;
  options.thickness_mm = to_number(text);
  return options.thickness_mm.has_value();
}

/// What cannot be given together, or is missing.
std::string misused(const ValveImportArguments& arguments) {
  const ImportInputs& inputs = arguments.inputs;
  const bool synthesises = inputs.chordae == kSynthesise;
  if (!inputs.slicerheart.empty() && !synthesises && !inputs.chordae.empty())
    return "--chordae must be synthesise when used with --slicerheart";
  if (!inputs.chordae.empty() && !synthesises && !inputs.tips.empty())
    return "--tips requires --chordae synthesise, because imaged chordae already begin at their "
           "tips";
  if (!inputs.bare.empty() || !inputs.slicerheart.empty() || !inputs.abaqus.empty()) return "";
  const bool leaflets = !inputs.leaflets.empty() || !inputs.labels.empty();
  if (!leaflets) return "--leaflet is required (or --labels, --slicerheart, or bare files)";
  if (inputs.chordae.empty() && inputs.labels.empty())
    return "--chordae is required (or --slicerheart); use --chordae synthesise to generate chordae "
           "that were not imaged";
  return "";
}

/// What a person should look at first.
void tell(const std::vector<ImportDecision>& decisions) {
  for (const ImportDecision& decision : decisions)
    if (decision.look)
      std::cerr << "coapt: valve import: check this against the images: "
                << printable(sentence(decision)) << ".\n";
  for (const ImportDecision& decision : decisions)
    if (!decision.look)
      std::cerr << "coapt: valve import: " << printable(decision.subject + ": " + decision.value)
                << ".\n";
}

/// What was read, with the options of the import.
ReadInputs read_request(const ValveImportArguments& arguments) {
  const bool synthesises = arguments.inputs.chordae == kSynthesise;
  ReadInputs read = read_import_inputs(arguments.inputs, synthesises);
  if (read.failed != exit_code::kOk) return read;
  read.request.options = arguments.options;
  read.request.seed = arguments.seed;
  if (synthesises) read.request.options.chordae_seed = arguments.seed;
  if (!arguments.name.empty()) read.request.name = arguments.name;
  read.request.provenance = arguments.provenance;
  return read;
}

int run(ValveImportArguments& arguments) {
  if (const int failed = check_output(arguments.picture)) return failed;
  if (const std::string why = misused(arguments); !why.empty()) {
    std::cerr << "coapt: valve import: " << printable(why) << '\n';
    return exit_code::kBadInput;
  }
  if (const Errors errors = check_observed(arguments.observed); !errors.empty())
    return report_errors("valve import", errors);
  ReadInputs read = read_request(arguments);
  if (read.failed != exit_code::kOk) return read.failed;
  Expected<ImportedValve> valve = make_import(std::move(read.request), {});
  if (!valve) return report_import_errors(valve.errors(), read.places);
  if (!is_mitral(valve->valve) && (any_observed(arguments.observed) || !arguments.picture.empty()))
    return report_errors("valve import",
                         {Error{ErrorCode::Unsupported, "",
                                "observations (--leak, ...) and --render require a mitral valve, "
                                "not a finite element model"}});
  valve->decisions.insert(valve->decisions.begin(), read.decisions.begin(), read.decisions.end());
  take_observed(arguments.observed, valve->valve);
  if (arguments.seed_given && !valve->valve.drawn_chordae)
    valve->decisions.push_back({"options", "seed not used",
                                is_mitral(valve->valve)
                                    ? "the files contain chordae"
                                    : "a finite element model is taken as it is",
                                true});
  if (const int failed = write_output(arguments.output, write_valve(valve->valve))) return failed;
  if (!arguments.picture.empty())
    if (const int failed =
            write_output(arguments.picture, import_picture_png(*valve, valve->valve.name)))
      return failed;
  if (arguments.json)
    std::cout << json_text(import_to_json(*valve), 2) << '\n';
  else
    tell(valve->decisions);
  const bool looks = std::any_of(valve->decisions.begin(), valve->decisions.end(),
                                 [](const ImportDecision& decision) { return decision.look; });
  return arguments.strict && looks ? exit_code::kUnchecked : exit_code::kOk;
}

}  // namespace

void add_valve_import(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveImportArguments>();
  ImportOptions& options = arguments->options;
  Command command = parent.add_command(
      "import", "Make a valve from label maps, or from leaflet meshes, annulus and chordae");
  ImportInputs& inputs = arguments->inputs;
  command.add_option(
      "files", inputs.bare,
      "Files whose role is detected from name and content (reported by --json): a "
      "label map (.nrrd, .nii, .nii.gz), meshes, markups, tables; a folder of these, "
      "of SlicerHeart or of a DICOM series; or an Abaqus model (.inp)");
  command
      .add_option(
          "--leaflet", inputs.leaflets,
          "Leaflet mesh (OBJ, PLY, STL, glTF, VTK, VTP or VTU): anterior and posterior, one file "
          "with both as parts, or one continuous skirt; sheets, or thick shells, which are "
          "reduced to their mid-surfaces")
      .count(1, 2);
  command
      .add_option("--labels", inputs.labels,
                  "Label map of the leaflets and optionally the annulus (NRRD, NIfTI or "
                  "MetaImage), instead of meshes")
      .excludes("--leaflet");
  command
      .add_option("--label", inputs.label_numbers,
                  "Label value (or part number of a mesh file) of a structure: anterior=N, "
                  "posterior=N or annulus=N (repeatable, also for the scallops of a leaflet; "
                  "default: by the names in the file, else by shape)")
      .one_at_a_time();
  command
      .add_option("--phase", inputs.phase,
                  "Phase of the label map, starting at 1 (default: the first that has labels)")
      .check(number_from(1, kMostPhases));
  command.add_option("--series", inputs.series,
                     "Folder of the DICOM series that was segmented; supplies spacing and frame if "
                     "the label map lacks them, otherwise checks them");
  command.add_option(
      "--annulus", inputs.annulus,
      "Annulus as a closed loop: a table with columns x, y, z (CSV, text, .fcsv), a "
      "closed curve from Slicer (.mrk.json), or lines in OBJ, glTF, VTK or VTP (default: "
      "detected along the leaflet outlines)");
  command.add_option("--chordae", inputs.chordae,
                     "Insertions and papillary tips (CSV or JSON); or the word synthesise, to "
                     "generate chordae from anatomical data because images show none");
  command
      .add_option("--seed", arguments->seed,
                  "Random seed for synthesised chordae (0: mean anatomy)")
      .check(number_from(0, 2147483647))
      .show_default();
  command.add_option("--tips", inputs.tips,
                     "Imaged papillary tips for synthesised chordae: CSV lines papillary,x,y,z "
                     "(papillary AL or PM), or Slicer points with these labels (.mrk.json)");
  command
      .add_option(
          "--slicerheart", inputs.slicerheart,
          "Import a folder written by SlicerHeart's ValveFemExport or `coapt export` instead")
      .excludes("files")
      .excludes("--leaflet")
      .excludes("--labels")
      .excludes("--annulus");
  command
      .add_option("--abaqus", inputs.abaqus,
                  "Import an Abaqus .inp file (shells and trusses, any number of leaflets) instead")
      .excludes("files")
      .excludes("--leaflet")
      .excludes("--labels")
      .excludes("--annulus")
      .excludes("--chordae")
      .excludes("--slicerheart");
  command
      .add_option("--landmarks", inputs.landmarks,
                  "Landmarks placed by a person, at most 10 mm from the annulus; others are "
                  "detected: points labelled ALC and PMC (commissures), A (saddle peak) and P "
                  "(mid-posterior), from Slicer (.mrk.json) or as a table label,x,y,z")
      .excludes("--abaqus");
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();
  command.add_option("--triangles", options.triangles, "Approximate number of triangles")
      .show_default()
      .check(number_from(100, 100000));
  command.add_option("--branches", options.branches, "Number of insertions per chorda")
      .show_default()
      .check(number_from(1, 5));
  command
      .add_option(
          "--branch-at", options.branch_at,
          "Position of the branching point, as a fraction of the distance from tip to insertion")
      .show_default();
  command.add_option("--slack", options.slack, "Ratio of chordal length to straight distance")
      .show_default();
  const std::map<std::string, TissueReference> references = {
      {to_string(TissueReference::Excised), TissueReference::Excised},
      {to_string(TissueReference::InVivo), TissueReference::InVivo}};
  command
      .add_choice("--reference", options.reference, references,
                  "State of the tissue in the meshes: excised (default), stress-free leaflets; "
                  "in_vivo, leaflets of the unpressurised heart, which are prestretched")
      .show_argument("STATE");
  const std::map<std::string, ImagedState> states = {{"open", ImagedState::Open},
                                                     {"closed", ImagedState::Closed}};
  command
      .add_choice("--state", arguments->state, states,
                  "Imaged state of the leaflets, open or closed (default: inferred from how much "
                  "of the annulus they cover); for leaflets closed under pressure, the open ones "
                  "are derived (needs --chordae synthesise)")
      .show_argument("STATE");
  command.add_flag("--closed", arguments->closed, "Same as --state closed")
      .excludes("--reference")
      .excludes("--state");
  command
      .add_option(
          "--thickness", arguments->thickness,
          "Tissue thickness in millimetres, or the word measured, for the mean thickness of thick "
          "leaflets (default: 1 mm, because segmentation thickens leaflets by about a voxel)")
      .show_argument("MM")
      .excludes("--abaqus");
  command
      .add_option("--hidden", options.hidden_mm,
                  "Leaflet height hidden in coaptation, for closed leaflets, mm (coapt fit can "
                  "estimate it)")
      .check(number_from(0.0, 15.0))
      .show_default();
  const std::map<std::string, LengthUnit> units = {
      {to_string(LengthUnit::Millimetre), LengthUnit::Millimetre},
      {to_string(LengthUnit::Centimetre), LengthUnit::Centimetre},
      {to_string(LengthUnit::Inch), LengthUnit::Inch},
      {to_string(LengthUnit::Metre), LengthUnit::Metre}};
  command
      .add_choice("--units", arguments->units, units,
                  "Unit of length in the files: mm, cm, in or m (default: the unit that gives an "
                  "annular circumference of 70 to 200 mm)")
      .show_argument("UNIT")
      .excludes("--abaqus");
  const std::map<std::string, PatientAxes> axes = {{to_string(PatientAxes::LPS), PatientAxes::LPS},
                                                   {to_string(PatientAxes::RAS), PatientAxes::RAS}};
  command
      .add_choice("--frame", arguments->axes, axes,
                  "Patient axes of meshes and tables: LPS or RAS (default: as stated in each file, "
                  "else LPS; markups and label maps always state them)")
      .show_argument("AXES")
      .excludes("--slicerheart")
      .excludes("--abaqus");
  command
      .add_flag("--trust-labels", options.trust_labels,
                "Trust labels, names and order of the leaflets, even if their shapes suggest the "
                "opposite")
      .excludes("--abaqus");
  command
      .add_flag("--flip", options.flip,
                "Reverse the side of the annulus on which the atrium lies, if there are no "
                "papillary tips to determine it")
      .excludes("--abaqus");
  command.add_flag("--mirrored", options.mirrored, "Mirror all files (change the sign of x)")
      .excludes("--abaqus");
  command
      .add_flag("--strict", arguments->strict,
                "Exit with code 3 if a decision should be checked against the images; the valve is "
                "still written")
      .excludes("--abaqus");
  add_observed_options(command, arguments->observed, "--observed-by");
  command.add_option("--name", arguments->name, "Name of the valve").show_default("imported");
  command.add_option("--provenance", arguments->provenance,
                     "Source or licence, stored in the valve");
  command
      .add_option("--render", arguments->picture,
                  "Write a picture of the input beside the resulting valve (PNG)")
      .check({refuse_standard_output, "FILE"})
      .excludes("--abaqus");
  command
      .add_flag(
          "--json", arguments->json,
          "Print every import decision with its reason (coapt.import/2); -o must then be a file")
      .excludes("--abaqus");
  command.footer(
      "Examples:\n"
      "  coapt valve import --leaflet anterior.obj posterior.obj --annulus annulus.csv \\\n"
      "    --chordae chordae.csv --triangles 1400 -o valve.json\n\n"
      "Images without chordae, and possibly without papillary tips:\n"
      "  coapt valve import --leaflet anterior.stl posterior.stl --annulus annulus.mrk.json \\\n"
      "    --chordae synthesise --seed 1 --tips tips.csv -o valve.json\n\n"
      "Leaflets segmented in systole:\n"
      "  coapt valve import --leaflet a.stl p.stl --annulus ring.mrk.json --closed \\\n"
      "    --chordae synthesise -o open.json\n\n"
      "Only a segmentation of an echo or CT image:\n"
      "  coapt valve import segmentation.seg.nrrd -o valve.json\n"
      "  coapt valve import labels.nii.gz --label anterior=4 --label posterior=5 --label annulus=7 "
      "\\\n"
      "    --series DICOM/ -o valve.json\n\n"
      "A folder holds the leaflets and the chordae as .vtk (chordae as lines, or as .csv tables),\n"
      "the annulus as a closed curve and the papillary tips, labelled AL and PM, as .mrk.json:\n"
      "  coapt valve import --slicerheart FEM-model/ -o valve.json\n\n"
      "A finite-element model; it becomes a coapt.valve/2 for `coapt close`:\n"
      "  coapt valve import --abaqus Healthy_QuasiStatic.inp -o trivalve.json");
  command.on_run([arguments, command, &status] {
    if (command.has("--frame")) arguments->inputs.axes = arguments->axes;
    if (command.has("--units")) arguments->options.units = arguments->units;
    arguments->seed_given = command.has("--seed");
    if (arguments->closed) arguments->options.closed = true;
    if (command.has("--state")) arguments->options.closed = arguments->state == ImagedState::Closed;
    if (!take_thickness(arguments->thickness, arguments->options)) {
      std::cerr << "coapt: valve import: --thickness must be a number of millimetres or the word "
                   "measured\n";
      status = exit_code::kBadInput;
      return;
    }
    if (arguments->json && arguments->output == "-") {
      std::cerr << "coapt: valve import: --json uses standard output, so -o must name a file\n";
      status = exit_code::kBadInput;
      return;
    }
    status = run(*arguments);
  });
}

}  // namespace coapt
