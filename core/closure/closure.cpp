// The ladder: each method has settings from quick to careful. The first attempt that converges
// without crossing is the result; if none does, the best of them is, and says so.

#include "core/closure/closure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

#include "core/closure/model.h"
#include "core/closure/prepared_valve.h"
#include "core/closure/relaxation.h"
#include "core/closure/thesis.h"

namespace coapt {
namespace {

constexpr int kFastSteps = 6000, kPatientSteps = 20000, kThesisSteps = 40000;
constexpr double kFastStepsFaces = 2600.0;                 // up to so many kFastSteps are enough
constexpr double kPartResidual = 0.05, kPartWay_mm = 0.2;  // of a part of the load
// From a predicted start the slow modes are nearly done, so that more damping ends the rest sooner; where they are not, the
// leaflets creep, and less is quicker.
constexpr double kPredictedDamping = 0.09, kLeastPredictedDamping = 0.035;
// What single precision reaches: rounding of positions is 1e-4 of the pressure force.
constexpr double kFloatResidual = 1e-3, kFloatWay_mm = 0.01;

// Leaflets of exponential tissue are soft until they are nearly closed, so that they travel slowly,
// and their meshes are fine and touch at a fraction of a millimetre. Measured on the Texas TriValve:
// a damping of 0.06 takes three times as many steps; moves as long as the contact is thick let
// leaflets pass through each other. Once they have arrived, a few branch points go on to rattle
// between slack and taut chordae, which takes more damping to end; with ten times as much they creep,
// because a chorda is a thousand times stiffer along than across. The last tolerance is theirs: it
// leaves half of the leaflets' nodes within 0.4 % of the load.
constexpr double kTravelDamping = 0.02, kTravelMoveShare = 0.3;
constexpr double kTravelResidual = 1.0, kTravelWay_mm = 0.1;
constexpr double kSettlingDamping = 0.05, kSettledResidual = 0.05;

struct Rung {
  const char* how;
  std::function<ClosureRun()> run;
};

std::vector<Rung> thesis_ladder(const ClosureModel& model, const ClosureOptions& options,
                                const PreparedValve& prepared, Allowance& allowance) {
  ThesisSettings plain;
  plain.allowance = &allowance;
  plain.residual_tolerance = options.residual_tolerance;
  plain.max_steps = options.max_steps > 0 ? options.max_steps : kThesisSteps;
  plain.damping_per_ms = options.damping_per_ms;
  plain.speed = options.speed;
  plain.contact = prepared.contact();
  plain.samples = options.samples;
  ThesisSettings edges = plain;
  edges.contact.edges = true;
  ThesisSettings slow = edges;
  slow.speed = 0.5 * plain.speed;
  std::vector<Rung> ladder = {
      {"thesis, edge contact", [&model, edges] { return run_thesis(model, edges); }},
      {"thesis, edge contact, half speed", [&model, slow] { return run_thesis(model, slow); }}};
  if (!options.edge_contact)
    ladder.insert(ladder.begin(), {"thesis", [&model, plain] { return run_thesis(model, plain); }});
  return ladder;
}

/// In single precision as far as that carries, then in double from there.
ClosureRun relax_to(const ClosureModel& model, const RelaxationSettings& settings,
                    const ClosureRun* start = nullptr) {
  RelaxationSettings coarse = settings;
  coarse.residual_tolerance = std::max(settings.residual_tolerance, kFloatResidual);
  coarse.way_tolerance_mm = std::max(settings.way_tolerance_mm, kFloatWay_mm);
  ClosureRun run = relax<float>(model, coarse, start);
  if (run.status != ClosureStatus::Converged ||
      (settings.residual_tolerance >= kFloatResidual && settings.way_tolerance_mm >= kFloatWay_mm))
    return run;
  ClosureRun exact = relax<double>(model, settings, &run);
  exact.steps += run.steps;
  return exact;
}

/// The pressure in four parts, each from where the one before came near its rest.
ClosureRun relax_in_parts(const ClosureModel& model, const RelaxationSettings& settings) {
  RelaxationSettings loose = settings;
  loose.residual_tolerance = std::max(settings.residual_tolerance, kPartResidual);
  loose.way_tolerance_mm = std::max(settings.way_tolerance_mm, kPartWay_mm);
  ClosureModel part = model;
  ClosureRun run;
  int steps = 0;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    part.pressure_mpa = 0.25 * quarter * model.pressure_mpa;
    const ClosureRun start = std::move(run);
    run = relax<double>(part, quarter < 4 ? loose : settings, quarter > 1 ? &start : nullptr);
    steps += run.steps;
    if (run.status == ClosureStatus::Diverged || settings.allowance->spent()) break;
  }
  run.steps = steps;
  return run;
}

/// A slow mode takes as many more steps as there are more triangles across a leaflet: a varied
/// human-normal 7,600 at 10,400 triangles.
int fast_steps(const ClosureModel& model) {
  const auto faces = static_cast<double>(model.faces.rows());
  return static_cast<int>(kFastSteps * std::sqrt(std::max(1.0, faces / kFastStepsFaces)));
}

// Where steps by the leaflets' stiffness as a whole pay: on coarser meshes a factorisation costs what it saves.
constexpr Index kPreconditionedFaces = 1300;

bool preconditions(const ClosureModel& model) {
  return model.faces.rows() > kPreconditionedFaces && !model.sheets.empty();
}

/// Of a first attempt that is not from the open state; none without a run.
struct FastStart {
  const ClosureRun* run = nullptr;
  bool predicted = false;
};

std::vector<Rung> fast_ladder(const ClosureModel& model, const ClosureOptions& options,
                              const PreparedValve& prepared, Allowance& allowance,
                              const FastStart& from) {
  RelaxationSettings plain;
  plain.allowance = &allowance;
  plain.residual_tolerance = options.residual_tolerance;
  plain.way_tolerance_mm = options.way_tolerance_mm;
  plain.max_steps = options.max_steps > 0 ? options.max_steps : fast_steps(model);
  plain.longest_move_mm = options.speed * prepared.longest_move_mm();
  plain.contact = prepared.contact();
  plain.layout = &prepared.layout();
  plain.samples = options.samples;
  plain.motion = options.motion;
  RelaxationSettings edges = plain;
  edges.contact.edges = true;
  RelaxationSettings slow = edges;
  slow.damping = 0.12;
  slow.longest_move_mm = 0.5 * plain.longest_move_mm;
  RelaxationSettings slower = edges;
  slower.damping = 0.1;
  slower.longest_move_mm = 0.3 * plain.longest_move_mm;
  // Very stiff chordae come to rest only so.
  RelaxationSettings light = edges;
  light.damping = 0.03;
  if (options.max_steps == 0) light.max_steps = kPatientSteps;
  std::vector<Rung> ladder;
  if (from.run) {
    RelaxationSettings near = plain;
    if (from.predicted) {
      near.damping = kPredictedDamping;
      near.least_damping = kLeastPredictedDamping;
    }
    if (preconditions(model)) near = preconditioned(near);
    ladder.push_back({from.predicted ? "float, from a prediction" : "float, from a neighbour",
                      [&model, near, from] { return relax_to(model, near, from.run); }});
  }
  if (preconditions(model)) {
    const RelaxationSettings whole = preconditioned(options.edge_contact ? edges : plain);
    ladder.push_back({"float, preconditioned", [&model, whole] { return relax_to(model, whole); }});
  }
  if (!options.edge_contact)
    ladder.push_back({"float", [&model, plain] { return relax_to(model, plain); }});
  const std::vector<Rung> careful = {
      {"float, edge contact", [&model, edges] { return relax_to(model, edges); }},
      {"float, edge contact, slow", [&model, slow] { return relax_to(model, slow); }},
      {"double, edge contact, slow", [&model, slower] { return relax<double>(model, slower); }},
      {"double, edge contact, lightly damped",
       [&model, light] { return relax<double>(model, light); }},
      {"double, edge contact, slow, load in parts",
       [&model, slower] { return relax_in_parts(model, slower); }}};
  ladder.insert(ladder.end(), careful.begin(), careful.end());
  return ladder;
}

/// With little damping until the leaflets hardly move, then with much and in double precision: single
/// has forces of chordae to a tenth of what the pressure does to a node of 0.1 mm2.
ClosureRun travel_and_settle(const ClosureModel& model, const RelaxationSettings& travel) {
  RelaxationSettings loose = travel;
  loose.residual_tolerance = std::max(travel.residual_tolerance, kTravelResidual);
  loose.way_tolerance_mm = std::max(travel.way_tolerance_mm, kTravelWay_mm);
  const ClosureRun arrived = relax<float>(model, loose);
  if (arrived.status != ClosureStatus::Converged) return arrived;
  RelaxationSettings settle = travel;
  settle.damping = kSettlingDamping;
  settle.residual_tolerance = std::max(travel.residual_tolerance, kSettledResidual);
  ClosureRun run = relax<double>(model, settle, &arrived);
  run.steps += arrived.steps;
  return run;
}

std::vector<Rung> exponential_ladder(const ClosureModel& model, const ClosureOptions& options,
                                     const PreparedValve& prepared, Allowance& allowance) {
  RelaxationSettings plain;
  plain.allowance = &allowance;
  plain.residual_tolerance = options.residual_tolerance;
  plain.way_tolerance_mm = options.way_tolerance_mm;
  plain.max_steps = options.max_steps > 0 ? options.max_steps : kPatientSteps;
  plain.damping = kTravelDamping;
  plain.longest_move_mm =
      options.speed *
      std::min(plain.longest_move_mm, kTravelMoveShare * prepared.contact().thickness_mm);
  plain.contact = prepared.contact();
  plain.layout = &prepared.layout();
  plain.contact.edges = true;
  plain.samples = options.samples;
  plain.motion = options.motion;
  RelaxationSettings slow = plain;
  slow.longest_move_mm *= 0.5;
  slow.damping *= 2.0;
  return {{"float, then double, edge contact",
           [&model, plain] { return travel_and_settle(model, plain); }},
          {"float, then double, edge contact, slow",
           [&model, slow] { return travel_and_settle(model, slow); }}};
}

/// The neighbour's end as a start for this valve, whose tips are in place at once.
std::optional<ClosureRun> start_from(const Valve& valve, const ClosureModel& model,
                                     const ClosureResult& neighbour) {
  if (!trusted(neighbour) || neighbour.closed_mm.rows() != model.vertices) return std::nullopt;
  ClosureRun start;
  start.x_mm = model.target_mm;
  start.x_mm.topRows(model.vertices) = neighbour.closed_mm;
  start.guarded_faces = neighbour.guarded_faces;
  int next = model.vertices;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    for (Index s = 0; s < std::ssize(valve.chordae[c].segments); ++s) {
      if (valve.chordae[c].segments[s].inserts) continue;
      const int node = next++;
      if (!model.fixed[node] && c < neighbour.branch_points_mm.size() &&
          s < neighbour.branch_points_mm[c].rows())
        start.x_mm.row(node) = neighbour.branch_points_mm[c].row(s);
    }
  for (const Cable& cable : model.cables)
    if (cable.chorda < 0) start.x_mm.row(cable.start).setZero();
  for (const Cable& cable : model.cables)  // knots midway
    if (cable.chorda < 0)
      start.x_mm.row(cable.start) += 0.5 * end_position(cable, start.x_mm).transpose();
  return start;
}

/// Whether attempt `a` says more than `b`: converged before at the limit before diverged, then
/// fewer crossings, then the smaller residual.
bool is_better(const ClosureAttempt& a, const ClosureAttempt& b) {
  return std::tuple(a.status, a.crossing_pairs, a.residual) <
         std::tuple(b.status, b.crossing_pairs, b.residual);
}

/// Nobody draws the knots of ties.
Points without_knots(const Valve& valve, const Points& state_mm) {
  const Index heads = std::ssize(valve.heads), knots = std::ssize(valve.ties);
  Points kept(state_mm.rows() - knots, 3);
  kept << state_mm.topRows(kept.rows() - heads), state_mm.bottomRows(heads);
  return kept;
}

/// Ruptured chordae have no tension, but their points have places.
void read_chordae(const Valve& valve, const ClosureModel& model, const Points& x,
                  ClosureResult& result) {
  int next_branch = model.vertices;
  for (const Chorda& chorda : valve.chordae) {
    Points& ends = result.branch_points_mm.emplace_back(std::ssize(chorda.segments), 3);
    result.tension_n.emplace_back(chorda.segments.size(), 0.0);
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const ChordaSegment& segment = chorda.segments[s];
      if (!segment.inserts) {
        ends.row(s) = x.row(next_branch++);
        continue;
      }
      ends.row(s).setZero();
      for (int k = 0; k < 3; ++k)
        ends.row(s) += segment.insertion.weights[k] * x.row(valve.faces(segment.insertion.face, k));
    }
  }
  result.tie_tension_n.assign(valve.ties.size(), 0.0);
  for (const Cable& cable : model.cables) {
    if (cable.chorda >= 0)
      result.tension_n[cable.chorda][cable.segment] = tension_n(cable, x);
    else  // both halves pull alike at rest
      result.tie_tension_n[cable.segment] += 0.5 * tension_n(cable, x);
  }
}

}  // namespace

