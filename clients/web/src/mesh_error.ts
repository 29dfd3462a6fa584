// How far a leak may be off because the mesh is coarse. One number until each closure brings its own.

/// Share of the leak: the median spread of one valve's orifice over meshes of 650 to 5,200 triangles (closures of
/// membrane "springs"; at most 34 %). The ranks of plans survive it.
export const MESH_SPREAD = 0.2
