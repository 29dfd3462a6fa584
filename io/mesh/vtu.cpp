#include "io/mesh/vtu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "io/mesh/mesh_builder.h"
#include "io/mesh/text_scan.h"
#include "io/mesh/vtk_xml.h"

namespace coapt {
namespace {

/// VTK's numbers of cell types (vtkCellType.h).
enum CellType {
  kVertex = 1,
  kPolyVertex,
  kLine,
  kPolyLine,
  kTriangle,
  kStrip,
  kPolygon,
  kPixel,
  kQuad
};

constexpr std::array<std::string_view, 9> kSections = {
    "Points", "Cells", "Verts", "Lines", "Polys", "Strips", "PointData", "CellData", "FieldData"};

/// The arrays of a file by the section they stand in.
struct Sections {
  std::map<std::string, std::vector<const XmlElement*>, std::less<>> arrays;
  int pieces = 0;
};

Sections sections_of(const VtkXml& file) {
  Sections sections;
  std::string section;
  for (const XmlElement& element : file.elements) {
    if (element.name == "Piece") ++sections.pieces;
    if (element.name == "DataArray" && !section.empty()) {
      sections.arrays[section].push_back(&element);
    } else if (std::find(kSections.begin(), kSections.end(), element.name) != kSections.end()) {
      section = element.name;
    } else if (element.name == '/' + section) {
      section.clear();
    }
  }
  return sections;
}

const XmlElement* named(const std::vector<const XmlElement*>& arrays, std::string_view name) {
  for (const XmlElement* array : arrays)
    if (array->attribute("Name") == name) return array;
  return nullptr;
}

/// A cell's corners as polygons, all with its own number.
void add_cell(int type, const std::vector<long long>& corners, MeshBuilder& mesh, int cell) {
  switch (type) {
    case kTriangle:
    case kPolygon:
    case kQuad:
      return mesh.add_polygon(corners, 0, cell);
    case kPixel:
      if (corners.size() == 4)
        return mesh.add_polygon({corners[0], corners[1], corners[3], corners[2]}, 0, cell);
      return mesh.add_polygon({}, 0, cell);
    case kStrip:
      for (std::size_t k = 2; k < corners.size() && !mesh.full(); ++k)
        mesh.add_polygon({corners[k - 2], corners[k - 1 + k % 2], corners[k - k % 2]}, 0, cell);
      return;
    case kVertex:
    case kPolyVertex:
    case kLine:
    case kPolyLine:
      return;
    default:
      mesh.add_problem(ErrorCode::Unsupported, "/cells/" + std::to_string(cell), 0,
                       "has VTK's cell type " + std::to_string(type) +
                           ", accepted: 1 to 9 (points, lines, triangles, quadrangles, polygons)");
  }
}

class VtuReader {
 public:
  VtuReader(const VtkXml& file, bool is_grid, WantedArrays wanted, std::size_t most_unpacked,
            const MeshLimits& limits = {})
      : file_(file),
        sections_(sections_of(file)),
        wanted_(std::move(wanted)),
        budget_{most_unpacked},
        limits_(limits),
        is_grid_(is_grid) {}

  Expected<VtuGrid> read() {
    if (const auto wrong = wrong_pieces()) return *wrong;
    MeshBuilder mesh(limits_);
    const std::vector<const XmlElement*>& points = sections_.arrays["Points"];
    add_points(numbers(points.empty() ? nullptr : points.front(), "/vertices_mm"), mesh);
    if (is_grid_)
      add_section("Cells", std::nullopt, mesh);
    else
      for (const auto& [section, type] : {std::pair{"Verts", kPolyVertex},
                                          {"Lines", kPolyLine},
                                          {"Polys", kPolygon},
                                          {"Strips", kStrip}})
        if (!sections_.arrays[section].empty()) add_section(section, type, mesh);
    VtuGrid grid;
    grid.point_data = data("PointData", "/point_data/");
    grid.cell_data = data("CellData", "/cell_data/");
    if (!errors_.empty()) return errors_;
    Expected<TriangleMesh> taken = std::move(mesh).take();
    if (!taken) return taken.errors();
    grid.mesh = *std::move(taken);
    check_lengths(grid.point_data, static_cast<std::size_t>(grid.mesh.vertices_mm.rows()),
                  "/point_data/");
    check_lengths(grid.cell_data, cells_, "/cell_data/");
    if (!errors_.empty()) return errors_;
    return grid;
  }

