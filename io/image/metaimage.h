#pragma once

#include "io/image/label_map.h"

namespace coapt {

/// MetaImage (.mha; ITK, SimpleITK, MeVisLab): raw or zlib, data behind the header. Errors: "/DimSize" and the like.
Expected<LabelMap> read_metaimage(std::string_view bytes, Index most_voxels = kMostVoxels,
                                  int phase = 0);

}  // namespace coapt
