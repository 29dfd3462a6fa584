// Thick leaflets of a known sheet.
#pragma once

#include "io/mesh/import_valve.h"

namespace coapt {

/// The two sides of a sheet, half the thickness away along its normals, joined by a square rim. Each vertex of the
/// shell moves by a normal deviate of noise_mm along the normal.
TriangleMesh thickened(const TriangleMesh& sheet, double thickness_mm, double noise_mm = 0.0);

/// The surface of the voxels nearer to the sheet than half the thickness: faces of cubes, two triangles each.
TriangleMesh voxel_shell(const TriangleMesh& sheet, double thickness_mm, double voxel_mm);

/// A preset's anterior and posterior leaflet, open or closed, with its annulus; closed with its tissue, by which open ones are
/// shorter.
ImportSource preset_leaflets(const char* preset, bool closed);

}  // namespace coapt
