#include "io/exchange/stated_axes.h"

namespace coapt {
namespace {

constexpr std::size_t kHeadBytes =
    1024;  // Slicer's note stands in the first lines, of STL in its first 80 bytes

void turn(Vec3& point_mm) { point_mm.head<2>() *= -1.0; }

}  // namespace

const char* to_string(PatientAxes axes) { return axes == PatientAxes::LPS ? "LPS" : "RAS"; }

std::optional<PatientAxes> stated_axes(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, kHeadBytes);
  const bool lps = head.find("SPACE=LPS") != std::string_view::npos;
  const bool ras = head.find("SPACE=RAS") != std::string_view::npos;
  if (lps == ras) return {};
  return lps ? PatientAxes::LPS : PatientAxes::RAS;
}

void turn_axes(Points& points_mm) { points_mm.leftCols<2>() *= -1.0; }

void turn_axes(ImportedChorda& chorda) {
  turn(chorda.insertion_mm);
  turn(chorda.tip_mm);
  if (chorda.pressed_tip_mm) turn(*chorda.pressed_tip_mm);
  for (ImportedSegment& segment : chorda.segments) turn(segment.end_mm);
}

}  // namespace coapt
