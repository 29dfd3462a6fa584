// A search's result written by hand, every field of it filled. Rank 1 closes the valve and ties with rank
// 2, which has no sutures; rank 3 is an own plan that failed: nothing of its region is known.
#pragma once

#include <cmath>
#include <limits>

#include "io/json/plans_json.h"
#include "search/plans/disturbance.h"

namespace coapt {

namespace plans_scene {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Closed {
  double leak_mm2 = 0.0, height_mm = 0.0, tension_n = 0.0;
};

/// Heights fall to half towards the commissures.
inline ValveMeasure measured(const Closed& closed) {
  ValveMeasure measure;
  measure.leak = {closed.leak_mm2, 0.99 * closed.leak_mm2, 1.01 * closed.leak_mm2, {}};
  if (closed.leak_mm2 > 0.5)
    measure.leak.openings = {{closed.leak_mm2,
                              Vec3(3.0, -2.0, 0.0),
                              Vec3::UnitZ(),
                              {Segment::P3, Segment::A3},
                              2.0,
                              {}}};
  Coaptation& coaptation = measure.coaptation;
  for (std::size_t i = 0; i < coaptation.sections.size(); ++i) {
    const double along = 0.1 + 0.1 * static_cast<double>(i), aside = 2.0 * along - 1.0;
    const double height = closed.height_mm * (1.25 - 0.78 * aside * aside);
    coaptation.sections[i] = {along, height, 0.9 + closed.leak_mm2 / 30.0, height > 2.0};
  }
  coaptation.height_mean_mm = closed.height_mm;
  coaptation.height_min_mm = coaptation.height_p10_mm = 0.7 * closed.height_mm;
  coaptation.distance_max_mm = 0.9 + closed.leak_mm2 / 30.0;
  measure.annulus = {29.4, 38.1, 112.0, 880.0, 5.6};
  measure.tenting_height_mm = 9.0 - 0.4 * closed.height_mm;
  measure.tenting_area_mm2 = 180.0 - 9.0 * closed.height_mm;
  measure.tension_max_n = closed.tension_n;
  measure.tension_sum_n = 19.0 * closed.tension_n;
  measure.strain_circumferential_max = 0.12;
  measure.strain_radial_max = 0.31;
  return measure;
}

/// Leaks more the longer the suture and the further outwards the tip.
inline LeakMap leak_map(const std::string& muscle, double steepness) {
  LeakMap map{muscle, {}};
  for (int l = 0; l < kRegionLengths; ++l) {
    map.leak_mm2.emplace_back();
    for (int a = 0; a < kRegionAngles; ++a)
      map.leak_mm2.back().push_back(
          std::max(0.0, steepness * ((l - 4) / 4.0 + (a - 5) / 5.0 - 0.55)));
  }
  return map;
}

/// @param tolerated_mm as far as the valve bears; then 2 mm2 more leak each millimetre.
inline std::vector<RemodellingCurve> remodelling(double tolerated_mm) {
  std::vector<RemodellingCurve> curves;
  double share = 1.0;
  for (const char* direction : {"apical", "outwards", "posterior", "all three"}) {
    curves.push_back({direction, {}});
    for (int mm = 0; mm <= 6; ++mm)
      curves.back().leak_mm2.push_back(0.2 + std::max(0.0, 2.0 * (mm - share * tolerated_mm)));
    share *= 0.8;
  }
  curves.back().leak_mm2.back() = kUnknown;
  return curves;
}

inline std::vector<Gate> gates(double movement_mm) {
  using enum GateSeverity;
  const std::string moved = std::to_string(static_cast<int>(movement_mm)) + " mm";
  return {{"ring_width", Pass, "ring 32.0 mm wide, annulus 38.1 mm", "Carpentier 1983"},
          {"stenosis", movement_mm > 8.0 ? Warn : Pass,
           "ring of 32 mm; 27 mm or less predicts functional stenosis", "Nishida 2018"},
          {"undersizing", Pass, "2.1 ring sizes below the annulus", "Braun 2008"},
          {"papillary_movement",
           movement_mm > 15.0   ? Reject
           : movement_mm > 10.0 ? Warn
                                : Pass,
           "posteromedial muscle moved by " + moved +
               "; more than 10 mm is unusual, more than 15 mm rejected",
           "thesis 4.2.3"},
          {"filling", NotAssessed, "filling is not simulated", "limits of coapt"}};
}

inline RankedPlan first() {
  RankedPlan plan;
  plan.rank = 1;
  plan.plan.steps = {
      Annuloplasty{CatalogueRing{"generic-classic", 32.0}},
      PapillaryApproximation{Side::Anterolateral, Anchor::IpsilateralTrigone, 0.25, 21.5},
      PapillaryApproximation{Side::Posteromedial, Anchor::SaddlePeak, 0.25, 24.0}};
  plan.description = {
      "annuloplasty: generic-classic ring, size 32 mm",
      "papillary relocation: anterolateral muscle to its trigone, suture 21.5 mm",
      "papillary relocation: posteromedial muscle to the saddle peak, suture 24 mm"};
  plan.cost = 6.42;
  plan.subset_cost = 6.1;
  plan.subset_nodes = 17;
  plan.measure = measured({0.3, 6.8, 0.61});
  plan.effort = {4.6, 11.5, 2.1, 3};
  plan.region.leak_mm2 = {0.3, 0.42, 0.51, 1.4, 5.6, 0.992, 1.0, 1.0};
  plan.region.closures = 1089;
  plan.region.margin_to_leak = {0.75, 4.0, 0.71};
  plan.region.maps = {leak_map("both", 5.6), leak_map("anterolateral", 2.0),
                      leak_map("posteromedial", 3.9)};
  plan.region.remodelling = remodelling(4.0);
  plan.region.indices = {{0.52, 0.24, 0.06}, {0.66, 0.38, 0.11}};
  plan.region.independent_leak_mm2 = {0.3, 0.36, 0.4, 1.1, 3.2, 1.0, 1.0, 1.0};
  plan.gates = gates(11.5);
  plan.warnings = warnings_of(plan.gates);
  plan.warnings.push_back("the plan leaks more than 5 mm² with some error of execution");
  plan.fine_levels = 1;
  plan.fine = PlanClosure{ClosureStatus::Converged, false, 0.4, 6.1, 0.92, 0.63};
  plan.fine_cost_change = 1.5;
  plan.own_mesh_rank = 2;
  plan.model = ModelSpread{8, 1, 0.9, 1.2, 3.5};
  plan.acceptable_probability = 0.98;
  plan.is_acceptable = plan.simplest_of_class = plan.ties_with_next = true;
  plan.of_class = 1;
  plan.probability_outranks_next = 0.5;
  plan.pareto = true;
  return plan;
}

inline RankedPlan second() {
  RankedPlan plan;
  plan.rank = 2;
  plan.plan.steps = {Annuloplasty{OwnRing{4}}};
  plan.description = {
      "annuloplasty: ring in the annulus's own shape, undersized by 4 sizes (transverse 38.1 to "
      "30.1 "
      "mm)"};
  plan.cost = 6.87;
  plan.subset_cost = 7.3;
  plan.subset_nodes = 17;
  plan.measure = measured({1.9, 4.9, 0.74});
  plan.effort = {0.0, 0.0, 4.0, 1};
  plan.region.leak_mm2 = {1.9, 3.1, 1.6, 6.2, 11.8, 0.89, 0.99, 1.0};
  plan.region.closures = 1089;
  plan.region.failures = 2;
  plan.region.margin_to_leak = {0.0, 0.0, 0.0};
  plan.region.maps = {leak_map("both", 8.4)};
  plan.region.remodelling = remodelling(1.5);
  plan.region.indices = {{0.18, 0.41, 0.3}, {0.2, 0.47, 0.36}};
  plan.region.independent_leak_mm2 = {1.9, 2.9, 1.5, 5.8, 9.9, 0.9, 1.0, 1.0};
  plan.gates = gates(0.0);
  plan.acceptable_probability = 0.96;
  plan.is_acceptable = true;
  plan.of_class = 1;
  plan.probability_outranks_next = 0.999;
  plan.pareto = true;
  return plan;
}

inline RankedPlan third() {
  const LeakStatistics unknown = {31.0,     kUnknown, kUnknown, kUnknown,
                                  kUnknown, kUnknown, kUnknown, kUnknown};
  RankedPlan plan;
  plan.rank = 3;
  plan.name = "own/suture.json";
  plan.plan.steps = {PapillaryApproximation{Side::Posteromedial, Anchor::AnnulusPoint, 0.31, 19.0}};
  plan.description = {
      "papillary relocation: posteromedial muscle to the annulus, 24 % of the way from the "
      "saddle peak to the anterolateral commissure, suture 19 mm"};
  plan.cost = 10034.2;
  plan.subset_cost = 10034.2;
  plan.subset_nodes = 1;
  plan.status = ClosureStatus::StepLimit;
  plan.crossing = true;
  plan.measure = measured({38.0, 1.8, 2.4});
  plan.effort = {0.0, 16.2, 0.0, 1};
  plan.region.leak_mm2 = plan.region.independent_leak_mm2 = unknown;
  plan.region.closures = 1;
  plan.region.failures = 1;
  plan.region.margin_to_leak = {kUnknown, kUnknown, kUnknown};
  plan.region.indices = {{kUnknown, kUnknown, kUnknown}, {kUnknown, kUnknown, kUnknown}};
  plan.gates = gates(16.2);
  plan.warnings = warnings_of(plan.gates);
  plan.of_class = 2;
  plan.simplest_of_class = true;
  plan.probability_outranks_next = kUnknown;
  return plan;
}

}  // namespace plans_scene

inline SearchResult search_result() {
  using namespace plans_scene;
  SearchResult result;
  result.before.measure = measured({52.0, 2.6, 0.48});
  result.plans = {first(), second(), third()};
  for (RankedPlan& plan : result.plans) plan.estimates.leak_mm2.value = plan.measure.leak.area_mm2;
  result.before_estimates.leak_mm2.value = result.before.measure.leak.area_mm2;
  result.fine_mesh = {1, 2592, PlanClosure{ClosureStatus::Converged, false, 47.25, 2.4, 3.1, 0.47},
                      4};
  result.model_draws = 8;
  result.before_under_draws = ModelSpread{8, 0, 50.0, 12.5, 71.0};
  result.model_closures = 32;
  result.any_acceptable = true;
  result.progress = {{1, 231.0}, {2, 96.0},  {5, 41.0}, {14, 17.5},
                     {60, 9.9},  {212, 7.4}, {980, 6.3}};
  result.random_progress = {{1, 240.0}, {10, 61.0}, {100, 22.0}, {1000, 11.5}, {2000, 10.2}};
  result.ladder = {{0, 1, 60, 0.58, true},
                   {1, 5, 40, 0.91, false},
                   {5, 17, 12, 0.97, false},
                   {17, 1089, 0, kUnknown, false}};
  result.cut = {
      {"papillary suture of the anterolateral muscle",
       "its tip is 24.1 mm from its trigone, within mean + sd of normal hearts (27.3 mm)"},
      {"neochordae", "no marginal chorda is ruptured"}};
  result.branches = 38;
  result.plans_possible = 45'678'901;
  result.plans_tried = 1214;
  result.stop = SearchStop::EvaluationLimit;
  result.closures = 6120;
  result.evaluations = 2000;
  result.closures_known = 310;
  result.closures_not_converged = 12;
  result.closures_crossed = 3;
  result.seconds = 84.25;
  return result;
}

/// No option is the default.
inline SearchRequest search_request() {
  SearchRequest request;
  SearchOptions& options = request.options;
  options.evaluations = 1500;
  options.seed = 18446744073709551615u;
  options.threads = 2;
  options.plans = 3;
  options.region_points = 729;
  options.evidence = false;
  options.rank_by_price = true;
  options.fine_levels = 2;
  options.model_draws = 16;
  options.seconds = 600.5;
  options.no_improvement = 400;
  options.target_mm2 = 0.25;
  options.rules.fixed.steps = {Annuloplasty{CatalogueRing{"generic-classic", 30.0}}};
  options.rules.forbidden = {"chordal_transfer", "papillary_approximation:saddle_peak"};
  options.rules.most_neochordae = 2;
  options.rules.own_ring = true;
  options.rules.chordal_length_change = true;
  options.rules.chordal_excision = true;
  options.rules.chordal_transfer = true;
  options.rules.leaflet_resection = true;
  options.rules.edge_to_edge = true;
  options.openings = false;
  options.front_share = 0.5;
  options.rules.suture_lattice_mm = 1.0;
  options.rules.neochorda_lattice_mm = 1.0;
  options.rules.most_movement_mm = 12.5;
  options.weights = {2.0,  3.0,  4.0,  5.0,  6.0,  7.0,  8.0,  9.0,
                     10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0};
  request.valve_hash = "0123456789abcdef0123456789abcdef";
  request.command = "coapt plan valve.json --evaluations 1500 --seed 18446744073709551615";
  return request;
}

}  // namespace coapt
