// What a file of a segmentation tool holds, by itself, as its reader finds it: to be looked at before a valve is made of it.
#pragma once

#include <string>
#include <vector>

#include "io/exchange/formats.h"
#include "io/mesh/import_valve.h"

namespace coapt {

enum class FileContent { Surface, Labels, Curve, PointList, Tips, Chordae, Unknown };
const char* to_string(FileContent content);  ///< "surface", ...

struct FilePreview {
  FileContent content = FileContent::Unknown;
  Points points;  ///< n x 3, in the file's units and frame; chordae: insertion, tip, insertion, ...
  Faces faces;    ///< of a surface; of a label map that of both leaflets
  std::vector<std::string> labels;     ///< n or none; of tips and chordae "AL" or "PM"
  Errors problems;                     ///< of the reader that its name calls for
  std::vector<SourcePart> parts = {};  ///< the labels of a label map, not yet taken as anything
};

/// @param most of a surface; one that has more is refused while it is read
FilePreview preview_file(const NamedFile& file, const MeshLimits& most = {});

}  // namespace coapt
