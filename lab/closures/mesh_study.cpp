#include "lab/closures/mesh_study.h"

#include <chrono>
#include <cmath>
#include <mutex>
#include <sstream>

#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "lab/closures/matching_points.h"
#include "lab/closures/varied_scenes.h"
#include "search/evaluator.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr const char* kColumns =
    "preset,scene,triangles,trusted,seconds,rms_mm,orifice_mm2,gap_mm2,leak_mm2,"
    "reference_orifice_mm2,reference_gap_mm2,reference_leak_mm2\n";

struct ClosedScene {
  ClosedMesh mesh;
  ValveMeasure measure;
  bool trusted = false;
  double seconds = 0.0;
};

ClosedScene close_scene_of(const Valve& preset, const MeshStudyOptions& options, int scene) {
  using Clock = std::chrono::steady_clock;
  ClosedScene closed;
  closed.mesh.valve = varied_scene(preset, options.seed, scene);
  ClosureOptions closure;
  closure.membrane = options.membrane;
  const auto start = Clock::now();
  const ClosureResult result = close_valve(closed.mesh.valve, closure);
  closed.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  closed.trusted = coapt::trusted(result);
  closed.mesh.closed_mm = result.closed_mm;
  closed.measure = measure(closed.mesh.valve, result);
  return closed;
}

MeshPoint compared(const ClosedScene& closed, const ClosedScene& reference) {
  MeshPoint point;
  point.trusted = closed.trusted && reference.trusted;
  point.seconds = closed.seconds;
  if (!point.trusted) return point;
  const Points there = matching_points_mm(closed.mesh.valve, reference.mesh);
  const Eigen::VectorXd apart = (closed.mesh.closed_mm - there).rowwise().norm();
  point.rms_mm = std::sqrt(apart.squaredNorm() / static_cast<double>(apart.size()));
  point.orifice_mm2 = closed.measure.orifice.area_mm2;
  point.gap_mm2 = closed.measure.coaptation.gap_area_mm2;
  point.leak_mm2 = leak_mm2(closed.measure);
  point.reference_orifice_mm2 = reference.measure.orifice.area_mm2;
  point.reference_gap_mm2 = reference.measure.coaptation.gap_area_mm2;
  point.reference_leak_mm2 = leak_mm2(reference.measure);
  return point;
}

}  // namespace

std::vector<MeshPoint> study_meshes(const MeshStudyOptions& options,
                                    const std::function<void(int, int)>& progress) {
  const auto resolutions = options.triangles.size();
  const auto presets = options.presets.size();
  std::vector<std::vector<Valve>> valves(presets);  // [preset][resolution, the reference last]
  for (std::size_t p = 0; p < presets; ++p) {
    for (const int triangles : options.triangles)
      valves[p].push_back(*make_preset(options.presets[p], triangles));
    valves[p].push_back(*make_preset(options.presets[p], options.reference_triangles));
  }
  const int planned = static_cast<int>(presets) * options.scenes;
  std::vector<MeshPoint> points(static_cast<std::size_t>(planned) * resolutions);
  std::mutex mutex;
  int done = 0;
  for_each_index(planned, options.threads, [&](int i) {
    const auto p = static_cast<std::size_t>(i / options.scenes);
    const int scene = i % options.scenes;
    ClosedScene reference = close_scene_of(valves[p].back(), options, scene);
    reference.mesh.coordinates = leaflet_coordinates(reference.mesh.valve);
    for (std::size_t r = 0; r < resolutions; ++r) {
      MeshPoint point = compared(close_scene_of(valves[p][r], options, scene), reference);
      point.preset = options.presets[p];
      point.scene = scene;
      point.triangles = options.triangles[r];
      points[static_cast<std::size_t>(i) * resolutions + r] = point;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    if (progress) progress(++done, planned);
  });
  return points;
}

std::string mesh_csv(const std::vector<MeshPoint>& points) {
  std::ostringstream csv;
  csv << kColumns;
  for (const MeshPoint& p : points) {
    csv << p.preset << ',' << p.scene << ',' << p.triangles << ',' << (p.trusted ? "true" : "false")
        << ',' << p.seconds;
    for (const double number :
         {p.rms_mm, p.orifice_mm2, p.gap_mm2, p.leak_mm2, p.reference_orifice_mm2,
          p.reference_gap_mm2, p.reference_leak_mm2}) {
      csv << ',';
      if (p.trusted) csv << number;
    }
    csv << '\n';
  }
  return csv.str();
}

}  // namespace coapt
