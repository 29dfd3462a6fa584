// Legacy VTK files, written.
#pragma once

#include <string>

#include "io/mesh/vtk.h"

namespace coapt {

/// Version 4.2, nine digits. Lines come before faces; data that only one of them has is 0 for the other,
/// because ASCII readers take no NaN. @pre indices are in range, data have their length.
std::string write_vtk(const VtkPolyData& data);

}  // namespace coapt
