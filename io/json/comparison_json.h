// What a comparison of two closed shapes answers, as JSON.
#pragma once

#include <string>

#include "core/metrics/shape_comparison.h"
#include "io/json/json.h"

namespace coapt {

/// A shape as it was given.
struct ComparedShape {
  std::string source;  ///< file or preset
  LeafletMesh mesh;
  std::vector<bool> contact;  ///< nodes_in_contact
  std::string closure =
      {};                  ///< how it ended ("converged", "crossing", ...); empty: not closed here
  std::string doubt = {};  ///< doubt_about() that closure
};

/// coapt.comparison/1. Keys that scripts rely on: rms_mm, p95_mm, max_mm.
Json comparison_to_json(const ShapeComparison& comparison, const ComparedShape& closed,
                        const ComparedShape& reference, double contact_distance_mm);

/// {"vertices_mm", "faces", "names", "leaflets"}, as requests take a mesh.
Json to_json(const LeafletMesh& mesh);

/// {"moved_mm", "signed_mm", "contact", "faces", "leaflets"}: of each node and triangle of the closed shape, as aligned.
Json compared_nodes_json(const ShapeComparison& comparison, const ComparedShape& closed);

}  // namespace coapt
