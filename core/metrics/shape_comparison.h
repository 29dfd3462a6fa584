// How far one closed shape lies from another: of two closures, or of a closure and an image or another code's result.
//
// Node to node where the meshes agree; else from each node to the nearest point of the reference surface after a rigid
// iterative-closest-point fit, which is how the thesis judges its valves (2.2.6: "the distance from the sparser, simulated
// valve to the higher resolution, imaged valve"). Only nodes that some face has count.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/metrics/rigid_fit.h"

namespace coapt {

/// A surface in leaflets.
struct LeafletMesh {
  Points vertices_mm;  ///< n x 3; each vertex belongs to a face (without_loose_vertices)
  Faces faces;         ///< m x 3, at least one
  std::vector<std::string> names;  ///< of the leaflets
  std::vector<int> leaflets;       ///< m, indices into `names`
};

/// Without the vertices that no face has; the others keep their order.
LeafletMesh without_loose_vertices(const LeafletMesh& mesh);

/// One leaflet for each piece that hangs together by shared vertices: "piece 1" is that of the first face.
LeafletMesh in_pieces(Points vertices_mm, Faces faces);

/// As many nodes and the same triangles between them, except that quadrangles may be split along either diagonal.
bool have_same_nodes(const LeafletMesh& a, const LeafletMesh& b);

struct LeafletArea {
  std::string name;
  double area_mm2 = 0.0;
};
std::vector<LeafletArea> leaflet_areas(const LeafletMesh& mesh);

/// For each node, whether it is nearer than `distance_mm` to a face of another part of the surface: one none of whose
/// corners can be reached from the node along edges within three times that distance.
/// @param cancelled asked at each node; true leaves the others out
std::vector<bool> nodes_in_contact(const LeafletMesh& mesh, double distance_mm,
                                   const std::function<bool()>& cancelled = {});

enum class Alignment {
  Auto,  ///< none between the same nodes, else rigid
  None,
  Rigid
};
const char* to_string(Alignment alignment);

struct DistanceSummary {
  double rms_mm = 0.0, p95_mm = 0.0, max_mm = 0.0;  ///< p95: linear interpolation
};

struct ShapeComparison {
  bool node_to_node = false;
  bool aligned = false;
  bool settled = true;  ///< the fit came to rest within its rounds
  RigidMotion motion;   ///< by which the closed shape was moved
  Points moved_mm;      ///< its nodes, there
  /// Per node, mm: length of the distance; > 0 on the side to which the reference's normals point.
  std::vector<double> signed_mm;
  DistanceSummary distance;  ///< of the nodes from the reference
  DistanceSummary back;      ///< of the reference's nodes from the closed surface, as moved
  double mean_signed_mm = 0.0;
  /// Of nodes whose nearest point lies on the edge of the reference: beyond what it covers, or at the edge. 0 node to node.
  double beyond_edge_share = 0.0;
  /// Node to node without alignment: the rms that the best rigid motion would leave.
  double rms_after_rigid_mm = 0.0;
};

/// Both without loose vertices and with finite coordinates.
/// @param cancelled asked as nearest_to_each() does; true, from then on, ends it, not settled and without the distances that
/// are not known yet
ShapeComparison compare_shapes(const LeafletMesh& closed, const LeafletMesh& reference,
                               Alignment alignment = Alignment::Auto,
                               const std::function<bool()>& cancelled = {});

}  // namespace coapt
