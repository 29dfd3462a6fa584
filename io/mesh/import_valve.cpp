#include "io/mesh/import_valve.h"

#include <algorithm>

#include "core/presets/synthetic_chordae.h"
#include "core/valve/problem_list.h"
#include "core/valve/validate.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/handedness.h"
#include "io/mesh/import_chordae.h"
#include "io/mesh/import_frame.h"
#include "io/mesh/import_sheets.h"
#include "io/mesh/judged_state.h"
#include "io/mesh/leaflet_order.h"
#include "io/mesh/made_faults.h"
#include "io/mesh/mesh_decisions.h"
#include "io/mesh/plausibility.h"
#include "io/mesh/skirt.h"
#include "io/mesh/skirt_mesh.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

void check_options(const ImportSource& source, const ImportOptions& options,
                   ProblemList& problems) {
  check_range(problems, "/triangles", options.triangles, {100, 100000});
  check_range(problems, "/branches", options.branches, {1, 5});
  check_range(problems, "/branch_at", options.branch_at, {0.05, 0.95});
  check_range(problems, "/slack", options.slack, {0.8, 1.5});
  if (options.chordae_seed)
    check_range(problems, "/chordae_seed", *options.chordae_seed, {0, 2147483647});
  if (!options.closed.value_or(false)) return;
  check_range(problems, "/hidden_mm", options.hidden_mm, {0, 15}, " mm");
  if (!options.chordae_seed)
    problems.add(ErrorCode::Unsupported, "/closed",
                 "requires --chordae synthesise, because the insertions of chordae imaged with "
                 "closed leaflets are unknown on the open ones");
  if (source.leaflets.size() != 2)
    problems.add(ErrorCode::Unsupported, "/leaflets",
                 "must be two for a closed valve: the anterior sheet, then the posterior one");
}

/// Where a point of the annulus at rest goes under pressure: as the points beside it.
Vec3 pressed(const FramedSource& source, const Vec3& rest_mm) {
  const Points &loop = source.annulus_mm, &target = source.pressed_annulus_mm;
  double best = 1e300;
  Vec3 goes = rest_mm;
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Eigen::Index next = (i + 1) % loop.rows();
    const Vec3 a = loop.row(i), along = Vec3(loop.row(next)) - a;
    const double share = std::clamp(along.dot(rest_mm - a) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (a + share * along - rest_mm).norm();
    if (distance >= best) continue;
    best = distance;
    goes = Vec3((1.0 - share) * target.row(i) + share * target.row(next));
  }
  return goes;
}

/// Errors at a leaflet begin with what the user calls it.
Errors by_name(Errors errors, const std::array<std::string, 2>& called) {
  for (Error& error : errors)
    for (std::size_t i = 0; i < 2; ++i)
      if (const std::string path = "/leaflets/" + std::to_string(i);
          called[i] != LeafletOrder{}.called[i] && !error.message.starts_with(called[i]) &&
          (error.path == path || error.path.starts_with(path + '/')))
        error.message = called[i] + ' ' + error.message;
  return errors;
}

/// With chordae that nobody has seen. @pre options.chordae_seed
Expected<Valve> drawn(Valve valve, const std::vector<ImportedTip>& tips,
                      const ImportOptions& options, std::vector<ImportDecision>& decisions) {
  const int seed = *options.chordae_seed;
  Points tips_mm(std::ssize(tips), 3);
  for (Eigen::Index i = 0; i < tips_mm.rows(); ++i)
    tips_mm.row(i) = tips[static_cast<std::size_t>(i)].position_mm.transpose();
  Expected<Valve> made = with_synthetic_chordae(std::move(valve), seed, tips_mm, options.budget);
  if (!made) return made.errors();
  decisions.push_back({"chordae",
                       "not imaged; synthesised from anatomical data with seed " +
                           std::to_string(seed) + ": " + std::to_string(made->chordae.size()) +
                           " chordae, with lengths relative to the closed state",
                       std::string("papillary tips ") +
                           (tips.empty() ? "also synthesised, below the annulus" : "as given")});
  return made;
}

}  // namespace

std::string sentence(const ImportDecision& of) {
  return of.subject + ": " + of.value + (of.reason.empty() ? "" : "; " + of.reason);
}

const char* to_string(LengthUnit unit) {
  if (unit == LengthUnit::Metre) return "m";
  if (unit == LengthUnit::Inch) return "in";
  return unit == LengthUnit::Centimetre ? "cm" : "mm";
}

