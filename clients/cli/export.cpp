#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "clients/cli/result_exit_code.h"
#include "core/valve/number_text.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/exchange/formats.h"
#include "io/json/plan_json.h"
#include "search/evaluator.h"

namespace coapt {
namespace {

struct ExportArguments {
  std::string valve;
  PlanOption plan;
  std::vector<std::string> outputs;
  std::string grid;
  ExportOptions options;
};

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return path.ends_with('/') || std::filesystem::is_directory(path, ignored);
}

/// A usage error unless the path says what to write.
std::string refuse_unknown_format(const std::string& path) {
  if (is_folder(path) || format_of_path(path) != nullptr) return "";
  return "'" + path + "' must end in one of " + format_names() + ", or be a folder";
}

int write_folder(const std::string& path, const ClosedValve& exported,
                 const ExportOptions& options) {
  const Expected<std::vector<NamedFile>> files = write_slicerheart(exported, options);
  if (!files) return report_errors("export", files.errors());
  const std::filesystem::path folder = path;
  for (const char* name : kOptionalFiles) {
    const bool is_written = std::any_of(files->begin(), files->end(),
                                        [&](const NamedFile& f) { return f.name == name; });
    std::error_code ignored;
    if (!is_written && std::filesystem::exists(folder / name, ignored))
      return report_errors(
          "export",
          {{ErrorCode::InputOutput, "",
            (folder / name).string() + " is left from an earlier export and would be read together "
                                       "with this one; remove it or choose another folder"}});
  }
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  for (const NamedFile& file : *files)
    if (const int code = write_output(folder / file.name, file.bytes)) return code;
  return exit_code::kOk;
}

int write_file(const std::string& path, const ClosedValve& exported, const ExportOptions& options) {
  const Expected<std::string> bytes = write_valve_file(exported, *format_of_path(path), options);
  if (!bytes) return report_option_errors("export", bytes.errors(), {{"/grid", "--grid"}});
  return write_output(path, *bytes);
}

/// Says it if chordae had to be moved for files whose chordae end at vertices.
void note_attachment(const ExportArguments& arguments, const ClosedValve& exported) {
  double shift = 0.0;
  for (const std::string& path : arguments.outputs) {
    const FileFormat* format = format_of_path(path);
    const std::string name = format == nullptr || is_folder(path) ? "vtk" : format->name;
    if (name != "vtk" && name != "feb") continue;
    const bool open = arguments.options.open || name == "feb";
    shift =
        std::max(shift, attachment_shift_mm(exported.valve, open ? unstressed_shape(exported.valve)
                                                                 : closed_shape(exported)));
  }
  if (shift < 0.001) return;
  std::cerr << "coapt: chordae end at the nearest vertices of the mesh in .vtk and .feb, at most "
            << with_decimals(shift, 2) << " mm from their insertions\n";
}

/// Says it of files from which no import makes a valve with ties.
void note_ties(const ExportArguments& arguments, const Valve& valve) {
  if (valve.ties.empty()) return;
  for (const std::string& path : arguments.outputs)
    if (!is_folder(path) && format_of_path(path)->loses_ties)
      std::cerr << "coapt: " << printable(path)
                << ": this format does not store the edge-to-edge repair; a valve imported from "
                   "the file lacks it\n";
}

int run(ExportArguments arguments) {
  const PlannedValve planned = read_planned_valve(arguments.valve, arguments.plan);
  if (planned.failed) return planned.failed;
  for (const std::string& path : arguments.outputs)
    if (const int failed = is_folder(path) ? exit_code::kOk : check_output(path)) return failed;
  if (!arguments.grid.empty()) {
    const Expected<std::string> bytes = read_input(arguments.grid);
    if (!bytes) return report_errors(arguments.grid, bytes.errors());
    const Expected<LabelMap> map = read_label_map(*bytes);
    if (!map) return report_errors(arguments.grid, map.errors());
    arguments.options.grid = {map->size, map->to_lps_mm, map->placed};
  }

  const ClosedValve exported = with_repair(close_and_measure(planned.repaired, {.motion = true}),
                                           planned.valve, planned.plan);
  for (const std::string& path : arguments.outputs) {
    const auto write = is_folder(path) ? write_folder : write_file;
    if (const int failed = write(path, exported, arguments.options)) return failed;
  }
  note_doubt("export", exported.closure);
  note_attachment(arguments, exported);
  note_ties(arguments, exported.valve);
  return trusted(exported.closure) ? exit_code::kOk : exit_code::kNotClosed;
}

}  // namespace

void add_export(Command parent, int& status) {
  const auto arguments = std::make_shared<ExportArguments>();
  Command command =
      parent.add_command("export", "Close a valve and write it in the formats of other programs");
  command.add_option("valve", arguments->valve, kValveHelp).required();
  add_plan_option(command, arguments->plan);
  command
      .add_option("-o,--output", arguments->outputs,
                  "File to write; its extension sets the format, and a folder (DIR/) receives the "
                  "files of SlicerHeart's ValveFemExport (repeatable)")
      .required()
      .check({refuse_unknown_format, "FILE"});
  command.add_flag("--open", arguments->options.open,
                   "Export the unstressed shape instead of the closed one");
  const std::map<std::string, ExportFrame> frames = {{"patient", ExportFrame::Patient},
                                                     {"valve", ExportFrame::Valve}};
  command
      .add_choice("--frame", arguments->options.frame, frames,
                  "Coordinate frame: patient (default), the frame of the source images, or the "
                  "valve's own where that is unknown; or valve, the valve's own")
      .show_argument("FRAME");
  command.add_option(
      "--grid", arguments->grid,
      "Label map that the valve was imported from; exported label maps use its voxel grid and so "
      "overlay the images (default: a grid of 0.5 mm voxels around the valve)");
  std::string formats = "Formats:\n";
  for (const FileFormat& format : file_formats())
    formats += "  ." + std::string(format.name) +
               std::string(10 - std::string_view(format.name).size(), ' ') + format.what + '\n';
  command.footer(
      formats +
      "Lengths are in millimetres, in .glb in metres.\nThe exit code is 3 if the closure did not "
      "converge or leaflets cross; the files are still written.\n\n"
      "Examples:\n"
      "  coapt export human-normal -o valve.glb\n"
      "  coapt export valve.json --plan plan.json -o repaired.vtk -o repaired.mrk.json\n"
      "  coapt export valve.json --plan plan.json -o repaired.nrrd --grid segmentation.seg.nrrd\n"
      "  coapt export valve.json -o valve.feb\n"
      "  coapt export valve.json --open -o FEM-model/     # coapt valve import --slicerheart reads "
      "it");
  command.on_run([arguments, &status] { status = run(*arguments); });
}

}  // namespace coapt
