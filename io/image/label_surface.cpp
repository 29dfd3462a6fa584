#include "io/image/label_surface.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

#include "core/valve/vertex_normals.h"
#include "io/image/label_voxels.h"

namespace coapt {
namespace {

constexpr Index kMostTriangles = 1'000'000;  // as an import takes (io/mesh/import_frame.cpp)
// Taubin's pass-band filter: one pass shrinks, the next one grows; 0.1 is passed, of a mesh's highest frequency 2.
constexpr double kShrink = 0.5, kGrow = -0.526;
constexpr int kSmoothings = 12;
constexpr int kVolumeSteps = 3;
constexpr double kLongestStep =
    0.25;  // of a voxel's shortest edge: specks that were smoothed away shall not burst

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2). Edge 4a + e leads along axis a.
constexpr std::array<std::array<int, 2>, 12> kEdges = {{{0, 1},
                                                        {2, 3},
                                                        {4, 5},
                                                        {6, 7},
                                                        {0, 2},
                                                        {1, 3},
                                                        {4, 6},
                                                        {5, 7},
                                                        {0, 4},
                                                        {1, 5},
                                                        {2, 6},
                                                        {3, 7}}};
/// Face 2a + s is at side s of axis a; its corners, round.
constexpr std::array<std::array<int, 4>, 6> kFaceCorners = {
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

int edge_between(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if (kEdges[static_cast<std::size_t>(e)] == std::array{std::min(a, b), std::max(a, b)}) return e;
  return -1;
}

/// The edge behind each corner of a face, to the next one.
std::array<std::array<int, 4>, 6> face_edges() {
  std::array<std::array<int, 4>, 6> edges{};
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t k = 0; k < 4; ++k)
      edges[f][k] = edge_between(kFaceCorners[f][k], kFaceCorners[f][(k + 1) % 4]);
  return edges;
}

/// Eight voxel centres, not all of one kind.
struct Cell {
  Voxel at;          ///< its corner 0
  unsigned inside;   ///< bit c: corner c is of the label
  unsigned apart;    ///< bit f: on face f voxels of the label that touch at an edge are apart
  int first_vertex;  ///< of the mesh; the others follow
  int sheets;        ///< how often the surface passes
  std::array<int, 12> sheet;  ///< of each edge that it cuts, else -1

  bool has(int corner) const { return (inside >> corner & 1U) != 0; }
  /// Two voxels of the label and two that are not, crosswise.
  bool crosswise(std::size_t face) const {
    const auto& c = kFaceCorners[face];
    return has(c[0]) == has(c[2]) && has(c[1]) == has(c[3]) && has(c[0]) != has(c[1]);
  }
};

/// Which edges lie on one sheet: on each face cut edges are linked in pairs.
void find_sheets(Cell& cell) {
  static const auto kFaceEdges = face_edges();
  std::array<int, 12> group;
  for (int e = 0; e < 12; ++e) {
    const auto& [a, b] = kEdges[static_cast<std::size_t>(e)];
    group[static_cast<std::size_t>(e)] = cell.has(a) != cell.has(b) ? e : -1;
  }
  const auto link = [&](int e, int other) {
    const int kept = group[static_cast<std::size_t>(e)],
              gone = group[static_cast<std::size_t>(other)];
    std::replace(group.begin(), group.end(), gone, kept);
  };
  for (std::size_t f = 0; f < 6; ++f) {
    const auto& edges = kFaceEdges[f];
    if (cell.crosswise(f)) {  // the two edges at a corner, which is cut off
      const bool cut_off = (cell.apart >> f & 1U) != 0;
      for (std::size_t k = 0; k < 4; ++k)
        if (cell.has(kFaceCorners[f][k]) == cut_off) link(edges[(k + 3) % 4], edges[k]);
      continue;
    }
    int first = -1;
    for (const int e : edges) {
      if (group[static_cast<std::size_t>(e)] < 0) continue;
      if (first >= 0) link(first, e);
      first = e;
    }
  }
  std::array<int, 12> number;
  number.fill(-1);
  cell.sheets = 0;
  for (std::size_t e = 0; e < 12; ++e) {
    cell.sheet[e] = -1;
    if (group[e] < 0) continue;
    int& known = number[static_cast<std::size_t>(group[e])];
    if (known < 0) known = cell.sheets++;
    cell.sheet[e] = known;
  }
}

class SurfaceNet {
 public:
  SurfaceNet(const LabelVoxels& voxels, const LabelBox& box) : box_(box) {
    for (Index k = box.min[2] - 1; k <= box.max[2]; ++k)
      for (Index j = box.min[1] - 1; j <= box.max[1]; ++j)
        for (Index i = box.min[0] - 1; i <= box.max[0]; ++i) add_cell(voxels, {i, j, k});
    take_contacts_apart();
  }

