#include "core/valve/vertex_normals.h"

namespace coapt {

Points vertex_normals(const Points& vertices_mm, const Faces& faces) {
  Points normals = Points::Zero(vertices_mm.rows(), 3);
  for (const auto& face : faces.rowwise()) {
    const Vec3 a = vertices_mm.row(face[0]), b = vertices_mm.row(face[1]),
               c = vertices_mm.row(face[2]);
    const Vec3 twice_area = (b - a).cross(c - a);
    for (const int vertex : face) normals.row(vertex) += twice_area.transpose();
  }
  for (auto normal : normals.rowwise()) normal.normalize();
  return normals;
}

}  // namespace coapt
