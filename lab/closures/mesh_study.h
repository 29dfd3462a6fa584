// What the mesh does to areas and shapes: the same scenes closed on meshes of growing fineness, each
// judged by the finest.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/closure/closure.h"

namespace coapt {

struct MeshStudyOptions {
  std::vector<std::string> presets = {"human-normal", "human-functional-mr", "human-p2-prolapse",
                                      "porcine-1", "porcine-4"};
  int scenes = 12;     ///< varied ones (varied_scenes.h) of each preset
  int anatomies = 60;  ///< that no preset resembles, one varied scene of each
  std::uint64_t seed = 5;
  std::vector<int> triangles = {325, 650, 1300, 2600, 5200};
  int reference_triangles = 10400;
  /// Not made anew with so many triangles, but refined (core/valve/refine.h) from the coarsest, which
  /// quadruples them each time.
  bool refined = false;
  Membrane membrane = Membrane::Continuum;
  int threads = 0;  ///< 0: all cores
};

/// One scene on one mesh. A closure that is not trusted, or whose reference is not, has no numbers.
struct MeshPoint {
  std::string valve;
  int scene = 0;
  int triangles = 0, reference_triangles = 0;  ///< asked for
  bool trusted = false;
  double seconds = 0.0;
  double rms_mm = 0.0;  ///< from the reference at the same leaflet coordinates
  double leak_mm2 = 0.0, reference_leak_mm2 = 0.0;
};

/// In order of valve, scene, triangles; the same for any number of threads but for the times.
/// `progress`: scenes done and planned, one at a time.
std::vector<MeshPoint> study_meshes(const MeshStudyOptions& options,
                                    const std::function<void(int, int)>& progress = {});

/// Columns: valve, scene, triangles, reference_triangles, trusted, seconds, rms_mm, leak_mm2,
/// reference_leak_mm2. Empty where there is no number.
std::string mesh_csv(const std::vector<MeshPoint>& points);

}  // namespace coapt
