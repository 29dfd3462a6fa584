// An import for the eye: what was given beside the valve made of it, in one frame and one scale.
#pragma once

#include <string>

#include "io/mesh/import_valve.h"

namespace coapt {

/// PNG bytes: both from the atrium and from the side, a section through the middle, and how far the resampled leaflets lie
/// from those given. @param title a line
std::string import_picture_png(const ImportedValve& imported, const std::string& title);

/// Reads the fonts, so that import_picture_png() opens no file any more.
void load_import_fonts();

}  // namespace coapt
