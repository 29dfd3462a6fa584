// The files that a closed valve can be written to.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/exchange/exported_valve.h"
#include "io/image/image_geometry.h"
#include "io/json/named_file.h"

namespace coapt {

struct FileFormat {
  const char* name;        ///< also the extension: "glb", "mrk.json"
  const char* media_type;  ///< as registered, else application/octet-stream
  const char* what;        ///< in words
  /// Neither holds nor draws Valve::ties, which a valve imported from it therefore lacks.
  bool loses_ties = false;
  bool is_label_map = false;  ///< its size is that of ExportOptions::grid
};

std::span<const FileFormat> file_formats();

/// By its name ("glb"), or by the end of a path ("a/valve.GLB", "x.mrk.json"); null if there is none.
const FileFormat* format_named(std::string_view name);
const FileFormat* format_of_path(std::string_view path);
/// "glb, vtk, ...", for messages.
std::string format_names();

/// Whose axes the numbers are in. Patient: those of the images that the valve was made from; its own
/// where these are not known.
enum class ExportFrame { Patient, Valve };

struct ExportOptions {
  bool open = false;  ///< the unstressed shape instead of the closed one; .feb is always unstressed
  ExportFrame frame = ExportFrame::Patient;
  std::optional<ImageGeometry> grid = {};  ///< of label maps; none: about the valve
  std::function<bool()> cancelled = {};    ///< ends the drawing of a label map, with Busy
};

/// Errors: a closure that flew apart has no closed shape; of a label map "/grid", a valve that does not lie in it.
Expected<std::string> write_valve_file(const ClosedValve& closed, const FileFormat& format,
                                       const ExportOptions& options = {});

/// Of a folder those that not every valve has: left over from an earlier export they would be read with a later one.
inline constexpr std::array<const char*, 4> kOptionalFiles = {
    "repair.mrk.json", "under_pressure.mrk.json", "measurements.csv", "tissue.json"};

/// What SlicerHeart's ValveFemExport leaves in a folder, and its markups and measurements: both leaflets together and
/// one by one, chordae, annulus, tips, landmarks, the repair (if there is one). Measurements only of the closed shape; of the open one where annulus and tips go, tissue and pressure.
Expected<std::vector<NamedFile>> write_slicerheart(const ClosedValve& closed,
                                                   const ExportOptions& options = {});

}  // namespace coapt
