// How the gap depends on the mesh: on surfaces whose gap is known exactly, and on closures of valves.
// Beside it what nine sections would give (the width in each that is out of contact, times their
// spacing), which is how the gap was measured up to release 0.1.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace coapt {

struct GapPoint {
  std::string scene;
  int triangles = 0;
  double gap_mm2 = 0.0;
  double sections_mm2 = 0.0;  ///< of nine sections
  double expected_mm2 = 0.0;  ///< exact for surfaces, else that of the finest mesh
  double orifice_mm2 = 0.0;   ///< of closures, to compare with; NaN for surfaces
  double microseconds = 0.0;  ///< the least of five measurements of the gap
};

struct GapStudyOptions {
  std::vector<int> surface_triangles = {650, 1300, 2600, 5200, 10400};
  std::vector<int> closure_triangles = {650, 1300, 2600, 5200};
};

/// Scene by scene, meshes from coarse to fine. `progress`: done and planned.
/// - "oblique slit": a curved anterior sheet before a plane, nearest to it along a line that runs at
///   17 degrees to the rows of the mesh.
/// - "crescent": an anterior sheet within a cylinder, nearest to it along an arc.
/// - closures of presets, with their annulus dilated where the name says so.
std::vector<GapPoint> study_gap(const GapStudyOptions& options,
                                const std::function<void(int, int)>& progress = {});

}  // namespace coapt
