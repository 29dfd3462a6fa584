#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/exit_code.h"
#include "clients/cli/files.h"
#include "io/command_line/command_line.h"
#include "io/exchange/abaqus_valve.h"
#include "io/exchange/decisions_json.h"
#include "io/exchange/import_files.h"
#include "io/exchange/slicerheart.h"
#include "io/json/result_json.h"
#include "io/json/valve_json.h"
#include "io/mesh/imaged_state.h"
#include "io/mesh/text_scan.h"

namespace coapt {
namespace {

struct ValveImportArguments {
  std::vector<std::string> leaflets;
  std::string annulus, chordae, slicerheart, abaqus, tips;
  int seed = 1;
  LengthUnit units = LengthUnit::Millimetre;  // if given
  std::string name, thickness;
  std::vector<std::string> provenance;
  bool closed = false;
  ImagedState state = ImagedState::Open;  // if given
  ImportOptions options;
  std::string output;
  bool json = false;
};

/// Reads the file at `path` with `parse` into `value`; returns an exit code.
template <class T, class Parse>
int read_part(const std::string& path, const Parse& parse, T& value) {
  const Expected<std::string> bytes = read_input(path);
  if (!bytes) return report_errors(path, bytes.errors());
  Expected<T> parsed = parse(*bytes, format_of(path));
  if (!parsed) return report_errors(path, parsed.errors());
  value = *std::move(parsed);
  return exit_code::kOk;
}

constexpr const char* kSynthesise = "synthesise";

/// The files of a folder that a valve can be made of, in the order of their names.
Expected<std::vector<NamedFile>> read_folder(const std::string& path) {
  std::error_code failed;
  std::vector<std::filesystem::path> paths;
  for (auto entry = std::filesystem::directory_iterator(path, failed);
       !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    const std::string format = format_of(entry->path());
    if (format == "vtk" || format == "csv" || format == "json") paths.push_back(entry->path());
  }
  if (failed) return Error{ErrorCode::InputOutput, "", "cannot be opened as a folder"};
  std::sort(paths.begin(), paths.end());
  std::vector<NamedFile> files;
  for (const auto& file : paths) {
    Expected<std::string> bytes = read_input(file);
    if (!bytes) return Error{ErrorCode::InputOutput, file.filename(), "cannot be read"};
    files.push_back({file.filename(), *std::move(bytes)});
  }
  return files;
}

/// coapt.import/1. Keys that scripts rely on: decisions[] (about, decision, reason, look).
nlohmann::ordered_json import_to_json(const ImportedValve& imported) {
  return {{"schema", "coapt.import/1"},
          {"version", version()},
          {"notice", kResearchNotice},
          {"name", imported.valve.name},
          {"triangles", imported.valve.faces.rows()},
          {"chordae", imported.valve.chordae.size()},
          {"thickness", to_json(imported.thickness)},
          {"decisions", to_json(imported.decisions)}};
}

/// The files that options name one by one.
int read_parts(const ValveImportArguments& arguments, ImportSource& source) {
  for (const auto& [missing, option] : {std::pair(arguments.leaflets.empty(), "--leaflet"),
                                            {arguments.chordae.empty(), "--chordae"}}) {
    if (!missing) continue;
    std::cerr << "coapt: valve import: " << option << " is required (or --slicerheart)"
              << (arguments.chordae.empty() ? "; --chordae synthesise draws chordae that were not "
                                              "seen from anatomy\n"
                                            : "\n");
    return exit_code::kBadInput;
  }
  for (const std::string& path : arguments.leaflets) {
    source.leaflets.emplace_back();
    if (const int failed = read_part(path, read_packed_mesh, source.leaflets.back())) return failed;
  }
  if (!arguments.annulus.empty())
    if (const int failed = read_part(arguments.annulus, read_closed_loop, source.annulus_mm))
      return failed;
  if (arguments.chordae == kSynthesise) return exit_code::kOk;
  return read_part(arguments.chordae, read_chordae, source.chordae);
}

int read_slicerheart_folder(const ValveImportArguments& arguments, ImportSource& source) {
  Expected<std::vector<NamedFile>> files = read_folder(arguments.slicerheart);
  if (!files) return report_errors(arguments.slicerheart, files.errors());
  Expected<ImportSource> read = read_slicerheart(*files);
  if (!read) return report_errors(arguments.slicerheart, read.errors());
  source = *std::move(read);
  return exit_code::kOk;
}

int run_abaqus(const ValveImportArguments& arguments) {
  const Expected<std::string> text = read_input(arguments.abaqus);
  if (!text) return report_errors(arguments.abaqus, text.errors());
  const Expected<Valve> valve = read_abaqus_valve(*text, {arguments.name, arguments.provenance});
  if (!valve) return report_errors(arguments.abaqus, valve.errors());
  return write_output(arguments.output, write_valve(*valve));
}

/// Whether it is a number or the word measured.
bool take_thickness(const std::string& text, ImportOptions& options) {
  options.thickness_measured = text == "measured";
  if (text.empty() || options.thickness_measured) return true;
  options.thickness_mm = to_number(text);
  return options.thickness_mm.has_value();
}

int run(const ValveImportArguments& arguments) {
  if (!arguments.abaqus.empty()) return run_abaqus(arguments);
  ImportSource source;
  const bool folder = !arguments.slicerheart.empty();
  const bool synthesises = arguments.chordae == kSynthesise;
  if (folder && !synthesises && !arguments.chordae.empty()) {
    std::cerr << "coapt: valve import: --chordae takes only synthesise with --slicerheart\n";
    return exit_code::kBadInput;
  }
  if (!synthesises && !arguments.tips.empty()) {
    std::cerr << "coapt: valve import: --tips takes --chordae synthesise: chordae that were seen "
                 "begin at their tips\n";
    return exit_code::kBadInput;
  }
  if (const int failed =
          folder ? read_slicerheart_folder(arguments, source) : read_parts(arguments, source))
    return failed;
  if (!arguments.tips.empty())
    if (const int failed = read_part(arguments.tips, read_tips, source.tips)) return failed;
  source.name = arguments.name;
  source.provenance.insert(source.provenance.begin(), arguments.provenance.begin(),
                           arguments.provenance.end());
  const Expected<ImportedValve> valve = import_with_decisions(source, arguments.options);
  if (!valve) {
    if (folder) return report_errors(arguments.slicerheart, valve.errors());
    return report_option_errors("valve import", valve.errors(),
                                {{"/leaflets", "--leaflet"},
                                 {"/annulus_mm", "--annulus"},
                                 {"/tips", "--tips"},
                                 {"/tips_mm", "--tips"},
                                 {"/thickness_measured", "--thickness"},
                                 {"/tissue/thickness_mm", "--thickness"}});
  }
  const int failed = write_output(arguments.output, write_valve(valve->valve));
  if (failed == exit_code::kOk && arguments.json)
    std::cout << import_to_json(*valve).dump(2) << '\n';
  return failed;
}

}  // namespace

void add_valve_import(Command parent, int& status) {
  const auto arguments = std::make_shared<ValveImportArguments>();
  ImportOptions& options = arguments->options;
  Command command =
      parent.add_command("import", "Make a valve from leaflet meshes, annulus and chordae");
  command
      .add_option(
          "--leaflet", arguments->leaflets,
          "Leaflet mesh (OBJ, PLY, STL, VTK, VTP or VTU): anterior and posterior, or one skirt; "
          "sheets or thick shells, which become their mid-surfaces")
      .count(1, 2);
  command.add_option("--annulus", arguments->annulus,
                     "Closed loop, CSV of x,y,z lines or a closed curve of Slicer (.mrk.json); without it, it is "
                     "found along the leaflets' outlines");
  command.add_option(
      "--chordae", arguments->chordae,
      "Insertions and papillary tips, CSV or JSON; or the word synthesise: drawn from "
      "anatomy, because images show none");
  command.add_option("--seed", arguments->seed, "Of synthesised chordae; 0: the mean anatomy")
      .check(number_from(0, 2147483647))
      .show_default();
  command.add_option(
      "--tips", arguments->tips,
      "Papillary tips that were seen, for synthesised chordae: CSV of papillary,x,y,z "
      "lines (papillary AL or PM) or points of Slicer labelled so (.mrk.json)");
  command
      .add_option("--slicerheart", arguments->slicerheart,
                  "Folder that SlicerHeart's ValveFemExport or `coapt export` wrote, instead")
      .excludes("--leaflet")
      .excludes("--annulus");
  command
      .add_option(
          "--abaqus", arguments->abaqus,
          "Input file of Abaqus (.inp, shells and trusses, any number of leaflets), instead")
      .excludes("--leaflet")
      .excludes("--annulus")
      .excludes("--chordae")
      .excludes("--slicerheart");
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required();
  command.add_option("--triangles", options.triangles, "About how many triangles")
      .show_default()
      .check(number_from(100, 100000));
  command.add_option("--branches", options.branches, "Insertions per chorda")
      .show_default()
      .check(number_from(1, 5));
  command.add_option("--branch-at", options.branch_at, "Share of the way from tip to insertion")
      .show_default();
  command.add_option("--slack", options.slack, "Chordae lengths over straight distances")
      .show_default();
  const std::map<std::string, TissueReference> references = {
      {to_string(TissueReference::Excised), TissueReference::Excised},
      {to_string(TissueReference::InVivo), TissueReference::InVivo}};
  command
      .add_choice(
          "--reference", options.reference, references,
          "What the meshes show: excised (default), leaflets free of stress; in_vivo, those of the "
          "unpressurised heart, which are stretched already")
      .show_argument("STATE");
  const std::map<std::string, ImagedState> states = {{"open", ImagedState::Open},
                                                     {"closed", ImagedState::Closed}};
  command
      .add_choice("--state", arguments->state, states,
                  "How the leaflets were imaged, open or closed (default: judged from how much of the "
                  "annulus they cover); of closed ones, under pressure, the open ones are derived, with "
                  "--chordae synthesise")
      .show_argument("STATE");
  command.add_flag("--closed", arguments->closed, "The same as --state closed")
      .excludes("--reference")
      .excludes("--state");
  command
      .add_option("--thickness", arguments->thickness,
                  "Of the tissue: a number of millimetres, or the word measured: the mean of thick "
                  "leaflets (default: 1 mm, because segmentation thickens by about a voxel)")
      .show_argument("MM")
      .excludes("--abaqus");
  command
      .add_option("--hidden", options.hidden_mm,
                  "Height of closed leaflets that coaptation hides, mm; coapt fit finds it")
      .check(number_from(0.0, 15.0))
      .show_default();
  const std::map<std::string, LengthUnit> units = {
      {to_string(LengthUnit::Millimetre), LengthUnit::Millimetre},
      {to_string(LengthUnit::Centimetre), LengthUnit::Centimetre},
      {to_string(LengthUnit::Metre), LengthUnit::Metre}};
  command
      .add_choice(
          "--units", arguments->units, units,
          "Of the files' lengths: mm, cm or m (default: guessed from the circumference of the "
          "annulus, 30 to 400 mm)")
      .show_argument("UNIT")
      .excludes("--abaqus");
  command.add_option("--name", arguments->name, "Name of the valve").show_default("imported");
  command.add_option("--provenance", arguments->provenance, "Source or licence, kept in the valve");
  command
      .add_flag("--json", arguments->json,
                "Print every decision of the import with its reason (coapt.import/1); -o must be a "
                "file")
      .excludes("--abaqus");
  command.footer(
      "Examples:\n"
      "  coapt valve import --leaflet anterior.obj posterior.obj --annulus annulus.csv \\\n"
      "    --chordae chordae.csv --triangles 1400 -o valve.json\n\n"
      "Images that show no chordae, and perhaps no papillary tips:\n"
      "  coapt valve import --leaflet anterior.stl posterior.stl --annulus annulus.mrk.json \\\n"
      "    --chordae synthesise --seed 1 --tips tips.csv -o valve.json\n\n"
      "Leaflets segmented in systole, then fitted to the same surface:\n"
      "  coapt valve import --leaflet a.stl p.stl --annulus ring.mrk.json --closed \\\n"
      "    --chordae synthesise -o open.json\n\n"
      "A folder holds the leaflets and the chordae as .vtk (chordae as lines, or as .csv tables),\n"
      "the annulus as a closed curve and the papillary tips, labelled AL and PM, as .mrk.json:\n"
      "  coapt valve import --slicerheart FEM-model/ -o valve.json\n\n"
      "A model of another code becomes a coapt.valve/2, which `coapt close` closes:\n"
      "  coapt valve import --abaqus Healthy_QuasiStatic.inp -o trivalve.json");
  command.on_run([arguments, command, &status] {
    if (arguments->chordae == kSynthesise) arguments->options.chordae_seed = arguments->seed;
    if (command.has("--units")) arguments->options.units = arguments->units;
    if (arguments->closed) arguments->options.closed = true;
    if (command.has("--state")) arguments->options.closed = arguments->state == ImagedState::Closed;
    if (!take_thickness(arguments->thickness, arguments->options)) {
      std::cerr << "coapt: valve import: --thickness must be a number of millimetres, or measured\n";
      status = exit_code::kBadInput;
      return;
    }
    if (arguments->json && arguments->output == "-") {
      std::cerr << "coapt: valve import: --json takes standard output, so -o must name a file\n";
      status = exit_code::kBadInput;
      return;
    }
    status = run(*arguments);
  });
}

}  // namespace coapt
