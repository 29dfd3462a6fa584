#include "io/json/comparison_json.h"

#include <algorithm>

#include "io/json/result_json.h"
#include "io/json/version.h"

namespace coapt {
namespace {

Json shape_json(const ComparedShape& shape) {
  Json leaflets = Json::array();
  double area_mm2 = 0.0;
  for (const auto& [name, leaflet_mm2] : leaflet_areas(shape.mesh)) {
    leaflets.push_back({{"name", name}, {"area_mm2", leaflet_mm2}});
    area_mm2 += leaflet_mm2;
  }
  const auto touching = std::count(shape.contact.begin(), shape.contact.end(), true);
  Json json = {
      {"source", shape.source},
      {"nodes", shape.mesh.vertices_mm.rows()},
      {"triangles", shape.mesh.faces.rows()},
      {"area_mm2", area_mm2},
      {"leaflets", std::move(leaflets)},
      {"contact_share", static_cast<double>(touching) /
                            static_cast<double>(std::max<std::size_t>(1, shape.contact.size()))}};
  if (!shape.closure.empty()) json["closure"] = shape.closure;
  if (!shape.doubt.empty()) json["doubt"] = shape.doubt;
  return json;
}

template <class Matrix>
Json rows_json(const Matrix& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i)
    rows.push_back({matrix(i, 0), matrix(i, 1), matrix(i, 2)});
  return rows;
}

Json summary_json(const DistanceSummary& distance) {
  return {{"rms_mm", distance.rms_mm}, {"p95_mm", distance.p95_mm}, {"max_mm", distance.max_mm}};
}

/// x -> matrix (x, 1), row by row.
Json matrix_json(const RigidMotion& motion) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back(
        {motion.rotation(i, 0), motion.rotation(i, 1), motion.rotation(i, 2), motion.shift_mm[i]});
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

}  // namespace

Json comparison_to_json(const ShapeComparison& comparison, const ComparedShape& closed,
                        const ComparedShape& reference, double contact_distance_mm) {
  const Vec3 before = closed.mesh.vertices_mm.colwise().mean().transpose();
  const Vec3 after = comparison.moved_mm.colwise().mean().transpose();
  Json json =
      result_document("coapt.comparison/1",
                      {{"pairing", comparison.node_to_node ? "node_to_node" : "node_to_surface"},
                       {"rms_mm", comparison.distance.rms_mm},
                       {"p95_mm", comparison.distance.p95_mm},
                       {"max_mm", comparison.distance.max_mm},
                       {"mean_signed_mm", comparison.mean_signed_mm},
                       {"back", summary_json(comparison.back)},
                       {"beyond_edge_share", comparison.beyond_edge_share},
                       {"alignment",
                        {{"rigid", comparison.aligned},
                         {"settled", comparison.settled},
                         {"rotation_deg", rotation_deg(comparison.motion)},
                         {"shift_mm", (after - before).norm()},
                         {"matrix", matrix_json(comparison.motion)}}},
                       {"contact_distance_mm", contact_distance_mm},
                       {"closed", shape_json(closed)},
                       {"reference", shape_json(reference)}});
  if (comparison.node_to_node) json["rms_after_rigid_mm"] = comparison.rms_after_rigid_mm;
  return json;
}

Json to_json(const LeafletMesh& mesh) {
  return {{"vertices_mm", rows_json(mesh.vertices_mm)},
          {"faces", rows_json(mesh.faces)},
          {"names", mesh.names},
          {"leaflets", mesh.leaflets}};
}

Json compared_nodes_json(const ShapeComparison& comparison, const ComparedShape& closed) {
  return {{"moved_mm", rows_json(comparison.moved_mm)},
          {"signed_mm", comparison.signed_mm},
          {"contact", closed.contact},
          {"faces", rows_json(closed.mesh.faces)},
          {"leaflets", closed.mesh.leaflets}};
}

}  // namespace coapt
