// The study of leaks as tables, and its surfaces as files.
#pragma once

#include <string>
#include <vector>

#include "lab/leak/leak_study.h"

namespace coapt {

/// Columns: number, valve, repair, held_out, triangles, trusted, reference_mm2, surface_mm2, primal_mm2, dual_mm2, coarser_mm2 (the level before the
/// finest), openings, cells, widened, seconds; then of each measure M: M_mm2, M_error_mm2. Empty where there is no number.
std::string leaks_csv(const std::vector<LeakCase>& cases);

/// A row an opening: number, area_mm2, x_mm, y_mm, z_mm, normal_x, normal_y, normal_z.
std::string openings_csv(const std::vector<LeakCase>& cases);

/// A table in Markdown, a line a measure and half.
std::string agreements_table(const std::vector<LeakAgreement>& agreements);

/// {"number", "valve", "half_thickness_mm", "points_mm": [[x, y, z]], "faces", "annulus", "free_edge": [[from, to]]}
std::string surface_json(const LeakCase& one);

}  // namespace coapt
