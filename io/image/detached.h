// Headers of images whose voxels are in a file of their own: .nhdr (NRRD) and .mhd (MetaImage).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/valve/types.h"

namespace coapt {

/// The name of the file that a header says its voxels are in; none: they are behind the header, or it is no header of these.
/// Errors without a path: several files, or one in another folder.
Expected<std::optional<std::string>> data_file_of(std::string_view header);

/// Header and voxels as one file, .nrrd or .mha. @pre data_file_of(header) has a name
std::string attached(std::string_view header, std::string_view data);

}  // namespace coapt
