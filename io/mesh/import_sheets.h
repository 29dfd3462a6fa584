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

/// Of all leaflets, before anything is measured of them.
std::vector<ImportDecision> drop_loose_points(ImportSource& source);

/// After the two leaflets have changed places.
void swap_names(SheetPreparation& prepared);

/// One or two, with triangles but not too many, indices and coordinates as they must be: problems at "/leaflets".
void check_leaflets(const std::vector<TriangleMesh>& leaflets, ProblemList& problems);

/// How far sheets hang below the annulus in the mean, at least, to tell the atrium from the ventricle.
inline constexpr double kLeastHanging_mm = 2.0;

/// None of these problems.
bool is_sound(const std::vector<TriangleMesh>& leaflets);

/// Changes leaflets and, if it is empty, the annulus; lengths must be millimetres. A source whose leaflets are
/// not sound is left as it is: into_import_frame() names that.
Expected<SheetPreparation> prepare_sheets(ImportSource& source, const ClosureBudget& budget);

}  // namespace coapt