ClosureResult close_valve(const Valve& valve, const ClosureOptions& options,
                          const ClosureResult* neighbour) {
  return close_valve(PreparedValve(valve, options), valve, options, neighbour);
}

ClosureResult close_valve(const PreparedValve& prepared, const Valve& valve,
                          const ClosureOptions& options, const ClosureResult* neighbour) {
  const ClosureModel model = prepared.model(valve);
  const std::optional<ClosureRun> start =
      neighbour && !options.edge_contact ? start_from(valve, model, *neighbour) : std::nullopt;
  FastStart from;
  if (start) from = {&*start, neighbour->predicted};
  ClosureResult result;
  result.method = options.method;
  result.membrane = options.membrane;
  result.residual_tolerance = options.residual_tolerance;
  result.way_tolerance_mm = options.way_tolerance_mm;
  ClosureRun best;
  std::size_t best_attempt = 0;
  Allowance allowance(options.budget, model.vertices);
  std::vector<Rung> ladder =
      options.method == Method::Thesis ? thesis_ladder(model, options, prepared, allowance)
      : is_mitral(valve)               ? fast_ladder(model, options, prepared, allowance, from)
                                       : exponential_ladder(model, options, prepared, allowance);
  for (const Rung& rung : ladder) {
    ClosureRun run = rung.run();
    const ClosureAttempt attempt{rung.how, run.status, run.crossing_pairs, run.residual, run.steps};
    result.attempts.push_back(attempt);
    result.steps += run.steps;
    if (result.attempts.size() == 1 || is_better(attempt, result.attempts[best_attempt])) {
      best = std::move(run);
      best_attempt = result.attempts.size() - 1;
    }
    if (attempt.status == ClosureStatus::Converged && attempt.crossing_pairs == 0) break;
    if (allowance.spent()) break;
  }
  result.unfinished = allowance.spent();
  const ClosureAttempt& chosen = result.attempts[best_attempt];
  result.status = chosen.status;
  result.residual = chosen.residual;
  result.crossing_pairs = chosen.crossing_pairs;
  result.crossing = chosen.crossing_pairs > 0 || chosen.status == ClosureStatus::Diverged;
  result.guarded_faces = std::move(best.guarded_faces);
  result.closed_mm = best.x_mm.topRows(model.vertices);
  result.samples_mm = std::move(best.samples_mm);
  for (const Points& state_mm : best.motion_mm)
    result.motion_mm.push_back(without_knots(valve, state_mm));
  if (result.samples_mm.empty()) result.samples_mm.push_back(result.closed_mm);
  read_chordae(valve, model, best.x_mm, result);
  return result;
}

}  // namespace coapt
