// The leaflets among the parts of meshes: the one place that turns parts into roles.
#pragma once

#include "io/mesh/import_valve.h"
#include "io/mesh/mesh_parts.h"

namespace coapt {

struct MeshLeaflets {
  std::vector<TriangleMesh> leaflets;  ///< two, or one skirt
  LeafletOrder order;                  ///< of two
  Points annulus_mm;                   ///< of a part that is a line; may be empty
  std::vector<ImportDecision> decisions;
};

/// By the names of the parts, of which several may be one leaflet (scallops); two without names in any order. Errors without
/// a path: more parts than leaflets, a leaflet of another valve. No decision repeats a name.
Expected<MeshLeaflets> leaflets_of(MeshParts parts);

}  // namespace coapt
