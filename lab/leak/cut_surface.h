// The surface that a cut is: where u passes a level, as triangles, and how much of it lies in the blood.
//
// Voxels count a surface that lies askew to them too large, as its steps, and u blurs it to make these lower; the level sets of u, joined by
// lines between the cells' centres (marching tetrahedra), have neither fault. Every one of them parts atrium from ventricle, so
// that its area in the blood is an upper bound of the least one, and near it, because the least area does not change with a small
// shift of the surface. Inside the leaflets, where u means nothing, it is carried on from the blood.
#pragma once

#include "lab/leak/minimal_cut.h"

namespace coapt {

/// The least area in the blood, mm2, of the surfaces u = 0.3, 0.4, ..., 0.7. Blood is farther from `surface` than half its thickness
/// (exact distance, at four points of each triangle).
double cut_surface_mm2(const VoxelBand& band, const AxisFields& shares,
                       const std::vector<float>& side, const LeakSurface& surface);

}  // namespace coapt
