// What a comparison of two closed shapes answers, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/metrics/shape_comparison.h"

namespace coapt {

/// A shape as a command was given it.
struct ComparedShape {
  std::string source;  ///< file or preset
  LeafletMesh mesh;
  std::vector<bool> contact;  ///< nodes_in_contact
};

/// coapt.comparison/1. Keys that scripts rely on: rms_mm, p95_mm, max_mm.
nlohmann::ordered_json comparison_to_json(const ShapeComparison& comparison,
                                          const ComparedShape& closed,
                                          const ComparedShape& reference,
                                          double contact_distance_mm);

}  // namespace coapt
