// Sections begin with a keyword and say how much follows, so the file is a stream of words; only
// METADATA, which ends at an empty line, needs to know lines.
#include "io/mesh/vtk.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/mesh/mesh_builder.h"
#include "io/mesh/text_scan.h"
#include "io/mesh/vtk_words.h"

namespace coapt {
namespace {

constexpr std::size_t kMaxNumbers = 20'000'000;  // of a section
constexpr std::size_t kMaxLines = 100'000;

enum class Data { None, Points, Cells };

class VtkReader {
 public:
  VtkReader(std::string_view text, const MeshLimits& limits)
      : words_(text),
        mesh_(limits),
        most_(static_cast<long long>(std::min(kMaxNumbers, limits.numbers()))) {}

  Expected<VtkPolyData> read() {
    if (header()) {
      for (std::string_view keyword = words_.next(); !keyword.empty() && good_;
           keyword = words_.next())
        section(keyword);
    }
    return finish();
  }

 private:
  struct Cells {
    std::vector<long long> corners,
        offsets = {0};  ///< offsets: where each cell begins, and the end
    std::size_t count() const { return offsets.size() - 1; }
    std::vector<long long> cell(std::size_t i) const {
      return {corners.begin() + offsets[i], corners.begin() + offsets[i + 1]};
    }
  };

  bool fail(ErrorCode code, const std::string& path, const std::string& message) {
    if (good_) mesh_.add_problem(code, path, words_.line(), message);
    good_ = false;
    return false;
  }

  bool header() {
    const auto first = words_.whole_line();
    if (!first || !first->starts_with("# vtk DataFile"))
      return fail(ErrorCode::InputOutput, "",
                  "is not a legacy VTK file: it must begin with '# vtk DataFile'");
    constexpr std::string_view kVersion = "# vtk DataFile Version ";
    from_version_5_ = first->starts_with(kVersion) && first->size() > kVersion.size() &&
                      (*first)[kVersion.size()] >= '5';
    data_.title = words_.whole_line().value_or("");
    const std::string_view coding = trimmed(words_.whole_line().value_or(""));
    if (coding == "BINARY") words_.set_binary();
    if (coding != "ASCII" && coding != "BINARY")
      return fail(ErrorCode::Unsupported, "", "must say ASCII or BINARY in its third line");
    const std::string_view keyword = words_.next(), dataset = words_.next();
    if (keyword != "DATASET" || (dataset != "POLYDATA" && dataset != "UNSTRUCTURED_GRID"))
      return fail(ErrorCode::Unsupported, "",
                  "must be DATASET POLYDATA or DATASET UNSTRUCTURED_GRID");
    return true;
  }

  long long count(const char* path) {
    const auto number = to_integer(words_.next());
    if (number && *number >= 0 && *number <= most_) return *number;
    fail(ErrorCode::WrongType, path, "must be a count, 0 to " + std::to_string(most_));
    return 0;
  }

  double number(const std::string& path) {
    const std::string_view word = words_.next();
    const auto value = to_number(word);
    if (!value)
      fail(word.empty() ? ErrorCode::InputOutput : ErrorCode::WrongType, path,
           word.empty() ? "is truncated" : "must be a number");
    return value.value_or(0.0);
  }

  /// Before `numbers` of a type are read.
  bool expect(std::string_view type, long long numbers, const std::string& path) {
    if (words_.block(type, numbers)) return true;
    return fail(ErrorCode::InputOutput, path,
                "is truncated, or its type '" + std::string(type.substr(0, 20)) +
                    "' is none of VTK's numbers");
  }

  void pass_over(std::string_view type, long long numbers, const std::string& path) {
    if (!expect(type, numbers, path) || words_.skip_numbers()) return;
    for (long long i = 0; i < numbers && good_; ++i)
      if (words_.next().empty()) fail(ErrorCode::InputOutput, "", "is truncated");
  }

  void points() {
    const long long points = count("/vertices_mm");
    expect(words_.next(), 3 * points, "/vertices_mm");
    for (long long i = 0; i < points && good_ && !mesh_.full(); ++i) {
      const std::string path = "/vertices_mm/" + std::to_string(i);
      Vec3 point;
      for (double& coordinate : point) coordinate = number(path);
      if (good_) mesh_.add_vertex(point, words_.line());
    }
  }

  std::vector<long long> integers(long long length, const char* path) {
    std::vector<long long> list;
    for (long long i = 0; i < length && good_; ++i) {
      const auto value = to_integer(words_.next());
      if (!value) fail(ErrorCode::WrongType, path, "must be an integer");
      list.push_back(value.value_or(0));
    }
    return list;
  }

  /// Whether cells are given by offsets; the word that says so is then read.
  bool has_offsets() {
    if (words_.binary() && !from_version_5_) return false;
    if (words_.next() == "OFFSETS") return true;
    words_.back();
    return false;
  }

