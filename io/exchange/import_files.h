// The files of segmentation tools that a valve can be made of: for `coapt valve import` and POST /v1/valves:import.
#pragma once

#include <optional>

#include "io/exchange/formats.h"
#include "io/mesh/import_valve.h"

namespace coapt {

struct ImportFiles {
  std::vector<NamedFile>
      leaflets;       ///< OBJ, PLY, STL, VTK: the anterior, then the posterior sheet, or one skirt
  std::optional<NamedFile>
      annulus;  ///< CSV, or a closed curve of Slicer (.mrk.json); none: it is found
  std::optional<NamedFile> chordae = {};  ///< CSV or JSON; none: they are to be drawn
  std::optional<NamedFile> tips = {};     ///< of such chordae: CSV, or labelled points of Slicer
};

/// "obj" of "Leaflet.OBJ": by its extension in lower case.
std::string format_of(const std::string& file_name);

/// A closed loop. @param format "json": markups of Slicer, the first closed curve; else lines x,y,z
Expected<Points> read_closed_loop(std::string_view text, const std::string& format);

/// Papillary tips. @param format "json": markups of Slicer, points labelled AL or PM; else lines papillary,x,y,z.
Expected<std::vector<ImportedTip>> read_tips(std::string_view text, const std::string& format);

/// For import_valve(). Errors: all problems of all files, with pointers that begin with /leaflets/0, /annulus, /chordae
/// or /tips.
Expected<ImportSource> read_import_files(const ImportFiles& files);

}  // namespace coapt
