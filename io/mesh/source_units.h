// The units of what is imported. Meshes and tables carry none, and programs write metres, centimetres and millimetres.
#pragma once

#include "core/valve/problem_list.h"
#include "io/mesh/import_valve.h"

namespace coapt {

/// How many millimetres a unit has.
double in_mm(LengthUnit unit);

/// "mm", "Centimetres", "inch", "m", in either spelling and any case.
std::optional<LengthUnit> unit_named(std::string_view name);

inline constexpr Range kCircumferenceMm = {30.0, 400.0};  // of the annulus
bool is_circumference_mm(double length);                  ///< within

/// That of adults and children; others are looked at.
inline constexpr Range kUsualCircumferenceMm = {70.0, 200.0};

struct UnitReading {
  LengthUnit unit = LengthUnit::Millimetre;
  std::string reason;
  bool look = false;
  double confidence = 1.0;
};

/// What the files say or else the only unit in which the circumference of the annulus or, without one, the leaflets' size is usual.
/// Where several are or none is: the larger unit of those that programs write, to be looked at.
UnitReading unit_of(const ImportSource& source);

/// Of an annulus whose file states its unit: that of all files if the leaflets agree in size, else the annulus alone becomes
/// millimetres.
void take_annulus_unit(ImportSource& source, LengthUnit unit);

/// glTF is in metres by its specification, which not all programs heed: leaflets from it that only so are as large as the annulus
/// beside them become of the annulus's unit, which is said.
void take_metres(ImportSource& source);

/// Chordae, tips and landmarks whose tables state another unit than `unit` become of it; one decision for each.
std::vector<ImportDecision> take_part_units(ImportSource& source, LengthUnit unit);

/// Leaflets without an annulus whose size no heart has: an error at "/leaflets".
Errors impossible_size(const ImportSource& source, LengthUnit unit);

/// Every coordinate and rest length times `factor`; diameters of chordae are millimetres already.
void scale(ImportSource& source, double factor);

/// What a mirror image shows: every x has the other sign, every triangle the other winding.
void unmirror(ImportSource& source);

/// Parts four times smaller or larger than the annulus: errors at "/leaflets/I/vertices_mm"
/// and "/chordae". `source` must be finite and not empty.
Errors mixed_units(const ImportSource& source);

}  // namespace coapt