  Expected<VtpLines> read_lines() {
    if (const auto wrong = wrong_pieces()) return *wrong;
    MeshBuilder mesh;
    const std::vector<const XmlElement*>& points = sections_.arrays["Points"];
    add_points(numbers(points.empty() ? nullptr : points.front(), "/vertices_mm"), mesh);
    VtpLines lines;
    if (!sections_.arrays["Lines"].empty()) add_pieces(lines.pieces);
    if (!errors_.empty()) return errors_;
    Expected<Points> taken = std::move(mesh).take_points();
    if (!taken) return taken.errors();
    lines.points_mm = *std::move(taken);
    for (const std::array<int, 2>& piece : lines.pieces)
      if (piece[0] < 0 || piece[1] < 0 || piece[0] >= lines.points_mm.rows() ||
          piece[1] >= lines.points_mm.rows())
        return Error{ErrorCode::BadReference, "/lines",
                     "refer to points that do not exist; point numbers must be below " +
                         std::to_string(lines.points_mm.rows())};
    return lines;
  }

 private:
  std::optional<Error> wrong_pieces() const {
    if (sections_.pieces == 1) return {};
    return Error{ErrorCode::Unsupported, "",
                 "has " + std::to_string(sections_.pieces) + " pieces, must have 1"};
  }

  void add_pieces(std::vector<std::array<int, 2>>& pieces) {
    const auto& cells = sections_.arrays["Lines"];
    const std::vector<double> points = numbers(named(cells, "connectivity"), "/lines/connectivity"),
                              ends = numbers(named(cells, "offsets"), "/lines/offsets");
    const auto point_at = [&](std::size_t k) {
      return std::abs(points[k]) < 1e9 ? static_cast<int>(points[k]) : -1;
    };
    double begin = 0.0;
    for (const double end : ends) {
      if (!(end >= begin && end <= static_cast<double>(points.size())))
        return fail(ErrorCode::BadReference, "/lines/offsets",
                    "must ascend to at most " + std::to_string(points.size()));
      for (auto k = static_cast<std::size_t>(begin) + 1; k < static_cast<std::size_t>(end); ++k)
        pieces.push_back({point_at(k - 1), point_at(k)});
      begin = end;
    }
  }

  void fail(ErrorCode code, const std::string& path, const std::string& message) {
    errors_.push_back({code, path, message});
  }

  /// After the first array that cannot be read no other is unpacked.
  std::vector<double> numbers(const XmlElement* array, const std::string& path) {
    if (array == nullptr) {
      fail(ErrorCode::MissingField, path, "is missing");
      return {};
    }
    if (!errors_.empty()) return {};
    Expected<std::vector<double>> list = read_data_array(file_, *array, path, budget_);
    if (list) return *std::move(list);
    errors_.insert(errors_.end(), list.errors().begin(), list.errors().end());
    return {};
  }

  void add_points(const std::vector<double>& list, MeshBuilder& mesh) {
    if (list.size() % 3 != 0)
      return fail(ErrorCode::OutOfRange, "/vertices_mm", "must have three numbers a point");
    for (std::size_t i = 0; i + 2 < list.size() && !mesh.full(); i += 3)
      mesh.add_vertex({list[i], list[i + 1], list[i + 2]}, 0);
  }

