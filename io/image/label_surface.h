// The surface of a label as closed triangles.
//
// Surface nets (Gibson 1998): in every cell of eight voxel centres that the surface passes, a vertex; about every pair of
// neighbouring voxels of which one is of the label, two triangles. A cell through which the surface passes several times has
// as many vertices (as in Nielson's dual marching cubes, 2004), so that the mesh is a manifold: each edge has two triangles, each vertex one
// fan. Voxels of the label that touch at an edge hang together, which keeps sheets of one voxel whole; where only two such
// voxels touch, and the mesh would meet itself there, they are taken apart. Then the steps are smoothed (Taubin 1995, which
// does not shrink), and the surface is moved along its normals until it holds the volume of the voxels.
//
// Assumed: the label is right; what touches the border of the image ends there. Limits: voxels that touch at a corner alone
// are apart; detail below two voxels is lost; of voxels that are long in one direction steps remain along it.
#pragma once

#include "io/image/label_map.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

/// In LPS mm, oriented outwards. Errors: no such label; more than 1,000,000 triangles.
Expected<TriangleMesh> label_surface(const LabelMap& map, const LabelAt& label);

}  // namespace coapt
