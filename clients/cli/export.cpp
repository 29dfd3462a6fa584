#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/ask.h"
#include "clients/cli/commands.h"
#include "clients/cli/plan_option.h"
#include "clients/cli/read_argument.h"
#include "core/valve/printable.h"
#include "io/command_line/exit_code.h"
#include "io/command_line/files.h"
#include "io/exchange/formats.h"
#include "io/json/base64.h"

namespace coapt {
namespace {

struct ExportArguments {
  std::string valve;
  PlanOption plan;
  std::vector<std::string> outputs;
  std::string grid;
  ExportOptions options;
  ServerOption server;
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

/// Of a request.
std::string format_asked(const std::string& path) {
  return is_folder(path) ? "slicerheart" : format_of_path(path)->name;
}

using Files = std::vector<NamedFile>;

int write_folder(const std::string& path, const Files& files) {
  const std::filesystem::path folder = path;
  for (const char* name : kOptionalFiles) {
    const bool is_written =
        std::any_of(files.begin(), files.end(), [&](const NamedFile& f) { return f.name == name; });
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
  for (const NamedFile& file : files)
    if (const int code = write_output(folder / file.name, file.bytes)) return code;
  return exit_code::kOk;
}

/// The voxels of the label map of --grid, as a request has them.
Expected<Json> read_grid(const std::string& path) {
  const Expected<std::string> bytes = read_input(path);
  if (!bytes) return bytes.errors();
  const Expected<LabelMap> map = read_label_map(*bytes);
  if (!map) return map.errors();
  Json rows = Json::array();
  for (Index i = 0; i < 3; ++i) {
    Json row = Json::array();
    for (Index k = 0; k < 4; ++k) row.push_back(map->to_lps_mm(i, k));
    rows.push_back(std::move(row));
  }
  return Json{{"size", map->size}, {"to_lps_mm", std::move(rows)}};
}

/// The files of each format in coapt.export/1.
std::map<std::string, Files> files_in(const Json& answer) {
  std::map<std::string, Files> files;
  for (const Json& entry : answer["files"])
    files[entry["format"].get<std::string>()].push_back(
        {entry["name"].get<std::string>(),
         decoded_base64(entry["base64"].get<std::string>()).value_or("")});
  return files;
}

int run(const ExportArguments& arguments, const std::optional<Service>& service) {
  AskedRequest asked = asked_repair(arguments.valve, arguments.plan, service);
  if (asked.failed) return asked.failed;
  Json formats = Json::array();
  for (const std::string& path : arguments.outputs) {
    if (const int failed = is_folder(path) ? exit_code::kOk : check_output(path)) return failed;
    formats.push_back(format_asked(path));
  }
  asked.request["formats"] = std::move(formats);
  asked.request["open"] = arguments.options.open;
  if (arguments.options.frame == ExportFrame::Valve) asked.request["frame"] = "valve";
  if (!arguments.grid.empty()) {
    const Expected<Json> grid = read_grid(arguments.grid);
    if (!grid) return report_errors(arguments.grid, grid.errors());
    asked.request["grid"] = *grid;
  }
  const Expected<Json> answer = ask_document(service, "export_files", asked.request, asked.here);
  if (!answer) return report_refusal("export", answer.errors(), asked.sources);
  const std::map<std::string, Files> files = files_in(*answer);
  for (const std::string& path : arguments.outputs) {
    const Files& of_path = files.at(format_asked(path));
    if (const int failed = is_folder(path) ? write_folder(path, of_path)
                                           : write_output(path, of_path.front().bytes))
      return failed;
  }
  Json notes = answer->value("notes", Json::array());
  if (answer->contains("doubt")) notes.insert(notes.begin(), (*answer)["doubt"]);
  for (const Json& note : notes)
    std::cerr << "coapt: export: " << printable(note.get<std::string>()) << '\n';
  return (*answer)["closure"] == "converged" ? exit_code::kOk : exit_code::kNotClosed;
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
  add_server_option(command, arguments->server);
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
  on_run_by(command, "export", arguments->server, {}, status,
            [arguments](const auto& service) { return run(*arguments, service); });
}

}  // namespace coapt
