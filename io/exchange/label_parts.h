// The parts of a valve out of a label map: leaflets as closed shells, the annulus as a line.
#pragma once

#include <optional>

#include "io/image/label_map.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// Which label is what; none: by the names that the file gives its labels, else 1, 2 and 3.
struct LabelNumbers {
  std::optional<int> anterior, posterior, annulus;  ///< 1 to 65535
};

struct LabelParts {
  std::vector<TriangleMesh>
      leaflets;       ///< the anterior, then the posterior one; closed, oriented outwards
  Points annulus_mm;  ///< empty if there is no such label
  std::vector<ImportDecision> decisions;
};

/// Errors: labels that are not there ("/label_numbers/anterior"), and those of label_surface() and label_curve().
/// No decision repeats a name that stands in the file.
Expected<LabelParts> label_parts(const LabelMap& map, const LabelNumbers& numbers,
                                 bool with_annulus);

}  // namespace coapt
