#include "operations/voxel_grid.h"

#include <algorithm>

namespace coapt {
namespace {

ImageGeometry read_grid(const JsonPlace& place, Index most_voxels) {
  ImageGeometry grid;
  const auto size_of = [&](const JsonPlace& size) {
    return read_list(size, integer_in(1, static_cast<int>(most_voxels)));
  };
  const auto row_of = [](const JsonPlace& row) { return read_list(row, read_number); };
  const auto rows_of = [&](const JsonPlace& rows) { return read_list(rows, row_of); };
  std::vector<int> size;
  std::vector<std::vector<double>> rows;
  read_fields(place, {{"size", into(size, size_of)}, {"to_lps_mm", into(rows, rows_of)}});
  Index voxels = 1;
  for (const int along : size) voxels *= std::min<Index>(along, most_voxels / voxels + 1);
  if (size.size() != 3 || voxels > most_voxels)
    add_problem(
        place, ErrorCode::OutOfRange,
        "must have a size of three numbers and at most " + std::to_string(most_voxels) + " voxels");
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

}  // namespace

std::function<ImageGeometry(const JsonPlace&)> grid_in(Index most_voxels) {
  return [most_voxels](const JsonPlace& place) { return read_grid(place, most_voxels); };
}

}  // namespace coapt
