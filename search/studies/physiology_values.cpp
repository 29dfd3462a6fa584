#include "search/studies/physiology_values.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "core/closed/closed_valve.h"
#include "core/metrics/annular_force.h"
#include "core/metrics/leaflet_sides.h"
#include "core/metrics/loads.h"
#include "core/opened/opened_valve.h"
#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/pressure_unit.h"
#include "core/valve/ruptures.h"
#include "search/parallel.h"

namespace coapt {
namespace {

constexpr double kUnknown = PhysiologyValues::kUnknown;
constexpr double kSqueezed = -0.1;  // strain along the fibres

double face_area_mm2(const Valve& valve, Index face) {
  const Vec3 a = valve.rest_mm.row(valve.faces(face, 0)),
             b = valve.rest_mm.row(valve.faces(face, 1)),
             c = valve.rest_mm.row(valve.faces(face, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

double trunk_n(const Chorda& chorda, const std::vector<double>& tension_n) {
  double sum = 0.0;
  for (std::size_t s = 0; s < chorda.segments.size(); ++s)
    if (chorda.segments[s].parent < 0) sum += tension_n[s];
  return sum;
}

/// Mean and largest; NaN of none.
struct Tensions {
  double sum_n = 0.0, largest_n = kUnknown;
  int count = 0;
  void add(double tension_n) {
    sum_n += tension_n;
    largest_n = std::fmax(largest_n, tension_n);
    ++count;
  }
  double mean_n() const { return count > 0 ? sum_n / count : kUnknown; }
};

/// Mean tension of the trunks of marginal chordae that hold A2.
double a2_marginal_n(const Valve& valve, const ClosureResult& closure) {
  Tensions a2;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.kind == ChordaKind::Marginal && !chorda.ruptured &&
        held_by(valve, chorda) == Segment::A2)
      a2.add(trunk_n(chorda, closure.tension_n[c]));
  }
  return a2.mean_n();
}

void read_chordae(const Valve& valve, const ClosureResult& closure, PhysiologyValues& values) {
  Tensions struts, anterior;
  std::array<Vec3, 2> muscle_n = {Vec3::Zero(), Vec3::Zero()};
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.ruptured) continue;
    const PapillaryHead& head = valve.heads[static_cast<std::size_t>(chorda.head)];
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const ChordaSegment& segment = chorda.segments[s];
      if (segment.parent >= 0) continue;
      const Vec3 end = segment.inserts
                           ? position(segment.insertion, valve.faces, closure.closed_mm)
                           : Vec3(closure.branch_points_mm[c].row(static_cast<Index>(s)));
      muscle_n[head.side == Side::Posteromedial ? 1 : 0] +=
          closure.tension_n[c][s] * (end - head.tip_mm).normalized();
    }
    const double trunk = trunk_n(chorda, closure.tension_n[c]);
    if (chorda.kind == ChordaKind::Strut) struts.add(trunk);
    const std::optional<Segment> held = held_by(valve, chorda);
    if (chorda.kind == ChordaKind::Marginal && held && leaflet_of(*held) == Leaflet::Anterior)
      anterior.add(trunk);
  }
  values.strut_n = struts.mean_n();
  values.anterior_marginal_n = anterior.largest_n;
  values.strut_over_marginal = values.strut_n / values.anterior_marginal_n;
  values.a2_marginal_n = a2_marginal_n(valve, closure);
  values.muscle_anterolateral_n = muscle_n[0].norm();
  values.muscle_posteromedial_n = muscle_n[1].norm();
}

void read_strains(const Valve& valve, const ClosureResult& closure, PhysiologyValues& values) {
  const std::vector<FaceStrain> strains = face_strains(valve, closure.closed_mm);
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  double a2 = 0.0, radial = 0.0, circumferential = 0.0, grown = 0.0, posterior = 0.0,
         squeezed = 0.0;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const FaceStrain& strain = strains[static_cast<std::size_t>(f)];
    const double area = face_area_mm2(valve, f);
    if (valve.segments[static_cast<std::size_t>(f)] == Segment::A2) {
      a2 += area;
      radial += area * strain.radial;
      circumferential += area * strain.circumferential;
      grown += area * std::sqrt(std::max(
                          0.0, (1.0 + 2.0 * strain.radial) * (1.0 + 2.0 * strain.circumferential)));
    }
    if (sides[static_cast<std::size_t>(f)] != Leaflet::Posterior) continue;
    posterior += area;
    if (strain.circumferential < kSqueezed) squeezed += area;
  }
  values.a2_radial_percent = 100.0 * radial / a2;
  values.a2_circumferential_percent = 100.0 * circumferential / a2;
  values.a2_areal_percent = 100.0 * (grown / a2 - 1.0);
  values.posterior_squeezed_share = squeezed / posterior;
}

