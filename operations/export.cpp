// Writes a closed valve, repaired if there is a plan, as a file that other programs open, or as several: coapt.export/1.
#include "operations/export.h"

#include <algorithm>

#include "core/closure/standing.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/exchange/valve_labels.h"
#include "io/image/image_geometry.h"
#include "io/json/version.h"
#include "operations/repair_request.h"
#include "operations/table.h"
#include "operations/voxel_grid.h"

namespace coapt {
namespace {

constexpr const char* kFolder = "slicerheart";  // several files: exported_folder()

std::vector<std::string> known_formats() {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) names.push_back(format.name);
  return names;
}

const FileFormat* read_format(const JsonPlace& place) {
  const auto choice = read_choice(place, known_formats());
  return choice ? &file_formats()[*choice] : nullptr;
}

/// Each once.
std::vector<std::string> read_formats(const JsonPlace& place) {
  std::vector<std::string> known = known_formats();
  known.emplace_back(kFolder);
  std::vector<std::string> formats;
  read_array(place, [&](const JsonPlace& entry) {
    const auto choice = read_choice(entry, known);
    if (choice && std::find(formats.begin(), formats.end(), known[*choice]) == formats.end())
      formats.push_back(known[*choice]);
  });
  if (formats.empty()) add_problem(place, ErrorCode::MissingField, "must name a format");
  return formats;
}

ExportFrame read_frame(const JsonPlace& place) {
  return read_choice(place, {"patient", "valve"}).value_or(0) == 0 ? ExportFrame::Patient
                                                                   : ExportFrame::Valve;
}

// 320 x 320 x 320 voxels take 0.8 s of a core.
constexpr double kOfAVoxel_s = 25e-9;

struct ExportRequest {
  RepairRequest repair{};
  const FileFormat* format = nullptr;  ///< of the one file that is answered; else:
  std::vector<std::string> formats{};  ///< of the files in the document that is answered
  ExportOptions options{};