  /// Up to version 4: a count before the corners of each cell; from 5 on: all offsets, all corners.
  Cells cells(const char* path) {
    const long long first = count(path), size = count(path);
    Cells cells;
    if (has_offsets()) {
      expect(words_.next(), first, path);
      cells.offsets = integers(first, path);
      if (words_.next() != "CONNECTIVITY")
        fail(ErrorCode::WrongType, path, "must have CONNECTIVITY behind OFFSETS");
      expect(words_.next(), size, path);
      cells.corners = integers(size, path);
      bool ascending = !cells.offsets.empty() && cells.offsets.front() == 0;
      for (std::size_t i = 1; i < cells.offsets.size(); ++i)
        ascending = ascending && cells.offsets[i] >= cells.offsets[i - 1];
      if (good_ && (!ascending || cells.offsets.back() > size))
        fail(ErrorCode::BadReference, path, "must have offsets from 0 on, ascending, to its size");
    } else {
      expect("int", size, path);
      for (long long i = 0; i < first && good_; ++i) {
        const long long corners = count(path);
        const auto list = integers(corners, path);
        cells.corners.insert(cells.corners.end(), list.begin(), list.end());
        cells.offsets.push_back(std::ssize(cells.corners));
      }
    }
    if (!good_) return {};
    return cells;
  }

  void lines() {
    const Cells cells = this->cells("/lines");
    for (std::size_t i = 0; i < cells.count() && good_; ++i)
      add_line(cells.cell(i), other_cells_ + i);
    other_cells_ += cells.count();
  }

  void polygons() {
    const Cells cells = this->cells("/faces");
    for (std::size_t i = 0; i < cells.count() && !mesh_.full(); ++i)
      mesh_.add_polygon(cells.cell(i), words_.line(), static_cast<int>(polygon_cells_ + i));
    polygon_cells_ += cells.count();
  }

  void strips() {
    const Cells cells = this->cells("/faces");
    for (std::size_t i = 0; i < cells.count(); ++i)
      add_strip(cells.cell(i), static_cast<int>(polygon_cells_ + i));
    polygon_cells_ += cells.count();
  }

  /// Of an unstructured grid: cells of all kinds, numbered together.
  void cell_types() {
    const long long types = count("/cells");
    expect("int", types, "/cells");
    const std::vector<long long> type = integers(types, "/cells");
    if (good_ && type.size() != grid_.count())
      fail(ErrorCode::OutOfRange, "/cells",
           "has " + std::to_string(type.size()) + " types, must have one for each of its " +
               std::to_string(grid_.count()) + " cells");
    for (std::size_t i = 0; i < type.size() && good_ && !mesh_.full(); ++i)
      grid_cell(static_cast<int>(type[i]), grid_.cell(i), static_cast<int>(i));
  }

  /// By VTK's numbers of cell types (vtkCellType.h).
  void grid_cell(int type, const std::vector<long long>& cell, int number) {
    if (type == 3 || type == 4) return add_line(cell, static_cast<std::size_t>(number));
    if (type == 5 || type == 7 || type == 9) return mesh_.add_polygon(cell, words_.line(), number);
    if (type == 8 && cell.size() == 4)
      return mesh_.add_polygon({cell[0], cell[1], cell[3], cell[2]}, words_.line(), number);
    if (type == 6) return add_strip(cell, number);
    if (type != 1 && type != 2)
      fail(ErrorCode::Unsupported, "/cells/" + std::to_string(number),
           "has VTK's cell type " + std::to_string(type) +
               ", accepted: 1 to 9 (points, lines, triangles, quadrangles, polygons)");
  }

  void add_line(const std::vector<long long>& cell, std::size_t number) {
    for (std::size_t k = 1; k < cell.size() && good_; ++k) {
      for (const long long point : {cell[k - 1], cell[k]})
        if (point < 0 || point >= mesh_.vertices())
          fail(ErrorCode::BadReference, "/lines/" + std::to_string(number),
               "names point " + std::to_string(point) + " counted from 0, must be below " +
                   std::to_string(mesh_.vertices()));
      data_.lines.push_back({static_cast<int>(cell[k - 1]), static_cast<int>(cell[k])});
      cell_of_line_.push_back(number);
      if (data_.lines.size() > kMaxLines)
        fail(ErrorCode::OutOfRange, "/lines", "has more than the 100,000 lines accepted");
    }
  }

  void add_strip(const std::vector<long long>& strip, int number) {
    for (std::size_t k = 2; k < strip.size() && !mesh_.full(); ++k)
      mesh_.add_polygon({strip[k - 2], strip[k - 1 + k % 2], strip[k - k % 2]}, words_.line(),
                        number);
  }

  void scalars() {
    VtkScalars scalars{std::string(words_.next()), {}};
    const std::string type(words_.next());
    long long components = 1;
    std::string_view word = words_.next();
    if (word != "LOOKUP_TABLE") {
      components = to_integer(word).value_or(0);
      if (components < 1 || components > 4)
        return (void)fail(ErrorCode::OutOfRange, "/data", "must have 1 to 4 components");
      word = words_.next();
    }
    if (word == "LOOKUP_TABLE") {
      words_.next();
    } else {
      words_.back();
    }
    array(std::move(scalars), type, components);
  }