  /// Vertices in voxels.
  TriangleMesh mesh() {
    int vertices = 0;
    for (Cell& cell : cells_) {
      cell.first_vertex = vertices;
      vertices += cell.sheets;
    }
    TriangleMesh mesh;
    mesh.vertices_mm.resize(vertices, 3);
    for (const Cell& cell : cells_) place(cell, mesh.vertices_mm);
    std::vector<std::array<int, 3>> triangles;
    for (const Cell& cell : cells_)
      for (int axis = 0; axis < 3; ++axis) add_square(cell, axis, triangles);
    mesh.faces.resize(std::ssize(triangles), 3);
    for (std::size_t f = 0; f < triangles.size(); ++f)
      mesh.faces.row(static_cast<Index>(f)) << triangles[f][0], triangles[f][1], triangles[f][2];
    return mesh;
  }

 private:
  void add_cell(const LabelVoxels& voxels, const Voxel& at) {
    Cell cell{at, 0, 0, 0, 0, {}};
    for (int c = 0; c < 8; ++c)
      if (voxels(at[0] + (c & 1), at[1] + (c >> 1 & 1), at[2] + (c >> 2))) cell.inside |= 1U << c;
    if (cell.inside == 0 || cell.inside == 255) return;
    find_sheets(cell);
    number_[key(at)] = cells_.size();
    cells_.push_back(cell);
  }

  std::uint64_t key(const Voxel& at) const {
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      key = key << 21 | static_cast<std::uint64_t>(at[axis] - box_.min[axis] + 1);
    return key;
  }

  Cell& cell_at(const Voxel& at) { return cells_[number_.at(key(at))]; }

  static Voxel beside(Voxel at, int axis, Index steps) {
    at[static_cast<std::size_t>(axis)] += steps;
    return at;
  }

  /// Whether on a crosswise face both parts of the surface are of one sheet of the cell.
  static bool meets_itself(const Cell& cell, std::size_t face) {
    static const auto kFaceEdges = face_edges();
    const int sheet = cell.sheet[static_cast<std::size_t>(kFaceEdges[face][0])];
    return std::all_of(kFaceEdges[face].begin(), kFaceEdges[face].end(),
                       [&](int e) { return cell.sheet[static_cast<std::size_t>(e)] == sheet; });
  }

  /// Two sheets that share two edges of the mesh between the same vertices would make one edge of four triangles.
  void take_contacts_apart() {
    for (Cell& cell : cells_) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto face = static_cast<std::size_t>(2 * axis + 1);
        if (!cell.crosswise(face) || !meets_itself(cell, face)) continue;
        Cell& other = cell_at(beside(cell.at, axis, 1));
        if (!meets_itself(other, face - 1)) continue;
        cell.apart |= 1U << face;
        other.apart |= 1U << (face - 1);
        find_sheets(cell);
        find_sheets(other);
      }
    }
  }

  static void place(const Cell& cell, Points& vertices) {
    std::array<Vec3, 4> sum;
    sum.fill(Vec3::Zero());
    std::array<int, 4> count{};
    for (std::size_t e = 0; e < 12; ++e) {
      if (cell.sheet[e] < 0) continue;
      const auto sheet = static_cast<std::size_t>(cell.sheet[e]);
      for (const int c : kEdges[e]) sum[sheet] += 0.5 * Vec3(c & 1, c >> 1 & 1, c >> 2);
      ++count[sheet];
    }
    const Vec3 corner(static_cast<double>(cell.at[0]), static_cast<double>(cell.at[1]),
                      static_cast<double>(cell.at[2]));
    for (int s = 0; s < cell.sheets; ++s) {
      const auto sheet = static_cast<std::size_t>(s);
      vertices.row(cell.first_vertex + s) = corner + sum[sheet] / count[sheet];
    }
  }

  /// About the edge that leads along an axis to corner 7.
  void add_square(const Cell& cell, int axis, std::vector<std::array<int, 3>>& triangles) {
    const int from = 7 - (1 << axis);
    if (cell.has(from) == cell.has(7)) return;
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    std::array<int, 4> corners;
    for (int k = 0; k < 4; ++k) {  // round the axis: neither, b, b and c, c
      const bool over_b = k == 1 || k == 2, over_c = k >= 2;
      const Cell& at = cell_at(beside(beside(cell.at, b, over_b ? 1 : 0), c, over_c ? 1 : 0));
      const int end = 7 - (over_b ? 1 << b : 0) - (over_c ? 1 << c : 0);
      const int edge = edge_between(end - (1 << axis), end);
      corners[static_cast<std::size_t>(k)] =
          at.first_vertex + at.sheet[static_cast<std::size_t>(edge)];
    }
    if (!cell.has(from)) std::swap(corners[1], corners[3]);
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
  }

  LabelBox box_;
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, std::size_t> number_;
};

