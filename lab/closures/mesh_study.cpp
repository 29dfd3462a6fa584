#include "lab/closures/mesh_study.h"

#include <cmath>
#include <mutex>
#include <sstream>

#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/valve/refine.h"
#include "lab/closures/matching_points.h"
#include "lab/closures/processor_time.h"
#include "lab/closures/varied_scenes.h"
#include "search/evaluator.h"
#include "search/parallel.h"
#include "search/studies/generality.h"

namespace coapt {
namespace {

constexpr const char* kColumns =
    "valve,scene,triangles,reference_triangles,trusted,seconds,rms_mm,leak_mm2,"
    "reference_leak_mm2\n";

struct ClosedScene {
  ClosedMesh mesh;
  ValveMeasure measure;
  bool trusted = false;
  double seconds = 0.0;
};

struct Scene {
  std::string valve;
  int number = 0;
  std::function<Expected<Valve>(int)> with_triangles;
};

/// On a mesh of `triangles`; refused where that mesh is no valid valve.
Expected<Valve> scene_on(const Scene& scene, const MeshStudyOptions& options, int triangles) {
  if (!options.refined) return scene.with_triangles(triangles);
  int made = options.triangles.front();
  Expected<Valve> valve = scene.with_triangles(made);
  for (; valve && made < triangles; made *= 4) valve = refine(*valve);
  return valve;
}

std::vector<Scene> scenes_of(const MeshStudyOptions& options) {
  std::vector<Scene> scenes;
  const std::uint64_t seed = options.seed;
  const auto varied = [seed](const Expected<Valve>& valve, int number) {
    return valve ? Expected<Valve>(varied_scene(*valve, seed, number)) : valve;
  };
  for (const std::string& preset : options.presets)
    for (int i = 0; i < options.scenes; ++i)
      scenes.push_back({preset, i, [varied, preset, i](int triangles) {
                          return varied(make_preset(preset, triangles), i);
                        }});
  for (const ParametricValve& drawn :
       random_anatomies(options.anatomies, seed, options.threads).dimensions) {
    const int i = static_cast<int>(scenes.size());
    scenes.push_back({drawn.name, i, [varied, drawn, i](int triangles) {
                        ParametricValve dimensions = drawn;
                        dimensions.triangles = triangles;
                        return varied(make_taut_valve(dimensions), i);
                      }});
  }
  return scenes;
}

ClosedScene close_scene(const Expected<Valve>& valve, const MeshStudyOptions& options) {
  ClosedScene closed;
  if (!valve) return closed;
  ClosureOptions closure;
  closure.membrane = options.membrane;
  const double start = processor_seconds();
  const ClosureResult result = close_valve(*valve, closure);
  closed.seconds = processor_seconds() - start;
  closed.trusted = coapt::trusted(result);
  closed.mesh = {*valve, {}, result.closed_mm};
  closed.measure = measure(*valve, result);
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
  point.leak_mm2 = closed.measure.leak.area_mm2;
  point.reference_leak_mm2 = reference.measure.leak.area_mm2;
  return point;
}

}  // namespace

std::vector<MeshPoint> study_meshes(const MeshStudyOptions& options,
                                    const std::function<void(int, int)>& progress) {
  const std::vector<Scene> scenes = scenes_of(options);
  const int planned = static_cast<int>(scenes.size());
  const auto resolutions = options.triangles.size();
  std::vector<MeshPoint> points(scenes.size() * resolutions);
  std::mutex mutex;
  int done = 0;
  for_each_index(planned, options.threads, [&](int i) {
    const Scene& scene = scenes[i];
    ClosedScene reference =
        close_scene(scene_on(scene, options, options.reference_triangles), options);
    if (reference.trusted) reference.mesh.coordinates = leaflet_coordinates(reference.mesh.valve);
    for (std::size_t r = 0; r < resolutions; ++r) {
      const int triangles = options.triangles[r];
      MeshPoint point =
          compared(close_scene(scene_on(scene, options, triangles), options), reference);
      point.valve = scene.valve;
      point.scene = scene.number;
      point.triangles = triangles;
      point.reference_triangles = options.reference_triangles;
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
    csv << p.valve << ',' << p.scene << ',' << p.triangles << ',' << p.reference_triangles << ','
        << (p.trusted ? "true" : "false") << ',' << p.seconds;
    for (const double number : {p.rms_mm, p.leak_mm2, p.reference_leak_mm2}) {
      csv << ',';
      if (p.trusted) csv << number;
    }
    csv << '\n';
  }
  return csv.str();
}

}  // namespace coapt
