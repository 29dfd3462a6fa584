// The leaflets among the parts of meshes: the one place that turns parts into roles.
#pragma once

#include "io/exchange/label_parts.h"
#include "io/mesh/import_valve.h"
#include "io/mesh/mesh_parts.h"

namespace coapt {

struct MeshLeaflets {
  std::vector<TriangleMesh> leaflets;  ///< two, or one skirt
  LeafletOrder order;                  ///< of two
  std::vector<SourcePart> parts;       ///< every part, from 1, of a file of several
  std::vector<ImportedTip> sided;      ///< middles of parts whose names say their side
  Points annulus_mm;                   ///< of a part that is a line; may be empty
  std::vector<ImportDecision> decisions;
};

/// As `given`, which counts the parts from 1; else by their names, of which several may be one leaflet (scallops); two without
/// names in any order. Errors without a path: more parts than leaflets, a leaflet of another valve; at "/label_numbers/anterior"
/// a part that is not there. No decision repeats a name.
Expected<MeshLeaflets> leaflets_of(MeshParts parts, const LabelNumbers& given = {});

}  // namespace coapt