  /// Cells of one type, or of those that the section says.
  void add_section(const std::string& section, std::optional<CellType> type, MeshBuilder& mesh) {
    const auto& cells = sections_.arrays[section];
    const std::vector<double> corners =
                                  numbers(named(cells, "connectivity"), "/cells/connectivity"),
                              ends = numbers(named(cells, "offsets"), "/cells/offsets");
    add_cells(corners, ends,
              type ? std::vector<double>(ends.size(), *type)
                   : numbers(named(cells, "types"), "/cells/types"),
              mesh);
  }

  void add_cells(const std::vector<double>& corners, const std::vector<double>& ends,
                 const std::vector<double>& types, MeshBuilder& mesh) {
    if (!errors_.empty()) return;
    const auto first = static_cast<int>(cells_);
    cells_ += ends.size();
    if (types.size() != ends.size())
      return fail(ErrorCode::OutOfRange, "/cells/types", "must have one number a cell");
    double begin = 0.0;
    for (std::size_t i = 0; i < ends.size() && !mesh.full(); ++i) {
      if (!(ends[i] >= begin && ends[i] <= static_cast<double>(corners.size())))
        return fail(ErrorCode::BadReference, "/cells/offsets",
                    "must ascend to at most " + std::to_string(corners.size()));
      std::vector<long long> cell;
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(ends[i]); ++k)
        cell.push_back(std::abs(corners[k]) < 1e15 ? static_cast<long long>(corners[k]) : -1);
      add_cell(static_cast<int>(types[i]), cell, mesh, first + static_cast<int>(i));
      begin = ends[i];
    }
  }

  std::vector<VtuArray> data(const std::string& section, const std::string& path) {
    std::vector<VtuArray> list;
    std::set<std::string> names;
    for (const XmlElement* array : sections_.arrays[section]) {
      if (array->attribute("type") == "String") continue;
      const std::string name = array->attribute("Name");
      if (!names.insert(name).second) continue;
      const auto components = to_integer(array->attribute("NumberOfComponents"));
      if (components && (*components < 1 || *components > 100)) {
        fail(ErrorCode::OutOfRange, path + name, "must have 1 to 100 components");
        continue;
      }
      list.push_back({name, static_cast<int>(components.value_or(1)), {}});
      if (wanted_(name)) list.back().values = numbers(array, path + name);
    }
    return list;
  }

  void check_lengths(const std::vector<VtuArray>& arrays, std::size_t rows,
                     const std::string& path) {
    for (const VtuArray& array : arrays)
      if (wanted_(array.name) &&
          array.values.size() != rows * static_cast<std::size_t>(array.components))
        fail(ErrorCode::OutOfRange, path + array.name,
             "has " + std::to_string(array.values.size()) + " numbers, must have " +
                 std::to_string(array.components) + " for each of " + std::to_string(rows));
  }

  const VtkXml& file_;
  Sections sections_;
  Errors errors_;
  WantedArrays wanted_;
  UnpackBudget budget_;
  const MeshLimits limits_;
  std::size_t cells_ = 0;
  bool is_grid_;
};

}  // namespace

Expected<VtuGrid> read_vtu(std::string_view bytes, const WantedArrays& wanted,
                           std::size_t most_unpacked, const MeshLimits& limits) {
  const Expected<VtkXml> file = read_vtk_xml(bytes, "UnstructuredGrid");
  if (!file) return file.errors();
  return VtuReader(*file, true, wanted, most_unpacked, limits).read();
}

Expected<VtuGrid> read_vtp(std::string_view bytes, const WantedArrays& wanted,
                           std::size_t most_unpacked, const MeshLimits& limits) {
  const Expected<VtkXml> file = read_vtk_xml(bytes, "PolyData");
  if (!file) return file.errors();
  return VtuReader(*file, false, wanted, most_unpacked, limits).read();
}

Expected<VtpLines> read_vtp_lines(std::string_view bytes, std::size_t most_unpacked) {
  const Expected<VtkXml> file = read_vtk_xml(bytes, "PolyData");
  if (!file) return file.errors();
  return VtuReader(*file, false, no_array, most_unpacked).read_lines();
}

}  // namespace coapt
