#include "lab/closures/stability_scenes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/presets/presets.h"
#include "core/valve/remodel.h"

namespace coapt {
namespace {

constexpr double kNarrowed = 0.7;  // of the anteroposterior diameter is left

/// Without bending, which the comparators do not know.
Valve base_valve(const std::string& name, int triangles) {
  Valve valve = *make_preset(name == kCommissures ? "human-normal" : name, triangles);
  valve.tissue.bending_n_mm = 0.0;
  if (name != kCommissures) return valve;
  valve.annulus_mm.col(1) *= kNarrowed;
  valve.name = name;
  return valve;
}

Valve remodelled(const Valve& valve, double dilation_percent, double tips_mm) {
  Remodelling change;
  change.ap_dilation_percent = dilation_percent;
  change.anterolateral_mm = change.posteromedial_mm = tips_mm * Vec3(1.0, 1.0, 1.0).normalized();
  return *remodel(valve, change);
}

/// Vertices that may move: inside the sheet, and not in a face that carries a chorda.
std::set<int> movable(const Valve& valve) {
  std::map<std::pair<int, int>, int> edges;
  std::set<int> free;
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      ++edges[std::minmax(valve.faces(f, k), valve.faces(f, (k + 1) % 3))];
      free.insert(valve.faces(f, k));
    }
  for (const auto& [edge, faces] : edges)
    if (faces == 1) {
      free.erase(edge.first);
      free.erase(edge.second);
    }
  for (const Chorda& chorda : valve.chordae)
    for (const ChordaSegment& segment : chorda.segments)
      for (int k = 0; k < 3 && segment.inserts; ++k)
        free.erase(valve.faces(segment.insertion.face, k));
  return free;
}

Vec3 centre(const Valve& valve, Segment segment) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    if (valve.segments[static_cast<std::size_t>(f)] != segment) continue;
    for (int k = 0; k < 3; ++k, ++count) sum += valve.rest_mm.row(valve.faces(f, k));
  }
  return sum / std::max(1, count);
}

std::set<int> neighbours(const Valve& valve, int v) {
  std::set<int> around;
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const auto face = valve.faces.row(f);
    if ((face.array() == v).any()) around.insert(face.begin(), face.end());
  }
  around.erase(v);
  return around;
}

/// The one of `vertices` that `distance` is least for.
template <class Distance>
int nearest(const std::set<int>& vertices, const Distance& distance) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int v : vertices)
    if (const double d = distance(v); d < least) {
      least = d;
      best = v;
    }
  return best;
}

/// The fibres back into the planes of their faces.
void lay_down_fibres(Valve& valve) {
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2)), fibre = valve.fibre.row(f);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    valve.fibre.row(f) = (fibre - fibre.dot(normal) * normal).normalized();
  }
}

}  // namespace

Valve with_slivers(Valve valve, double ratio) {
  const Points before = valve.rest_mm;
  std::set<int> free = movable(valve);
  const Vec3 places[] = {centre(valve, Segment::A2), centre(valve, Segment::P2),
                         before.row(valve.landmarks.anterolateral_commissure),
                         before.row(valve.landmarks.posteromedial_commissure)};
  for (const Vec3& place : places) {
    const int v = nearest(free, [&](int i) { return (before.row(i) - place.transpose()).norm(); });
    if (v < 0) break;
    const std::set<int> around = neighbours(valve, v);
    // The longest edge: what is left of it stays longer than validate() asks for.
    const int to = nearest(around, [&](int i) { return -(before.row(i) - before.row(v)).norm(); });
    valve.rest_mm.row(v) += (1.0 - ratio) * (before.row(to) - before.row(v));
    free.erase(v);
    for (const int i : around) free.erase(i);
  }
  lay_down_fibres(valve);
  return valve;
}

std::vector<DifficultyAxis> difficulty_axes() {
  return {{Difficulty::Step, {0.25, 0.5, 1.0, 1.5, 2.0, 4.0}, 1.0},
          {Difficulty::ContactStiffness, {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}, 1.0},
          {Difficulty::ChordaeModulus, {1.0, 2.0, 5.0, 10.0, 30.0, 100.0}, 1.0},
          {Difficulty::Pressure, {2.0, 5.0, 16.0, 30.0, 60.0, 100.0}, 16.0},
          {Difficulty::Slivers, {1.0, 0.5, 0.2, 0.1, 0.03, 0.01}, 1.0},
          {Difficulty::Resolution, {300.0, 650.0, 1300.0, 2600.0, 5200.0}, 650.0},
          {Difficulty::Dilation, {0.0, 8.0, 16.0, 24.0, 32.0, 40.0}, 0.0},
          {Difficulty::Tips, {0.0, 2.0, 4.0, 6.0, 9.0, 12.0}, 0.0}};
}

StabilityScene make_stability_scene(const std::string& name, Difficulty axis, double level) {
  const bool finer = axis == Difficulty::Resolution;
  StabilityScene scene{base_valve(name, finer ? static_cast<int>(level) : 650)};
  switch (axis) {
    case Difficulty::Step:
      scene.step = level;
      break;
    case Difficulty::ContactStiffness:
      scene.contact_stiffness = level;
      break;
    case Difficulty::ChordaeModulus:
      scene.valve.tissue.chordae_kpa *= level;
      break;
    case Difficulty::Pressure:
      scene.valve.pressure_kpa = level;
      break;
    case Difficulty::Slivers:
      scene.valve = with_slivers(scene.valve, level);
      break;
    case Difficulty::Resolution:
      break;
    case Difficulty::Dilation:
      scene.valve = remodelled(scene.valve, level, 0.0);
      break;
    case Difficulty::Tips:
      scene.valve = remodelled(scene.valve, 0.0, level);
      break;
  }
  return scene;
}

const char* to_string(Difficulty axis) {
  switch (axis) {
    case Difficulty::Step:
      return "step";
    case Difficulty::ContactStiffness:
      return "contact-stiffness";
    case Difficulty::ChordaeModulus:
      return "chordae-modulus";
    case Difficulty::Pressure:
      return "pressure";
    case Difficulty::Slivers:
      return "slivers";
    case Difficulty::Resolution:
      return "resolution";
    case Difficulty::Dilation:
      return "dilation";
    case Difficulty::Tips:
      return "tips";
  }
  return "";
}

}  // namespace coapt