namespace {

Expected<ImportedValve> make_valve(ImportSource source, const ImportOptions& options) {
  ProblemList problems;
  check_options(source, options, problems);
  if (!problems.empty()) return std::move(problems).take();
  const std::vector<ImportDecision> loose = drop_loose_points(source);
  const UnitReading read =
      options.units ? UnitReading{*options.units, "as given", false, 1.0} : unit_of(source);
  const LengthUnit unit = read.unit;
  if (Errors errors = impossible_size(source, unit); !errors.empty()) return errors;
  // A unit that the user gives is that of all files.
  const std::vector<ImportDecision> converted =
      options.units ? std::vector<ImportDecision>{} : take_part_units(source, unit);
  scale(source, in_mm(unit));
  if (options.mirrored) unmirror(source);
  const Expected<std::vector<ImportDecision>> contour = contour_checks(source.annulus_mm);
  if (!contour) return contour.errors();
  Expected<SheetPreparation> prepared = prepare_sheets(source, options.budget);
  if (!prepared) return by_name(prepared.errors(), source.order.called);
  const std::vector<ImportDecision> stretched =
      thickness_checks(source.leaflets, prepared->thickness);
  const Expected<SettledOrder> order = settle_leaflet_order(source, options.trust_labels);
  if (!order) return by_name(order.errors(), source.order.called);
  std::array<std::string, 2> called = source.order.called;
  if (order->swapped) std::swap(called[0], called[1]);
  if (order->swapped) swap_names(*prepared);
  const JudgedState state = judged_state(source, options, prepared->thickness);
  const Expected<FramedSource> framed =
      into_import_frame(source, {options.chordae_seed.has_value(), state.closed, options.flip});
  if (!framed) return by_name(framed.errors(), called);
  std::optional<ImportDecision> handedness;
  if (source.tips.empty() && source.chordae.empty()) {
    Expected<ImportDecision> judged = judged_handedness(source, framed->patient);
    if (!judged) return judged.errors();
    handedness = *std::move(judged);
  }
  const Expected<Skirt> skirt = resample_skirt(*framed, skirt_size(options.triangles),
                                               {state.closed, options.hidden_mm}, options.budget);
  if (!skirt) return by_name(skirt.errors(), called);
  Valve valve;
  valve.name = source.name.empty() ? "imported" : source.name;
  valve.provenance = source.provenance;
  valve.patient = framed->patient;
  valve.tissue.reference = state.closed ? TissueReference::InVivo : options.reference;
  if (source.tissue) valve.tissue = *source.tissue;
  if (source.pressure_kpa) valve.pressure_kpa = *source.pressure_kpa;
  add_mesh(*skirt, valve);
  if (framed->pressed_annulus_mm.rows() > 0)
    for (auto vertex : valve.annulus_mm.rowwise()) vertex = pressed(*framed, vertex).transpose();
  valve.landmarks = find_landmarks(*skirt, framed->landmarks);
  const Expected<std::vector<ImportDecision>> seen =
      given_decisions(framed->landmarks, *skirt, valve.landmarks);
  if (!seen) return seen.errors();
  std::vector<ImportDecision> decisions =
      state.closed
          ? closed_decisions(*skirt, options.hidden_mm, valve)
          : mesh_decisions(*framed, *skirt, valve, source.tissue.has_value(), options.budget);
  std::vector<ImportDecision> first = {
      {"units", to_string(unit), read.reason, read.look, read.confidence}};
  first.insert(first.end(), converted.begin(), converted.end());
  if (options.mirrored)
    first.push_back(
        {"frame", "all files mirrored (x reversed)", "they are a mirror image, as given"});
  first.push_back(framed->change);
  if (handedness) first.push_back(*std::move(handedness));
  if (!framed->atrium.subject.empty()) first.push_back(framed->atrium);
  first.insert(first.end(), loose.begin(), loose.end());
  first.insert(first.end(), order->decisions.begin(), order->decisions.end());
  first.insert(first.end(), prepared->decisions.begin(), prepared->decisions.end());
  first.insert(first.end(), state.decisions.begin(), state.decisions.end());
  decisions.insert(decisions.begin(), first.begin(), first.end());
  decisions.insert(decisions.end(), contour->begin(), contour->end());
  const std::vector<ImportDecision> doubts = valve_checks(*framed, *skirt, valve, state.closed);
  decisions.insert(decisions.end(), doubts.begin(), doubts.end());
  decisions.insert(decisions.end(), stretched.begin(), stretched.end());
  decisions.insert(decisions.end(), seen->begin(), seen->end());
  const Expected<double> thickness_mm =
      tissue_thickness(options, prepared->thickness, valve.tissue.thickness_mm, decisions);
  if (!thickness_mm) return thickness_mm.errors();
  valve.tissue.thickness_mm = *thickness_mm;
  if (options.chordae_seed) {
    Expected<Valve> made = drawn(valve, framed->tips, options, decisions);
    if (!made) return made_faults(made.errors(), valve, called, unit);
    valve = *std::move(made);
  } else if (Errors errors = add_imported_chordae(*framed, *skirt, options, valve, decisions);
             !errors.empty()) {
    return errors;
  }
  if (Errors errors = add_imported_ties(*framed, state.closed, valve, decisions); !errors.empty())
    return errors;
  decisions.insert(decisions.begin(), source.decisions.begin(), source.decisions.end());
  for (const ImportDecision& decision : decisions) valve.provenance.push_back(sentence(decision));
  if (const Errors faults = validate(valve); !faults.empty())
    return made_faults(faults, valve, called, unit);
  return ImportedValve{
      std::move(valve),
      std::move(decisions),
      {framed->leaflets, framed->annulus_mm, framed->chordae, framed->tips, state.closed},
      unit,
      std::move(source.parts),
      std::move(prepared->thickness)};
}

}  // namespace

Expected<ImportedValve> import_with_decisions(ImportSource source, const ImportOptions& options) {
  Expected<ImportedValve> imported = make_valve(std::move(source), options);
  if (options.budget.is_cancelled())
    return Error{ErrorCode::Busy, "", "the import was cancelled before it was done"};
  return imported;
}

Expected<Valve> import_valve(ImportSource source, const ImportOptions& options) {
  Expected<ImportedValve> imported = import_with_decisions(std::move(source), options);
  if (!imported) return imported.errors();
  return std::move(imported->valve);
}

}  // namespace coapt
