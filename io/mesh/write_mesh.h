// Triangle meshes as text or bytes, for other tools. The same mesh gives the same bytes everywhere.
#pragma once

#include <string>
#include <string_view>

#include "core/valve/valve.h"
#include "io/mesh/mesh_file.h"

namespace coapt {

/// @param format
/// "ply": ASCII, doubles that read back bit for bit.
/// "obj": likewise.
/// "stl": binary, single precision (7 digits), which is what tools expect; faces of no area have the
///   normal 0. STL has no vertices: those that no face has are lost, equal ones become one.
/// "vtk": legacy VTK, the triangles alone (vtk.h).
/// All in millimetres. Unsupported: another format. OutOfRange: a coordinate that read_mesh() would
/// refuse. BadReference: a corner that is no vertex.
/// @param remark a line of ASCII that the file carries where programs show it (doubt_about()): comment, header or title
Expected<std::string> write_mesh(const TriangleMesh& mesh, std::string_view format,
                                 const std::string& remark = "");

/// The leaflets of a closed valve. @param closed_mm |V| x 3, as ClosureResult::closed_mm
TriangleMesh leaflet_mesh(const Valve& valve, const Points& closed_mm);

}  // namespace coapt