double septal_lateral_n(const Valve& valve, const ClosureResult& closure) {
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  double sum = 0.0;
  for (const Vec3& pull : support_forces(valve, closure).annulus_n)
    sum += std::abs(pull.dot(frame.y));
  return 0.5 * sum;
}

double papillary_distance_mm(const Valve& valve) {
  return (papillary_tip_mm(valve, Side::Posteromedial) -
          papillary_tip_mm(valve, Side::Anterolateral))
      .norm();
}

/// The trials of one valve; each writes fields of its own, from any thread.
class Trials {
 public:
  Trials(const Valve& valve, const PhysiologyOptions& options) : valve_(valve), options_(options) {}

  void run(PhysiologyValues& values) {
    for (const PhysiologyTrial trial : kPhysiologyTrials)
      if (trial == PhysiologyTrial::Rest ||
          std::find(options_.trials.begin(), options_.trials.end(), trial) != options_.trials.end())
        add(trial, values);
    std::mutex mutex;
    int done = 0;
    const int count = static_cast<int>(jobs_.size());
    for_each_index(count, options_.threads, [&](int i) {
      if (options_.budget.is_cancelled())
        unfinished_ = true;
      else
        jobs_[static_cast<std::size_t>(i)]();
      const std::lock_guard lock(mutex);
      if (options_.progress) options_.progress(++done, count);
    });
    values.unfinished = unfinished_;
  }

 private:
  using Value = double PhysiologyValues::*;

  ClosureResult close(const Valve& valve) const {
    ClosureOptions closing;
    closing.budget = options_.budget;
    ClosureResult closure = close_valve(valve, closing);
    note(closure);
    return closure;
  }

  void note(const ClosureResult& closure) const {
    if (closure.unfinished) unfinished_ = true;
  }

  double leak_of(const Valve& valve) const {
    const ClosureResult closure = close(valve);
    return trusted(closure) ? measure_leak(valve, closure.closed_mm).area_mm2 : kUnknown;
  }

  void look_at_rest(PhysiologyValues& values) const {
    values.papillary_systole_mm = papillary_distance_mm(valve_);
    if (const Expected<Valve> open = in_diastole(valve_))
      values.papillary_diastole_mm = papillary_distance_mm(*open);
    const ClosureResult closure = close(valve_);
    if (!trusted(closure)) return;
    const ValveMeasure measured = measure(valve_, closure);
    const Tenting tenting = measure_tenting(valve_, closure.closed_mm);
    const AnnulusFrame plane = annulus_frame(valve_, AnnulusAxis::SaddlePeak);
    values.leak_mm2 = measured.leak.area_mm2;
    values.coaptation_length_mm = measured.coaptation.sections[4].height_mm;
    values.coaptation_height_mm = measured.coaptation.height_mean_mm;
    values.depth_hinge_mm = tenting.height_mm;
    values.depth_plane_mm = -into_frame(plane, tenting.coaptation_point_mm).z();
    values.tenting_area_mm2 = tenting.area_mm2;
    read_chordae(valve_, closure, values);
    values.muscle_share = (values.muscle_anterolateral_n + values.muscle_posteromedial_n) /
                          (1e-3 * valve_.pressure_kpa * measured.annulus.area_mm2);
    values.annular_force_n = septal_lateral_n(valve_, closure);
    read_strains(valve_, closure, values);
  }

  void cut_struts(PhysiologyValues& values) const {
    Valve cut = valve_;
    for (Chorda& chorda : cut.chordae)
      if (chorda.kind == ChordaKind::Strut) chorda.ruptured = true;
    const ClosureResult closure = close(cut);
    if (trusted(closure)) values.a2_marginal_cut_n = a2_marginal_n(cut, closure);
  }

  void open(const Expected<Valve>& valve, double& area_mm2, double& gradient_mmhg) const {
    if (!valve) return;
    OpeningOptions opening;
    opening.budget = options_.budget;
    const Expected<OpenedValve> opened = open_valve(*valve, opening);
    if (opened) note(opened->closure);
    if (!opened || !trusted(opened->closure)) return;
    area_mm2 = opened->measure.opening_area_mm2;
    gradient_mmhg = opened->measure.gradient_mmhg;
  }

  Expected<Valve> with_own_ring(int below) const {
    return apply_plan(valve_, {{Annuloplasty{OwnRing{below}}}});
  }