  std::vector<const FileFormat*> files() const {
    if (format != nullptr) return {format};
    std::vector<const FileFormat*> named;
    for (const std::string& name : formats)
      if (name != kFolder) named.push_back(format_named(name));
    return named;
  }
};

/// A label map has its voxels before they are compressed, each format anew.
Errors check_voxels(const ExportRequest& asked, const OperationLimits& limits) {
  if (!asked.options.grid) return {};
  const std::vector<const FileFormat*> files = asked.files();
  const auto maps = std::count_if(files.begin(), files.end(),
                                  [](const FileFormat* file) { return file->is_label_map; });
  const double voxels = asked.options.grid->voxels();
  if (static_cast<double>(maps) * voxels <= static_cast<double>(limits.voxels)) return {};
  return {Error{ErrorCode::OutOfRange, "/grid",
                "has " + with_decimals(voxels, 0) + " voxels for each of " + std::to_string(maps) +
                    " label maps, but this service accepts at most " +
                    std::to_string(limits.voxels) +
                    " of all of them; request one format at a time, or a coarser grid"}};
}

ExportOptions within(ExportOptions options, const Context& context) {
  options.cancelled = [&context] { return context.cancelled(); };
  return options;
}

/// What a user should know of files in these formats, a sentence each.
Json notes_on(const ClosedValve& exported, const ExportRequest& asked) {
  Json notes = Json::array();
  double shift_mm = 0.0;
  for (const std::string& format : asked.formats) {
    if (format != "vtk" && format != "feb" && format != kFolder) continue;
    const bool open = asked.options.open || format == "feb";
    shift_mm = std::max(shift_mm,
                        attachment_shift_mm(exported.valve, open ? unstressed_shape(exported.valve)
                                                                 : closed_shape(exported)));
  }
  if (shift_mm >= 0.001)
    notes.push_back("chordae end at the nearest vertices of the mesh in .vtk and .feb, at most " +
                    with_decimals(shift_mm, 2) + " mm from their insertions");
  for (const std::string& format : asked.formats)
    if (!exported.valve.ties.empty() && format != kFolder && format_named(format)->loses_ties)
      notes.push_back("." + format +
                      " files do not store the edge-to-edge repair; a valve imported from one "
                      "lacks it");
  return notes;
}

Errors refused(const Errors& errors, const Context& context) {
  return errors.front().code == ErrorCode::Busy ? Errors{context.refusal()} : errors;
}

/// The files of all formats, as one document.
Expected<OperationAnswer> exported_files(const ClosedValve& exported, const ExportRequest& asked,
                                         const Context& context) {
  const ExportOptions options = within(asked.options, context);
  Json files = Json::array();
  const auto add = [&](const std::string& format, const NamedFile& file) {
    Json entry = {{"format", format}};
    entry.update(to_json(file));
    files.push_back(std::move(entry));
  };
  for (const std::string& format : asked.formats) {
    if (context.cancelled()) return context.refusal();
    if (format == kFolder) {
      const auto folder = write_slicerheart(exported, options);
      if (!folder) return folder.errors();
      for (const NamedFile& file : *folder) add(format, file);
      continue;
    }
    Expected<AnswerFile> file = exported_file(exported, *format_named(format), options);
    if (!file) return refused(file.errors(), context);
    add(format, {file->name, std::move(file->bytes)});
  }
  Json answer = result_document("coapt.export/1", {{"closure", closure_name(exported.closure)},
                                                   {"notes", notes_on(exported, asked)},
                                                   {"files", std::move(files)}});
  if (const std::string doubt = doubt_about(exported.closure); !doubt.empty())
    answer["doubt"] = doubt;
  return OperationAnswer(std::move(answer));
}

Expected<ClosedValve> closed_of(const ExportRequest& asked, Context& context) {
  const auto& [before, plan, repaired, material] = asked.repair;
  Expected<ClosedValve> closed = context.close(repaired, {.motion = true});
  if (!closed) return closed.errors();
  return with_repair(*std::move(closed), before, plan);
}

Expected<OperationAnswer> write_export(const ExportRequest& asked, Context& context) {
  const Expected<ClosedValve> closed = closed_of(asked, context);
  if (!closed) return closed.errors();
  Expected<AnswerFile> file = exported_file(*closed, *asked.format, within(asked.options, context));
  if (!file) return refused(file.errors(), context);
  return OperationAnswer(*std::move(file));
}

Expected<OperationAnswer> write_files(const ExportRequest& asked, Context& context) {
  const Expected<ClosedValve> closed = closed_of(asked, context);
  if (!closed) return closed.errors();
  return exported_files(*closed, asked, context);
}

template <class Run>
Expected<OperationTask> read_asked(const Json& request, const Context& context,
                                   const std::shared_ptr<ExportRequest>& asked, JsonField formats,
                                   Run run) {
  if (Errors errors =
          read_repair(request, context,
                      {std::move(formats),
                       {"open", into(asked->options.open, read_boolean), false},
                       {"frame", into(asked->options.frame, read_frame), false},
                       {"grid", into(asked->options.grid, grid_in(kMostLabelVoxels)), false}},
                      asked->repair);
      !errors.empty())
    return errors;
  if (Errors errors = check_voxels(*asked, context.limits); !errors.empty()) return errors;
  OperationTask task = task_of(asked, 1, run);
  for (const FileFormat* file : asked->files())
    task.seconds += writing_seconds(*file, asked->repair.repaired.rest_mm, asked->options);
  return task;
}

}  // namespace

Expected<AnswerFile> exported_file(const ClosedValve& exported, const FileFormat& format,
                                   const ExportOptions& options) {
  Expected<std::string> bytes = write_valve_file(exported, format, options);
  if (!bytes) return bytes.errors();
  return AnswerFile{format.media_type, *std::move(bytes), std::string("valve.") + format.name,
                    closure_name(exported.closure)};
}

double writing_seconds(const FileFormat& format, const Points& vertices_mm,
                       const ExportOptions& options) {
  if (!format.is_label_map) return 0.0;
  return kOfAVoxel_s * (options.grid ? *options.grid : label_grid_about(vertices_mm)).voxels();
}

Expected<OperationTask> read_export(const Json& request, const Context& context) {
  const auto asked = std::make_shared<ExportRequest>();
  return read_asked(request, context, asked, {"format", into(asked->format, read_format)},
                    write_export);
}

Expected<OperationTask> read_export_files(const Json& request, const Context& context) {
  const auto asked = std::make_shared<ExportRequest>();
  return read_asked(request, context, asked, {"formats", into(asked->formats, read_formats)},
                    write_files);
}

}  // namespace coapt
