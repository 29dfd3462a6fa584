// What a comparison of two closed shapes answers, as JSON.
#pragma once

#include <string>

#include "core/metrics/shape_comparison.h"
#include "io/json/json.h"

namespace coapt {

/// A shape as a command was given it.
struct ComparedShape {
  std::string source;  ///< file or preset
  LeafletMesh mesh;
  std::vector<bool> contact;  ///< nodes_in_contact
};

/// coapt.comparison/1. Keys that scripts rely on: rms_mm, p95_mm, max_mm.
Json comparison_to_json(const ShapeComparison& comparison, const ComparedShape& closed,
                        const ComparedShape& reference, double contact_distance_mm);

}  // namespace coapt
