// What an import does to leaflets before it has a frame: faults are named and mended, thick shells become sheets, and the
// annulus is found where it was not traced.
#pragma once

#include "core/valve/problem_list.h"
#include "io/mesh/import_valve.h"

namespace coapt {

struct SheetPreparation {
  std::vector<ImportDecision> decisions;
  std::vector<MeasuredThickness> thickness;  ///< of thick leaflets
};

/// One or two, with triangles but not too many, indices and coordinates as they must be: problems at "/leaflets".
void check_leaflets(const std::vector<TriangleMesh>& leaflets, ProblemList& problems);

/// None of these problems.
bool is_sound(const std::vector<TriangleMesh>& leaflets);

/// Changes leaflets and, if it is empty, the annulus; lengths must be millimetres. A source whose leaflets are
/// not sound is left as it is: into_import_frame() names that.
Expected<SheetPreparation> prepare_sheets(ImportSource& source, const ClosureBudget& budget);

}  // namespace coapt
