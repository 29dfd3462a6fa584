#include "lab/closures/ablations.h"

#include <cmath>

#include "core/presets/presets.h"
#include "core/valve/remodel.h"
#include "lab/closures/closure_study.h"
#include "lab/closures/varied_scenes.h"

namespace coapt {
namespace {

using Tweak = void (*)(AblatedModel&);

constexpr double kSlackShare = 0.01;  // of the modulus before transition: next to nothing

/// A change of valve and options alone.
Ablation tweak(const char* group, const char* change, Tweak apply) {
  return {group, change, [apply](AblatedModel model, const AblationScene&) {
            apply(model);
            return model;
          }};
}

void average(double& a, double& b) { a = b = 0.5 * (a + b); }

void make_isotropic(Tissue& tissue) {
  average(tissue.circumferential_pre_kpa, tissue.radial_pre_kpa);
  average(tissue.circumferential_post_kpa, tissue.radial_post_kpa);
}

void pull_at_points(Valve& valve) {
  for (Chorda& chorda : valve.chordae)
    for (ChordaSegment& segment : chorda.segments) segment.zone_mm = 0.0;
}

void cut(Valve& valve, ChordaKind kind) {
  for (Chorda& chorda : valve.chordae)
    if (chorda.kind == kind) chorda.ruptured = true;
}

/// Another thickness of contact and picture; stiffness and mass per area of the leaflets stay.
template <int percent>
void thicken(AblatedModel& model) {
  Tissue& tissue = model.valve.tissue;
  const double factor = percent / 100.0;
  tissue.thickness_mm *= factor;
  for (double* per_volume :
       {&tissue.density_g_per_mm3, &tissue.circumferential_pre_kpa,
        &tissue.circumferential_post_kpa, &tissue.radial_pre_kpa, &tissue.radial_post_kpa})
    *per_volume /= factor;
}

void flatten(AblatedModel& model) {
  const Expected<Valve> flat = remodel(model.valve, {.annular_height_percent = 0.0});
  if (flat) model.valve = *flat;
}

Ablation resolution(int triangles) {
  return {"membrane and mesh", std::to_string(triangles) + " triangles",
          [triangles](AblatedModel model, AblationScene scene) {
            scene.triangles = triangles;
            model.valve = make_scene(scene);
            return model;
          }};
}

int insertions_beyond(const Chorda& chorda, std::size_t segment) {
  if (chorda.segments[segment].inserts) return 1;
  int count = 0;
  for (std::size_t s = segment + 1; s < chorda.segments.size(); ++s)
    if (chorda.segments[s].parent == static_cast<int>(segment))
      count += insertions_beyond(chorda, s);
  return count;
}

}  // namespace

std::string name_of(const AblationScene& scene) {
  return scene.variation < 0 ? scene.preset : scene.preset + "/" + std::to_string(scene.variation);
}

Valve make_scene(const AblationScene& scene) {
  const Valve valve = *make_preset(scene.preset, scene.triangles);
  return scene.variation < 0 ? valve
                             : varied_scene(valve, scene.seed, scene.variation, SceneRings::None);
}

Valve with_straight_chordae(const Valve& valve) {
  Valve rested = valve;
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    rested.annulus_mm.row(static_cast<Eigen::Index>(i)) = valve.rest_mm.row(valve.annulus[i]);
  for (PapillaryHead& head : rested.heads) head.tip_mm = head.rest_mm;
  for (Chorda& chorda : rested.chordae) chorda.ruptured = false;
  const ClosureResult closed = close_valve(rested);
  Valve straight = valve;
  straight.chordae.clear();
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    const Points& ends = closed.branch_points_mm[c];
    const Vec3 head = rested.heads[static_cast<std::size_t>(chorda.head)].tip_mm;
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      if (!chorda.segments[s].inserts) continue;
      double rest_mm = 0.0, present_mm = 0.0, per_mm = 0.0;  // along the path; length over section
      for (int at = static_cast<int>(s); at >= 0;) {
        const ChordaSegment& segment = chorda.segments[static_cast<std::size_t>(at)];
        const Vec3 from = segment.parent < 0 ? head : Vec3(ends.row(segment.parent));
        rest_mm += segment.rest_length_mm;
        present_mm += (Vec3(ends.row(at)) - from).norm();
        per_mm += insertions_beyond(chorda, static_cast<std::size_t>(at)) * segment.rest_length_mm /
                  (segment.diameter_mm * segment.diameter_mm);
        at = segment.parent;
      }
      Chorda one = chorda;
      one.id += "-" + std::to_string(s);
      one.segments = {chorda.segments[s]};
      one.segments[0].parent = -1;
      one.segments[0].rest_length_mm =
          (Vec3(ends.row(static_cast<Eigen::Index>(s))) - head).norm() * rest_mm / present_mm;
      one.segments[0].diameter_mm = std::sqrt(one.segments[0].rest_length_mm / per_mm);
      straight.chordae.push_back(one);
    }
  }
  return straight;
}

