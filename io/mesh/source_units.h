// The units of what is imported. Meshes and tables carry none, and programs write metres, centimetres and millimetres.
#pragma once

#include "core/valve/problem_list.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// How many millimetres a unit has.
double in_mm(LengthUnit unit);

inline constexpr Range kCircumferenceMm = {30.0, 400.0};  // of the annulus
bool is_circumference_mm(double length);                  ///< within

/// What the circumference of a mitral annulus, 30 to 400 mm, says: metres below 1, centimetres below
/// 20, else millimetres. None where the circumference would not be an annulus's in that unit.
std::optional<LengthUnit> guessed_unit(const Points& annulus);

/// Of a source whose unit is not known: what its annulus or, without one, its leaflets fit.
LengthUnit unit_of(const ImportSource& source);

/// Every coordinate and rest length times `factor`; diameters of chordae are millimetres already.
void scale(ImportSource& source, double factor);

/// Parts four times smaller or larger than the annulus: errors at "/leaflets/I/vertices_mm"
/// and "/chordae". `source` must be finite and not empty.
Errors mixed_units(const ImportSource& source);

}  // namespace coapt
