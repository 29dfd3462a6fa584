// DICOM segmentation objects (PS3.3 A.51, C.8.20) as label maps, by DCMTK. Read are numbers and names of segments, geometry and bits;
// nothing that names a patient, a place or a date is looked at.
#pragma once

#include <string>

#include "io/image/label_map.h"

namespace coapt {

/// Labels are the segments' numbers, at most 255. Slices that no frame shows are empty. Errors have no path: no segmentation, fractional or compressed ones,
/// frames in no grid, segments that overlap by more than 5 % of the smaller.
Expected<LabelMap> read_dicom_segmentation(const std::string& path);

}  // namespace coapt
