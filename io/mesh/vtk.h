// Legacy VTK files, POLYDATA and, read only, UNSTRUCTURED_GRID: what SlicerHeart's ValveFemExport, FEBio Studio's "Import Springs"
// and ParaView exchange. Lines of less than 255 characters, which is what FEBio Studio reads.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/mesh_file.h"

namespace coapt {

/// One number for each point, line or face.
struct VtkScalars {
  std::string name;  ///< without blanks
  std::vector<double> values;
  bool integers = false;  ///< written as int
};

struct VtkPolyData {
  std::string title;  ///< one line, at most 255 characters
  Points points_mm;
  std::vector<std::array<int, 2>> lines;
  Faces faces;
  std::vector<VtkScalars> point_data, line_data, face_data;
};

/// The title of a file that coapt writes: what it is not, units and SPACE=LPS, by which SlicerHeart
/// takes the numbers as they are. In the valve's own axes (core/valve/valve.h) shape, handedness and millimetres are
/// right, and the letters L, P and S that a viewer shows mean nothing.
inline constexpr const char* kVtkTitle =
    "coapt: research software, not a medical device; millimetres, axes of the valve; SPACE=LPS";
inline constexpr const char* kPatientVtkTitle =
    "coapt: research software, not a medical device; millimetres, axes of the patient; SPACE=LPS";

/// Versions 2 to 5. Polylines become pieces, polygons and strips triangles; of the data only scalars
/// are kept. Errors name the line. ASCII or binary. Of an unstructured grid
/// the same cells. Unsupported: other datasets, cells with a volume, text
/// among the data of a binary file.
Expected<VtkPolyData> read_vtk(std::string_view text, const MeshLimits& limits = {});

}  // namespace coapt