  void add_pressure(double mmhg, double& leak) {
    jobs_.emplace_back([this, mmhg, &leak] {
      Valve loaded = valve_;
      loaded.pressure_kpa = mmhg / kMmhgPerKpa;
      leak = leak_of(loaded);
    });
  }

  void add_ring(double size_mm, double& leak) {
    jobs_.emplace_back([this, size_mm, &leak] {
      const Expected<Valve> ringed =
          apply_plan(valve_, {{Annuloplasty{CatalogueRing{"generic-classic", size_mm}}}});
      if (ringed) leak = leak_of(*ringed);
    });
  }

  void add_ring_opening(int below, double& area_mm2, double& gradient_mmhg) {
    jobs_.emplace_back([this, below, &area_mm2, &gradient_mmhg] {
      open(with_own_ring(below), area_mm2, gradient_mmhg);
    });
  }

  void add(PhysiologyTrial trial, PhysiologyValues& values) {
    PhysiologyValues& v = values;
    switch (trial) {
      case PhysiologyTrial::Rest:
        jobs_.emplace_back([this, &v] { look_at_rest(v); });
        break;
      case PhysiologyTrial::StrutsCut:
        jobs_.emplace_back([this, &v] { cut_struts(v); });
        break;
      case PhysiologyTrial::Pressures:
        add_pressure(60.0, v.leak_60_mm2);
        add_pressure(90.0, v.leak_90_mm2);
        add_pressure(200.0, v.leak_200_mm2);
        break;
      case PhysiologyTrial::Rings:
        add_ring(40.0, v.ring_40_mm2);
        add_ring(38.0, v.ring_38_mm2);
        add_ring(36.0, v.ring_36_mm2);
        add_ring(34.0, v.ring_34_mm2);
        add_ring(32.0, v.ring_32_mm2);
        add_ring(30.0, v.ring_30_mm2);
        break;
      case PhysiologyTrial::Opening:
        jobs_.emplace_back([this, &v] { open(valve_, v.opening_mm2, v.gradient_mmhg); });
        break;
      case PhysiologyTrial::RingOpenings:
        add_ring_opening(0, v.opening_own_0_mm2, v.gradient_own_0_mmhg);
        add_ring_opening(2, v.opening_own_2_mm2, v.gradient_own_2_mmhg);
        add_ring_opening(4, v.opening_own_4_mm2, v.gradient_own_4_mmhg);
        break;
      case PhysiologyTrial::Clips:
        jobs_.emplace_back([this, &v] {
          open(apply_plan(valve_, {{EdgeToEdge{EdgeDevice::Clip, 0.5}}}), v.opening_clip_mm2,
               v.clip_gradient_mmhg);
        });
        jobs_.emplace_back([this, &v] {
          double ignored = 0.0;
          open(apply_plan(valve_, {{EdgeToEdge{EdgeDevice::Clip, 0.44},
                                    EdgeToEdge{EdgeDevice::Clip, 0.56}}}),
               v.opening_two_clips_mm2, ignored);
        });
        break;
    }
  }

  const Valve& valve_;
  const PhysiologyOptions& options_;
  std::vector<std::function<void()>> jobs_;
  mutable std::atomic<bool> unfinished_ = false;
};

}  // namespace

PhysiologyValues physiology_values(const Valve& valve, const PhysiologyOptions& options) {
  PhysiologyOptions asked = options;
  const auto wants = [&](PhysiologyTrial trial) {
    return std::find(asked.trials.begin(), asked.trials.end(), trial) != asked.trials.end();
  };
  // Shares of the opening need the opening.
  if (wants(PhysiologyTrial::RingOpenings) || wants(PhysiologyTrial::Clips))
    asked.trials.push_back(PhysiologyTrial::Opening);
  PhysiologyValues v;
  Trials(valve, asked).run(v);
  v.struts_cut_ratio = v.a2_marginal_cut_n / v.a2_marginal_n;
  v.leak_200_over_60 = v.leak_60_mm2 > 1.0 ? v.leak_200_mm2 / v.leak_60_mm2 : kUnknown;
  v.ring_opening_share =
      std::max({v.opening_own_0_mm2, v.opening_own_2_mm2, v.opening_own_4_mm2}) / v.opening_mm2;
  v.gradient_slope_mmhg_mm =
      (v.gradient_own_4_mmhg - v.gradient_own_0_mmhg) / (4.0 * kRingSizeStep_mm);
  v.clip_share = v.opening_clip_mm2 / v.opening_mm2;
  v.two_clips_share = v.opening_two_clips_mm2 / v.opening_clip_mm2;
  return v;
}

}  // namespace coapt
