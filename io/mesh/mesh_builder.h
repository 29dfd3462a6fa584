// Collects the vertices and polygons of a mesh file and checks them: the part that OBJ, PLY and STL
// share. Nothing is allocated ahead of the bytes that fill it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/valve/problem_list.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

/// Scanner coordinates are thousands at most.
inline constexpr Range kMeshCoordinateMm = {-1e5, 1e5};

class MeshBuilder {
 public:
  explicit MeshBuilder(const MeshLimits& limits = {}) : limits_(limits) {}

  /// Coordinates out of kMeshCoordinateMm are a problem where a triangle has them. @param line of the file, 0 if it is binary.
  void add_vertex(const Vec3& position_mm, int line);

  /// Indices from 0; three or more corners are split into a fan.
  void add_polygon(const std::vector<long long>& corners, int line);
  /// `polygon`: its number in TriangleMesh::polygons, where that is not the number of those before.
  void add_polygon(const std::vector<long long>& corners, int line, int polygon);

  /// A problem at the file as a whole or one line of it.
  void add_problem(ErrorCode code, const std::string& path, int line, const std::string& message);

  long long vertices() const { return static_cast<long long>(vertices_.size()); }
  long long faces() const { return static_cast<long long>(faces_.size()); }

  /// Whether to stop reading: too many vertices, faces or problems.
  bool full() const;

  /// The mesh, without triangles that name a vertex twice, or all problems.
  Expected<TriangleMesh> take() &&;

  /// The vertices of a file without faces, or all problems.
  Expected<Points> take_points() &&;

 private:
  struct Triangle {
    std::array<long long, 3> corners;
    int line, polygon;
  };
  /// A vertex that no leaflet can have.
  struct Wild {
    std::size_t vertex;
    int line;
  };
  void add_wild(const Wild& wild);

  const MeshLimits limits_;
  std::vector<Vec3> vertices_;
  std::vector<Wild> wild_;
  std::vector<Triangle> faces_;
  int polygons_ = 0;
  ProblemList problems_;
};

}  // namespace coapt
