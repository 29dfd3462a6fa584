// The patient's axes that the numbers of a file are in.
#pragma once

#include <optional>
#include <string_view>

#include "io/mesh/import_valve.h"

namespace coapt {

/// Of x and y; z leads to the head in either.
enum class PatientAxes { LPS, RAS };
const char* to_string(PatientAxes axes);

/// What 3D Slicer writes at the head of VTK, PLY, STL and OBJ files: SPACE=LPS or SPACE=RAS; of tables
/// what .fcsv says, and columns r, a, s or l, p, s. None if it is not there.
std::optional<PatientAxes> stated_axes(std::string_view bytes);

/// Whether a .fcsv says that its numbers count voxels (IJK, 2), of an image that it does not name.
bool is_in_voxels(std::string_view bytes);

/// Between RAS and LPS either way: half a turn about z.
void turn_axes(Points& points_mm);
void turn_axes(Vec3& point_mm);
void turn_axes(ImportedChorda& chorda);

}  // namespace coapt
