// Label maps as files: NRRD with the names of Slicer's segments, NIfTI-1.
#pragma once

#include <string>

#include "io/image/label_map.h"

namespace coapt {

/// Compressed by gzip. `note`: a comment of the header, one line or none. @pre one layer, labels of at most 255
std::string write_nrrd(const LabelMap& map, const std::string& note);

/// Not compressed; `note` is its description, of which 79 bytes are kept. NIfTI has no names of labels.
std::string write_nifti(const LabelMap& map, const std::string& note);

/// The same compressed by gzip.
std::string write_nifti_gz(const LabelMap& map, const std::string& note);

}  // namespace coapt
