#include "io/exchange/stated_axes.h"

#include "io/mesh/csv_table.h"

namespace coapt {
namespace {

constexpr std::size_t kHeadBytes =
    1024;  // Slicer's note stands in the first lines, of STL in its first 80 bytes

}  // namespace

namespace {

/// What follows Slicer's "# CoordinateSystem = " (LPS, RAS or IJK, or 0: RAS, 1: LPS, 2: IJK); empty: nothing.
std::string_view coordinate_system(std::string_view head) {
  constexpr std::string_view kKey = "CoordinateSystem = ";
  const std::size_t at = head.find(kKey);
  return at == std::string_view::npos ? std::string_view() : head.substr(at + kKey.size(), 3);
}

/// Of its coordinate system, or columns that are named after the axes.
std::optional<PatientAxes> axes_of_table(std::string_view head) {
  const std::string_view system = coordinate_system(head);
  if (system.starts_with("LPS") || system.starts_with('1')) return PatientAxes::LPS;
  if (system.starts_with("RAS") || system.starts_with('0')) return PatientAxes::RAS;
  const Expected<CsvTable> table = read_csv(head.substr(0, head.rfind('\n')), {"x"});
  if (!table) return {};
  if (table->axes == "ras") return PatientAxes::RAS;
  if (table->axes == "lps") return PatientAxes::LPS;
  if (table->has("x")) return {};
  if (table->has("r") && table->has("a")) return PatientAxes::RAS;
  if (table->has("l") && table->has("p")) return PatientAxes::LPS;
  return {};
}

}  // namespace

const char* to_string(PatientAxes axes) { return axes == PatientAxes::LPS ? "LPS" : "RAS"; }

std::optional<PatientAxes> stated_axes(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, kHeadBytes);
  const bool lps = head.find("SPACE=LPS") != std::string_view::npos;
  const bool ras = head.find("SPACE=RAS") != std::string_view::npos;
  if (lps == ras) return axes_of_table(head);
  return lps ? PatientAxes::LPS : PatientAxes::RAS;
}

bool is_in_voxels(std::string_view bytes) {
  const std::string_view system = coordinate_system(bytes.substr(0, kHeadBytes));
  return system.starts_with("IJK") || system.starts_with('2');
}

void turn_axes(Vec3& point_mm) { point_mm.head<2>() *= -1.0; }

void turn_axes(Points& points_mm) { points_mm.leftCols<2>() *= -1.0; }

void turn_axes(ImportedChorda& chorda) {
  turn_axes(chorda.insertion_mm);
  turn_axes(chorda.tip_mm);
  if (chorda.pressed_tip_mm) turn_axes(*chorda.pressed_tip_mm);
  for (ImportedSegment& segment : chorda.segments) turn_axes(segment.end_mm);
}

}  // namespace coapt
