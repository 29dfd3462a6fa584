// Where the images of a DICOM series lie, by DCMTK. Of each file only its size and geometry are read: nothing that names a
// patient, a place or a date is looked at, and no message says more than numbers of these.
#pragma once

#include <string>
#include <vector>

#include "io/image/image_geometry.h"

namespace coapt {

/// Whether a file begins as DICOM files do, with DICM behind 128 bytes.
bool is_dicom_file(const std::string& path);

/// Of the files that are DICOM: single images, sorted along their normal, or one enhanced multi-frame image. Without the
/// patient's orientation (3-D echo) only the voxels' size is known. Errors have no path: no DICOM file, more than one
/// series, images of different size or direction, unequal distances.
Expected<ImageGeometry> read_series_geometry(const std::vector<std::string>& paths);

}  // namespace coapt