  void field() {
    words_.next();
    const long long arrays = count("/data");
    for (long long i = 0; i < arrays && good_; ++i) {
      VtkScalars scalars{std::string(words_.next()), {}};
      const long long components = count("/data"), tuples = count("/data");
      const std::string type(words_.next());
      if (scalars.name == "METADATA") return words_.skip_block();
      if (type == "string" && words_.binary())
        return (void)fail(ErrorCode::Unsupported, "/data/" + scalars.name,
                          "is text in a binary file; save the file as ASCII, or without it");
      if (type == "string" || where_ == Data::None || tuples != tuples_) {
        if (type == "string") {
          for (long long k = 0; k < tuples; ++k) (void)words_.whole_line();
        } else {
          pass_over(type, components * tuples, "/data/" + scalars.name);
        }
        continue;
      }
      array(std::move(scalars), type, components);
    }
  }

  void array(VtkScalars scalars, std::string_view type, long long components) {
    if (where_ == Data::None || components != 1)
      return pass_over(type, components * tuples_, "/data/" + scalars.name);
    expect(type, tuples_, "/data/" + scalars.name);
    for (long long i = 0; i < tuples_ && good_; ++i)
      scalars.values.push_back(number("/data/" + scalars.name));
    (where_ == Data::Cells ? cell_data_ : data_.point_data).push_back(std::move(scalars));
  }

  void section(std::string_view keyword) {
    if (keyword == "POINTS") return points();
    if (keyword == "VERTICES") {
      other_cells_ += cells("/vertices").count();
      return;
    }
    if (keyword == "LINES") return lines();
    if (keyword == "CELLS") {
      grid_ = cells("/cells");
      return;
    }
    if (keyword == "CELL_TYPES") return cell_types();
    if (keyword == "POLYGONS") return polygons();
    if (keyword == "TRIANGLE_STRIPS") return strips();
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA") {
      where_ = keyword == "POINT_DATA" ? Data::Points : Data::Cells;
      tuples_ = count("/data");
      return;
    }
    if (keyword == "SCALARS") return scalars();
    if (keyword == "FIELD") return field();
    if (keyword == "METADATA") return words_.skip_block();
    if (keyword == "NORMALS" || keyword == "VECTORS" || keyword == "TENSORS") {
      const long long components = keyword == "TENSORS" ? 9 : 3;
      words_.next();
      const std::string type(words_.next());
      return pass_over(type, components * tuples_, "/data");
    }
    if (keyword == "TEXTURE_COORDINATES" || keyword == "COLOR_SCALARS") {
      words_.next();
      const long long components = count("/data");
      const std::string type(keyword == "COLOR_SCALARS" ? "unsigned_char" : words_.next());
      return pass_over(type, components * tuples_, "/data");
    }
    if (keyword == "LOOKUP_TABLE") {
      words_.next();
      return pass_over("unsigned_char", 4 * count("/data"), "/data");
    }
    fail(ErrorCode::Unsupported, "",
         "'" + std::string(keyword.substr(0, 20)) + "' is not a section of a legacy VTK file");
  }

  Expected<VtkPolyData> finish() {
    for (const VtkScalars& cells : cell_data_) {
      VtkScalars& scalars = data_.line_data.emplace_back();
      scalars.name = cells.name;
      for (const std::size_t cell : cell_of_line_)
        scalars.values.push_back(cell < cells.values.size() ? cells.values[cell] : 0.0);
    }
    if (good_ && mesh_.faces() == 0 && !data_.lines.empty()) {
      Expected<Points> points = std::move(mesh_).take_points();
      if (!points) return points.errors();
      data_.points_mm = *std::move(points);
      data_.faces.resize(0, 3);
      return std::move(data_);
    }
    Expected<TriangleMesh> mesh = std::move(mesh_).take();
    if (!mesh) return mesh.errors();
    data_.points_mm = std::move(mesh->vertices_mm);
    data_.faces = std::move(mesh->faces);
    for (const VtkScalars& cells : cell_data_) {
      VtkScalars& scalars = data_.face_data.emplace_back();
      scalars.name = cells.name;
      for (const int polygon : mesh->polygons) {
        const std::size_t cell = other_cells_ + static_cast<std::size_t>(polygon);
        scalars.values.push_back(cell < cells.values.size() ? cells.values[cell] : 0.0);
      }
    }
    return std::move(data_);
  }

  VtkWords words_;
  MeshBuilder mesh_;
  const long long most_;  ///< numbers of a section
  VtkPolyData data_;
  std::vector<std::size_t> cell_of_line_;
  std::size_t other_cells_ = 0;  ///< before the next section of cells
  std::size_t polygon_cells_ =
      0;        ///< polygons and strips; their data stand behind those of the others
  Cells grid_;  ///< of an unstructured grid, until their types are known
  std::vector<VtkScalars> cell_data_;
  Data where_ = Data::None;
  long long tuples_ = 0;
  bool from_version_5_ = false;
  bool good_ = true;
};

}  // namespace

Expected<VtkPolyData> read_vtk(std::string_view text, const MeshLimits& limits) {
  return VtkReader(text, limits).read();
}

}  // namespace coapt
