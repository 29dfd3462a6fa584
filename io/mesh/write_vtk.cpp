#include "io/mesh/write_vtk.h"

#include <algorithm>

#include "io/mesh/mesh_text.h"

namespace coapt {
namespace {

void append_scalars(std::string& text, const VtkScalars& scalars) {
  text += "SCALARS " + scalars.name + (scalars.integers ? " int 1\n" : " double 1\n") +
          "LOOKUP_TABLE default\n";
  for (const double value : scalars.values) {
    append_number(text, value, kExchangeDigits);
    text += '\n';
  }
}

/// What stands where an array says nothing: of integers, which are labels, none.
double nothing(const VtkScalars& scalars) { return scalars.integers ? -1.0 : 0.0; }

/// Those of the lines, then those of the faces, each filled up.
std::vector<VtkScalars> cell_data(const VtkPolyData& data) {
  const std::size_t lines = data.lines.size(), faces = static_cast<std::size_t>(data.faces.rows());
  std::vector<VtkScalars> cells = data.line_data;
  for (VtkScalars& scalars : cells) scalars.values.resize(lines + faces, nothing(scalars));
  for (const VtkScalars& scalars : data.face_data) {
    const auto same = std::find_if(cells.begin(), cells.end(),
                                   [&](const VtkScalars& s) { return s.name == scalars.name; });
    if (same == cells.end()) {
      cells.push_back(scalars);
      cells.back().values.insert(cells.back().values.begin(), lines, nothing(scalars));
    } else {
      std::copy(scalars.values.begin(), scalars.values.end(),
                same->values.begin() + static_cast<std::ptrdiff_t>(lines));
    }
  }
  return cells;
}

}  // namespace

std::string write_vtk(const VtkPolyData& data) {
  std::string text = "# vtk DataFile Version 4.2\n" + data.title +
                     "\nASCII\nDATASET POLYDATA\nPOINTS " + std::to_string(data.points_mm.rows()) +
                     " double\n";
  append_points(text, data.points_mm, "", kExchangeDigits);
  if (!data.lines.empty()) {
    // FEBio Studio looks for the counts from the ninth character on, as it does behind POLYGONS.
    text += "LINES   " + std::to_string(data.lines.size()) + ' ' +
            std::to_string(3 * data.lines.size()) + '\n';
    for (const auto& [start, end] : data.lines)
      text += "2 " + std::to_string(start) + ' ' + std::to_string(end) + '\n';
  }
  if (data.faces.rows() > 0) {
    text += "POLYGONS " + std::to_string(data.faces.rows()) + ' ' +
            std::to_string(4 * data.faces.rows()) + '\n';
    append_faces(text, data.faces, "3 ", 0);
  }
  const std::vector<VtkScalars> cells = cell_data(data);
  if (!cells.empty())
    text += "CELL_DATA " +
            std::to_string(data.lines.size() + static_cast<std::size_t>(data.faces.rows())) + '\n';
  for (const VtkScalars& scalars : cells) append_scalars(text, scalars);
  if (!data.point_data.empty())
    text += "POINT_DATA " + std::to_string(data.points_mm.rows()) + '\n';
  for (const VtkScalars& scalars : data.point_data) append_scalars(text, scalars);
  return text;
}

}  // namespace coapt
