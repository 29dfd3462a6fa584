// Faults of segmented meshes, each named: corners in the same place, faces that are turned over, loose pieces, holes.
//
// Mended: corners welded, collapsed triangles dropped, those that are there twice (sheets with two sides of the same points, too), faces turned alike, loose pieces of less than kIslandShare of the
// area dropped. A hole is what a boundary loop beside the outline encloses. One of at most kBridged_mm is left to the cuts, which
// go straight across (leaflet_cut.h; all but the longest cuts across the widest); a wider one is filled by a fan about its centre, up to kWidestHole_mm: across w
// of a leaflet with a radius of curvature of 15 mm a flat filling strays by w^2 / (8 * 15 mm), 0.3 mm at 6 mm.
#pragma once

#include <string>
#include <vector>

#include "core/closure/closure_options.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

inline constexpr double kIslandShare = 0.05;
inline constexpr double kBridged_mm = 3.0;
inline constexpr double kWidestHole_mm = 6.0;

struct SheetHole {
  Vec3 centre_mm = Vec3::Zero();
  double width_mm = 0.0;  ///< twice the mean distance of its edge from its centre
  bool filled = false;
};

struct RepairedSheet {
  TriangleMesh mesh;
  int welded = 0, collapsed = 0, repeated = 0, turned = 0;
  int branching_edges = 0;  ///< that more than two triangles share
  int islands = 0;          ///< dropped
  double islands_mm2 = 0.0, area_mm2 = 0.0;
  std::vector<SheetHole> holes;
};

/// Closed lines of edges that one face alone has, the longest first.
std::vector<std::vector<int>> boundary_loops(const TriangleMesh& mesh);

double length_mm(const std::vector<int>& loop, const Points& vertices_mm);

/// Along a face's normal, as long as its area.
Vec3 area_vector(const TriangleMesh& mesh, Eigen::Index face);

double area_mm2(const TriangleMesh& mesh);

/// The piece of a mesh that has the faces where `kept` says so, without unused vertices.
TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<bool>& kept);

/// The faces across the edges of each face; of more than two at an edge, those next to each other in number.
std::vector<std::vector<int>> face_neighbours(const Faces& faces);

/// With one vertex for each place.
TriangleMesh welded(TriangleMesh mesh);

/// Without points that no triangle has. @return how many there were
int drop_loose_points(TriangleMesh& mesh);

/// Number of each face's piece (faces that share an edge), from 0.
std::vector<int> face_pieces(const Faces& faces);

/// Indices must be in range, vertices finite. Pointers of errors are relative to the mesh: /faces.
/// @param outlines loops that are no holes: 1 of a leaflet, 2 of a skirt. @param budget cancelled: holes stay as they are
Expected<RepairedSheet> repaired_sheet(const TriangleMesh& mesh, std::size_t outlines,
                                       const ClosureBudget& budget = {});

}  // namespace coapt