const std::vector<Ablation>& ablations() {
  static const std::vector<Ablation> all = {
      tweak("tissue", "isotropic moduli and transition",
            [](AblatedModel& m) {
              make_isotropic(m.valve.tissue);
              average(m.valve.tissue.circumferential_transition, m.valve.tissue.radial_transition);
            }),
      tweak("tissue", "isotropic moduli alone",
            [](AblatedModel& m) { make_isotropic(m.valve.tissue); }),
      tweak("tissue", "linear: modulus after transition",
            [](AblatedModel& m) {
              m.valve.tissue.circumferential_pre_kpa = m.valve.tissue.circumferential_post_kpa;
              m.valve.tissue.radial_pre_kpa = m.valve.tissue.radial_post_kpa;
            }),
      tweak("tissue", "slack before transition",
            [](AblatedModel& m) {
              m.valve.tissue.circumferential_pre_kpa *= kSlackShare;
              m.valve.tissue.radial_pre_kpa *= kSlackShare;
            }),
      tweak("membrane and mesh", "springs",
            [](AblatedModel& m) { m.closure.membrane = Membrane::Springs; }),
      tweak("membrane and mesh", "no bending",
            [](AblatedModel& m) { m.valve.tissue.bending_n_mm = 0.0; }),
      resolution(300),
      resolution(1300),
      resolution(2600),
      tweak("chordae", "no strut chordae",
            [](AblatedModel& m) { cut(m.valve, ChordaKind::Strut); }),
      tweak("chordae", "no basal chordae",
            [](AblatedModel& m) { cut(m.valve, ChordaKind::Basal); }),
      tweak("chordae", "neither",
            [](AblatedModel& m) {
              cut(m.valve, ChordaKind::Strut);
              cut(m.valve, ChordaKind::Basal);
            }),
      tweak("chordae", "straight instead of branched",
            [](AblatedModel& m) { m.valve = with_straight_chordae(m.valve); }),
      tweak("chordae", "pull at points", [](AblatedModel& m) { pull_at_points(m.valve); }),
      tweak("chordae", "ten times as stiff",
            [](AblatedModel& m) { m.valve.tissue.chordae_kpa *= 10.0; }),
      tweak("contact", "none of anterior with itself",
            [](AblatedModel& m) { m.closure.self_contact = SelfContact::NotAnterior; }),
      tweak("contact", "between leaflets alone",
            [](AblatedModel& m) { m.closure.self_contact = SelfContact::None; }),
      tweak("contact", "edges from the start",
            [](AblatedModel& m) { m.closure.edge_contact = true; }),
      tweak("contact", "0.5 mm thick", thicken<50>),
      tweak("contact", "1.5 mm thick", thicken<150>),
      tweak("contact", "2 mm thick", thicken<200>),
      tweak("annulus", "flat", flatten),
      tweak("the end", "mean of five end states",
            [](AblatedModel& m) {
              m.closure.samples = kThesisSamples;
              m.mean_of_samples = true;
            }),
      tweak("the end", "to residual 1e-6",
            [](AblatedModel& m) { m.closure = to_the_end(m.closure); }),
      tweak("to compare", "half the speed", [](AblatedModel& m) { m.closure.speed = 0.5; }),
      tweak("to compare", "method thesis",
            [](AblatedModel& m) { m.closure.method = Method::Thesis; }),
      tweak("to compare", "pressure - 10 %", [](AblatedModel& m) { m.valve.pressure_kpa *= 0.9; }),
      tweak("to compare", "pressure + 10 %", [](AblatedModel& m) { m.valve.pressure_kpa *= 1.1; })};
  return all;
}

}  // namespace coapt
