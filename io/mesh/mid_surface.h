// The sheet half-way between the two sides of a thick leaflet.
//
// Idea: from each triangle a ray goes inwards along the normal of the smoothed shell (Taubin 1995, which takes the steps of
// voxels away without shrinking it). Where it first meets a triangle that faces the other way, within kThickest_mm and
// kThickerThanMedian times the median, the two are opposite; other triangles are the rim. A signed graph tells the sides:
// neighbours attract by the cosine between their normals, opposite triangles repel; signs spread along the strongest edges
// first and are then settled by majority. Each vertex of the larger side moves by half the thickness, which is smoothed over
// its neighbours.
//
// Assumed: the shell is thinner than it is wide. Limits: where two leaflets are fused in one surface, their mid-surface means
// nothing; the rim does not say where the leaflet ends: the sheet of a rounded one (voxels) ends up to half a millimetre beyond the edge,
// that of a square one short of it by up to a third of the thickness.
#pragma once

#include <vector>

#include "core/closure/closure_options.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

inline constexpr double kThickest_mm = 8.0;

struct MidSurface {
  TriangleMesh sheet;
  std::vector<double> thickness_mm;  ///< of each vertex of the sheet
};

/// Share of the area that has an opposite side: more than half of a thick leaflet's. @param budget cancelled: 0
double opposed_share(const TriangleMesh& shell, const ClosureBudget& budget = {});

/// @param shell one piece, its faces turned alike (sheet_repair.h). Errors: a surface whose sides cannot be told, or were not in
/// the budget.
Expected<MidSurface> mid_surface(const TriangleMesh& shell, const ClosureBudget& budget = {});

}  // namespace coapt
