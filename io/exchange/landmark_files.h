// Landmarks of the annulus that a person placed, from a file of labelled points.
#pragma once

#include <string>
#include <string_view>

#include "core/valve/types.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Points labelled ALC, PMC, A (saddle peak) and P (middle of the posterior annulus), as coapt writes them, or in words; points of other labels
/// are passed over. @param format "json": markups of Slicer; else a table with columns label, x, y, z.
/// Errors: none has such a label, or two have the same.
Expected<GivenLandmarks> landmarks_in(std::string_view text, const std::string& format);

/// Whether a file of such points it is, and not of papillary tips: a commissure is among them.
bool has_commissures(std::string_view text, const std::string& format);

}  // namespace coapt
