// Writes a closed valve, repaired if there is a plan, as a file that other programs open.
#include "operations/export.h"

#include <algorithm>

#include "core/valve/problem_list.h"
#include "io/image/image_geometry.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

const FileFormat* read_format(const JsonPlace& place) {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) names.push_back(format.name);
  const auto choice = read_choice(place, names);
  return choice ? &file_formats()[*choice] : nullptr;
}

ExportFrame read_frame(const JsonPlace& place) {
  return read_choice(place, {"patient", "valve"}).value_or(0) == 0 ? ExportFrame::Patient
                                                                   : ExportFrame::Valve;
}

/// At most as many voxels as a CT of 512 x 512 x 128.
constexpr int kMostGridVoxels = 1 << 25;

/// The voxels of a label map: how many along i, j and k, and the affine map of (i, j, k, 1) to LPS in mm.
ImageGeometry read_grid(const JsonPlace& place) {
  ImageGeometry grid;
  const auto size_of = [](const JsonPlace& size) {
    return read_list(size,
                     [](const JsonPlace& n) { return read_integer_in(n, 1, kMostGridVoxels); });
  };
  const auto row_of = [](const JsonPlace& row) { return read_list(row, read_number); };
  const auto rows_of = [&](const JsonPlace& rows) { return read_list(rows, row_of); };
  std::vector<int> size;
  std::vector<std::vector<double>> rows;
  read_fields(place, {{"size", into(size, size_of)}, {"to_lps_mm", into(rows, rows_of)}});
  Index voxels = 1;
  for (const int along : size) voxels *= std::min<Index>(along, kMostGridVoxels / voxels + 1);
  if (size.size() != 3 || voxels > kMostGridVoxels)
    add_problem(place, ErrorCode::OutOfRange,
                "must have a size of three numbers and at most 33,554,432 voxels");
  const auto has_four = [](const std::vector<double>& row) { return row.size() == 4; };
  if (rows.size() != 3 || !std::all_of(rows.begin(), rows.end(), has_four)) {
    add_problem(place, ErrorCode::OutOfRange,
                "must have a to_lps_mm of three rows of four numbers");
    return grid;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (i < size.size()) grid.size[i] = size[i];
    for (std::size_t k = 0; k < 4; ++k)
      grid.to_lps_mm(static_cast<Index>(i), static_cast<Index>(k)) = rows[i][k];
  }
  grid.placed = true;
  ProblemList steps;
  check_voxel_steps(grid.to_lps_mm, "", steps);
  for (const Error& error : std::move(steps).take())
    add_problem(place, error.code, "to_lps_mm: " + error.message);
  return grid;
}

struct ExportRequest {
  RepairRequest repair{};
  const FileFormat* format = nullptr;
  ExportOptions options{};
};

Expected<OperationAnswer> write_export(const ExportRequest& asked, Context& context) {
  const auto& [before, plan, repaired, material] = asked.repair;
  const Expected<ClosedValve> closed = context.close(repaired, {.motion = true});
  if (!closed) return closed.errors();
  Expected<AnswerFile> file =
      exported_file(with_repair(*closed, before, plan), *asked.format, asked.options);
  if (!file) return file.errors();
  return OperationAnswer(*std::move(file));
}

}  // namespace

std::string closure_name(const ClosureResult& closure) {
  return closure.crossing ? "crossing" : to_string(closure.status);
}

Expected<AnswerFile> exported_file(const ClosedValve& exported, const FileFormat& format,
                                   const ExportOptions& options) {
  Expected<std::string> bytes = write_valve_file(exported, format, options);
  if (!bytes) return bytes.errors();
  return AnswerFile{format.media_type, *std::move(bytes), std::string("valve.") + format.name,
                    closure_name(exported.closure)};
}

Expected<OperationTask> read_export(const Json& request, const Context& context) {
  const auto asked = std::make_shared<ExportRequest>();
  if (Errors errors = read_repair(request, context,
                                  {{"format", into(asked->format, read_format)},
                                   {"open", into(asked->options.open, read_boolean), false},
                                   {"frame", into(asked->options.frame, read_frame), false},
                                   {"grid", into(asked->options.grid, read_grid), false}},
                                  asked->repair);
      !errors.empty())
    return errors;
  return task_of(asked, 1, write_export);
}

}  // namespace coapt