/// One pass over all vertices: towards the mean of their neighbours, by `share` of the way.
void relax(const Faces& faces, const Eigen::VectorXd& degree, double share, Points& vertices) {
  Points sum = Points::Zero(vertices.rows(), 3);
  for (Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) sum.row(faces(f, k)) += vertices.row(faces(f, (k + 1) % 3));
  for (Index v = 0; v < vertices.rows(); ++v)
    vertices.row(v) += share * (sum.row(v) / degree[v] - vertices.row(v));
}

void smooth(TriangleMesh& mesh) {
  // On a closed manifold every neighbour of a vertex follows it in exactly one triangle.
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(mesh.vertices_mm.rows());
  for (Index f = 0; f < mesh.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) degree[mesh.faces(f, k)] += 1.0;
  for (int pass = 0; pass < kSmoothings; ++pass) {
    relax(mesh.faces, degree, kShrink, mesh.vertices_mm);
    relax(mesh.faces, degree, kGrow, mesh.vertices_mm);
  }
}

/// Moves the surface along its normals, by at most `longest_mm` a step, until it holds `volume_mm3`.
void keep_volume(double volume_mm3, double longest_mm, TriangleMesh& mesh) {
  for (int step = 0; step < kVolumeSteps; ++step) {
    double volume = 0.0, area = 0.0;
    const Vec3 origin = mesh.vertices_mm.row(0);
    for (Index f = 0; f < mesh.faces.rows(); ++f) {
      std::array<Vec3, 3> x;
      for (int k = 0; k < 3; ++k)
        x[static_cast<std::size_t>(k)] = Vec3(mesh.vertices_mm.row(mesh.faces(f, k))) - origin;
      volume += x[0].dot(x[1].cross(x[2])) / 6.0;
      area += 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
    }
    const double offset = std::clamp((volume_mm3 - volume) / area, -longest_mm, longest_mm);
    mesh.vertices_mm += offset * vertex_normals(mesh.vertices_mm, mesh.faces);
  }
}

}  // namespace

Expected<TriangleMesh> label_surface(const LabelMap& map, const LabelAt& label) {
  const LabelVoxels voxels(map, label);
  const LabelBox box = voxels.box();
  if (box.count == 0)
    return Error{ErrorCode::BadReference, "",
                 "has no voxel of label " + std::to_string(label.value)};
  if (const Index triangles = 2 * voxels.crossings(box); triangles > kMostTriangles)
    return Error{ErrorCode::OutOfRange, "",
                 "has " + std::to_string(triangles) + " triangles around label " +
                     std::to_string(label.value) +
                     ", must be at most 1000000; check that it is a leaflet and that the voxel "
                     "size is correct"};
  TriangleMesh mesh = SurfaceNet(voxels, box).mesh();
  smooth(mesh);
  const Eigen::Matrix3d axes = map.to_lps_mm.topLeftCorner<3, 3>();
  mesh.vertices_mm =
      (mesh.vertices_mm * axes.transpose()).rowwise() + map.to_lps_mm.col(3).head<3>().transpose();
  if (axes.determinant() < 0.0) mesh.faces.col(1).swap(mesh.faces.col(2));
  keep_volume(static_cast<double>(box.count) * std::abs(axes.determinant()),
              kLongestStep * axes.colwise().norm().minCoeff(), mesh);
  return mesh;
}

}  // namespace coapt
