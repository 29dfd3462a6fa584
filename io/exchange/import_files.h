// The files of segmentation tools that a valve can be made of: for `coapt valve import` and POST /v1/valves:import.
#pragma once

#include <optional>

#include "io/exchange/formats.h"
#include "io/exchange/label_parts.h"
#include "io/exchange/stated_axes.h"
#include "io/image/image_geometry.h"
#include "io/mesh/import_valve.h"

namespace coapt {

struct ImportFiles {
  std::vector<NamedFile>
      leaflets;  ///< OBJ, PLY, STL, VTK: the anterior, then the posterior leaflet, or one file: a skirt, or both as its parts
  std::optional<NamedFile> annulus =
      {};  ///< a table, a closed curve of Slicer (.mrk.json), or lines of OBJ, .vtk or .vtp
  std::optional<NamedFile> chordae = {};  ///< CSV or JSON; none: they are to be drawn
  std::optional<NamedFile> tips = {};     ///< of such chordae: CSV, or labelled points of Slicer
  std::optional<NamedFile> labels =
      {};  ///< NRRD or NIfTI, instead of leaflets; also of the annulus if that has no file
  std::optional<std::size_t> posterior_from =
      {};                   ///< the first of the posterior leaflet's files; none: the second
  LeafletOrder order = {};  ///< of leaflets with a file each
  std::optional<NamedFile> landmarks = {};  ///< labelled points, a table or of Slicer
};

/// What the files leave open.
struct ImportReading {
  LabelNumbers labels;
  std::optional<PatientAxes> axes = {};      ///< of meshes and tables; none: as they say, else LPS
  std::optional<ImageGeometry> series = {};  ///< of the images that the labels were drawn on
  std::size_t most_unpacked = kMostUnpackedSent;  ///< bytes of the arrays of a .vtp or .vtu
  int phase = 0;  ///< of a label map of several, from 1; 0: the first that has labels
  Index most_voxels = kMostVoxels;
};

/// "obj" of "Leaflet.OBJ": by its extension in lower case.
std::string format_of(const std::string& file_name);

/// A closed loop. @param format "json": markups of Slicer, the only closed curve or the one named as the annulus; "obj", "vtk", "vtp":
/// lines; else a table of x, y, z
Expected<Points> read_closed_loop(std::string_view text, const std::string& format);

/// Papillary tips. @param format "json": markups of Slicer, points labelled AL or PM; else a table.
Expected<std::vector<ImportedTip>> read_tips(std::string_view text, const std::string& format);

/// For import_valve(), with the decisions that reading took. Errors: all problems of all files, with pointers that begin with
/// /leaflets/0, /annulus, /chordae, /tips, /landmarks, /labels, /label_numbers or /series.
Expected<ImportSource> read_import_files(const ImportFiles& files,
                                         const ImportReading& reading = {});

}  // namespace coapt
