#include "io/mesh/import_valve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/presets/synthetic_chordae.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "core/valve/validate.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/hanging_profile.h"
#include "io/mesh/imaged_state.h"
#include "io/mesh/import_chordae.h"
#include "io/mesh/import_frame.h"
#include "io/mesh/import_sheets.h"
#include "io/mesh/mesh_distance.h"
#include "io/mesh/sheet_repair.h"
#include "io/mesh/skirt.h"
#include "io/mesh/source_units.h"

namespace coapt {
namespace {

constexpr double kTrigone =
    0.66;  // of the way from saddle peak to commissure, as in parametric valves
constexpr double kCommissureAlong = 0.07;  // share of a leaflet's arc that counts as commissure
constexpr double kPeakBias_mm =
    0.5;  // a flat annulus has its saddle peak in the middle of the front
constexpr double kDiagonalRatio = 1.3;
constexpr double kLongestInMetres = 0.5, kLongestInCentimetres = 15.0;  // of the leaflets' box
constexpr int kMaxSamples = 4000;                                       // for the deviation

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
                 "needs chordae that are drawn (--chordae synthesise): where those of closed "
                 "leaflets insert in the open ones is not known");
  if (source.leaflets.size() != 2)
    problems.add(ErrorCode::Unsupported, "/leaflets",
                 "of a closed valve must be two, the anterior sheet, then the posterior one");
}

Segment segment_of(const Skirt& skirt, double station) {
  const double front = skirt.lateral_commissure, back = skirt.stations - front;
  const bool anterior = station < front;
  const double along =
      anterior ? 1.0 - station / front : (station - front) / back;  // from anterolateral
  if (along < kCommissureAlong) return Segment::AC;
  if (along > 1.0 - kCommissureAlong) return Segment::PC;
  if (along < 1.0 / 3.0) return anterior ? Segment::A1 : Segment::P1;
  if (along < 2.0 / 3.0) return anterior ? Segment::A2 : Segment::P2;
  return anterior ? Segment::A3 : Segment::P3;
}

/// Whether a quad (a b over c d) is split from b to c: the diagonals alternate, which makes springs
/// nearly isotropic, unless one is much shorter.
bool is_falling(const Points& x, const std::array<int, 4>& quad, bool alternating) {
  const double falling = (x.row(quad[1]) - x.row(quad[2])).norm();
  const double rising = (x.row(quad[0]) - x.row(quad[3])).norm();
  if (falling > kDiagonalRatio * rising) return false;
  return rising > kDiagonalRatio * falling || alternating;
}

void add_mesh(const Skirt& skirt, Valve& valve) {
  const int n = skirt.stations;
  valve.rest_mm = skirt.vertices_mm;
  valve.annulus_mm = skirt.vertices_mm.topRows(n);
  for (int i = 0; i < n; ++i) valve.annulus.push_back(i);
  valve.faces.resize(2 * n * skirt.rows, 3);
  valve.fibre.resize(valve.faces.rows(), 3);
  for (int row = 0, f = 0; row < skirt.rows; ++row) {
    for (int i = 0; i < n; ++i, f += 2) {
      const int next = (i + 1) % n;
      const int a = row * n + i, b = row * n + next, c = a + n, d = b + n;
      const bool falling = is_falling(valve.rest_mm, {a, b, c, d}, (i + row) % 2 == 0);
      valve.faces.row(f) << a, b, falling ? c : d;
      valve.faces.row(f + 1) << (falling ? b : a), d, c;
      valve.fibre.row(f) = (valve.rest_mm.row(b) - valve.rest_mm.row(a)).normalized();
      valve.fibre.row(f + 1) = (valve.rest_mm.row(d) - valve.rest_mm.row(c)).normalized();
      valve.segments.insert(valve.segments.end(), 2, segment_of(skirt, i + 0.5));
    }
  }
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

Landmarks find_landmarks(const Skirt& skirt, const GivenLandmarks& given) {
  const int lateral = skirt.lateral_commissure;
  const double middle = 0.5 * lateral;
  int peak = 1;
  double best = -1e300;
  for (int i = 1; i < lateral; ++i) {
    const double off = (i - middle) / middle;
    const double score = skirt.vertices_mm(i, 2) - kPeakBias_mm * off * off;
    if (score > best + 1e-9) {
      best = score;
      peak = i;
    }
  }
  if (given.saddle_peak_mm) peak = nearest_station(skirt, *given.saddle_peak_mm, 1, lateral - 1);
  const auto from_peak = [&](int commissure) {
    return static_cast<int>(std::lround(peak + kTrigone * (commissure - peak)));
  };
  Landmarks marks;
  marks.posteromedial_commissure = 0;
  marks.posteromedial_trigone = from_peak(0);
  marks.saddle_peak = peak;
  marks.anterolateral_trigone = from_peak(lateral);
  marks.anterolateral_commissure = lateral;
  marks.mid_posterior = given.mid_posterior_mm ? nearest_station(skirt, *given.mid_posterior_mm,
                                                                 lateral + 1, skirt.stations - 1)
                                               : lateral + (skirt.stations - lateral) / 2;
  return marks;
}

struct Deviation {
  double rms_mm = 0.0, max_mm = 0.0;
};

/// Of the resampled vertices below the annulus from the sheets, where there is a sheet.
Deviation deviation(const std::vector<TriangleMesh>& sheets, const Skirt& skirt) {
  const int first = skirt.stations, last = static_cast<int>(skirt.vertices_mm.rows());
  const int stride = 1 + (last - first) / kMaxSamples;
  Deviation found;
  int count = 0;
  for (int v = first; v < last; v += stride) {
    if (skirt.interpolated[static_cast<std::size_t>(v % skirt.stations)]) continue;
    const double distance = distance_mm(sheets, skirt.vertices_mm.row(v));
    found.rms_mm += distance * distance;
    found.max_mm = std::max(found.max_mm, distance);
    ++count;
  }
  found.rms_mm = std::sqrt(found.rms_mm / std::max(1, count));
  return found;
}

ImportDecision landmark_decision(const Skirt& skirt) {
  return {"landmarks",
          std::string("commissures ") +
              (skirt.commissures_given      ? "as given"
               : skirt.commissures_measured ? "where the two sheets meet"
                                            : "38 % of the annulus apart about its front") +
              ", saddle peak highest in front, mid-posterior half-way, trigones 66 % of the way "
              "from the peak to the commissures; segments by thirds of arc, fibres circumferential",
          skirt.commissures_measured || skirt.commissures_given
              ? ""
              : "one skirt does not tell where leaflets meet"};
}

/// Of leaflets that were imaged closed.
std::vector<ImportDecision> closed_decisions(const Skirt& skirt, double hidden_mm,
                                             const Valve& valve) {
  return {
      {"mesh",
       std::to_string(skirt.stations) + " stations of equal annulus arc (" +
           significant(skirt.spacing_mm, 3) + " mm) x " + std::to_string(skirt.rows) + " rows, " +
           std::to_string(valve.faces.rows()) + " triangles",
       "the leaflets hang from the annulus, 20 degrees inwards"},
      landmark_decision(skirt),
      {"state",
       "imaged closed, under pressure; heights of the open leaflets are the exposed lengths / " +
           significant(kClosedStretch, 3) + " + " + significant(hidden_mm, 2) +
           " mm hidden in coaptation, at the commissures those of a human valve",
       "exposed at A2 " + significant(skirt.anterior_exposed_mm, 3) + " mm, at P2 " +
           significant(skirt.posterior_exposed_mm, 3) +
           " mm; coapt fit finds the hidden height, chordae and tips from the same surface"}};
}

std::vector<ImportDecision> mesh_decisions(const FramedSource& source, const Skirt& skirt,
                                           const Valve& valve, bool own_tissue) {
  const auto bare = std::count(skirt.interpolated.begin(), skirt.interpolated.end(), true);
  const Deviation off = deviation(source.leaflets, skirt);
  double input_area = 0.0;
  for (const TriangleMesh& sheet : source.leaflets) input_area += area_mm2(sheet);
  const auto counted = [](auto number) { return std::to_string(number); };
  std::vector<ImportDecision> told;
  told.push_back({"mesh",
                  "cut by half-planes through the annulus axis to " + counted(skirt.stations) +
                      " stations of equal annulus arc (" + significant(skirt.spacing_mm, 3) +
                      " mm) x " + counted(skirt.rows) + " rows, " + counted(valve.faces.rows()) +
                      " triangles; smoothed along the annulus by a hat of " +
                      significant(skirt.hat_mm, 3) + " mm to either side, not otherwise",
                  "distance from the sheets " + significant(off.rms_mm, 3) + " mm RMS, " +
                      significant(off.max_mm, 3) + " mm at most; area " +
                      counted(std::lround(area_mm2({valve.rest_mm, valve.faces}))) +
                      " mm2 (sheets " + counted(std::lround(input_area)) + " mm2)"});
  told.push_back({"annulus",
                  "sheets joined to the annulus line; holes and bites bridged, " +
                      significant(skirt.widest_bridge_mm, 3) + " mm at the widest",
                  "they were " + significant(skirt.annulus_gap_mm, 3) + " mm away in the mean"});
  told.push_back({"commissures",
                  counted(bare) + " stations without sheet interpolated between their neighbours",
                  "which closes the commissures"});
  told.push_back(landmark_decision(skirt));
  told.push_back(
      {"state",
       valve.tissue.reference == TissueReference::InVivo
           ? "the imaged state is taken as that of the unpressurised heart"
           : "the imaged state is taken as unstressed",
       std::string(source.pressed_annulus_mm.rows() > 0
                       ? "annulus and papillary tips under pressure came with it"
                       : "its annulus and papillary tips as those under pressure") +
           (own_tissue ? "; tissue and pressure, too" : "; tissue of thesis table 2.1")});
  return told;
}

/// With chordae that nobody has seen.
Expected<Valve> drawn(Valve valve, const std::vector<ImportedTip>& tips, int seed,
                      std::vector<ImportDecision>& decisions) {
  Points tips_mm(std::ssize(tips), 3);
  for (Eigen::Index i = 0; i < tips_mm.rows(); ++i)
    tips_mm.row(i) = tips[static_cast<std::size_t>(i)].position_mm.transpose();
  Expected<Valve> made = with_synthetic_chordae(std::move(valve), seed, tips_mm);
  if (!made) {
    Errors errors = made.errors();
    for (Error& error : errors)
      if (!error.path.starts_with("/tips_mm"))
        error.message = "of the resampled valve " + error.message;
    return errors;
  }
  decisions.push_back({"chordae",
                       "not seen; drawn from anatomy with seed " + std::to_string(seed) + ": " +
                           std::to_string(made->chordae.size()) +
                           " chordae, taut in the closed state times a slack",
                       std::string("papillary tips ") +
                           (tips.empty() ? "drawn, too, below the annulus" : "as given")});
  return made;
}

/// Of the whole source, while its unit is not known: what its annulus or, without one, its leaflets fit.
LengthUnit unit_of(const ImportSource& source) {
  if (source.annulus_mm.rows() > 0)
    return guessed_unit(source.annulus_mm).value_or(LengthUnit::Millimetre);
  Eigen::AlignedBox3d box;
  for (const TriangleMesh& mesh : source.leaflets)
    if (mesh.vertices_mm.allFinite())
      for (const auto& vertex : mesh.vertices_mm.rowwise()) box.extend(vertex.transpose());
  const double diagonal = box.isEmpty() ? 50.0 : box.diagonal().norm();
  return diagonal < kLongestInMetres        ? LengthUnit::Metre
         : diagonal < kLongestInCentimetres ? LengthUnit::Centimetre
                                            : LengthUnit::Millimetre;
}

/// Whether what judged_state() looks at is there; into_import_frame() names what is not.
bool can_be_judged(const ImportSource& source) {
  return source.annulus_mm.rows() >= 3 && source.annulus_mm.allFinite() &&
         is_sound(source.leaflets);
}

/// What the images show, as given or judged; `closed` of the result is how the import goes on.
struct JudgedState {
  bool closed = false;
  std::vector<ImportDecision> decisions;
};

JudgedState judged_state(const ImportSource& source, const ImportOptions& options,
                         const std::vector<MeasuredThickness>& thickness) {
  double thickness_mm = Tissue{}.thickness_mm;
  for (const MeasuredThickness& of : thickness) thickness_mm = std::max(thickness_mm, of.mean_mm);
  const StateSigns signs = imaged_state(source.leaflets, source.annulus_mm, thickness_mm);
  const std::string seen = "they leave " + significant(100.0 * signs.uncovered_share, 2) +
                           " % of the annulus's area uncovered";
  const char* looks = signs.state == ImagedState::Closed       ? "closed"
                      : signs.state == ImagedState::HalfClosed ? "half closed"
                                                               : "open";
  if (options.closed) {
    const bool agrees = *options.closed == (signs.state == ImagedState::Closed);
    return {*options.closed,
            {{"state",
              std::string(*options.closed ? "closed" : "open") + ", as given" +
                  (agrees ? "" : std::string("; the leaflets look ") + looks),
              seen, !agrees}}};
  }
  if (signs.state == ImagedState::Open) return {false, {{"state", "imaged open", seen}}};
  if (signs.state == ImagedState::HalfClosed)
    return {false,
            {{"state", "imaged half closed, taken as open",
              seen + "; from 12 to 25 % is neither: what is stretched already counts as unstressed",
              true}}};
  if (!options.chordae_seed)
    return {false,
            {{"state", "the leaflets look closed, but are taken as open: chordae were given",
              seen + "; the open shape is derived only where chordae are drawn (--chordae "
                     "synthesise)",
              true}}};
  if (source.leaflets.size() != 2)
    return {false,
            {{"state", "the leaflets look closed, but are taken as open: they came as one skirt",
              seen + "; the open shape is derived from an anterior and a posterior one", true}}};
  return {true, {{"state", "imaged closed", seen + ", 12 % at most is closed", true}}};
}

/// Of the tissue, by the options.
Expected<double> tissue_thickness(const ImportOptions& options,
                                  const std::vector<MeasuredThickness>& measured, double own_mm,
                                  std::vector<ImportDecision>& decisions) {
  double mean_mm = 0.0;
  for (const MeasuredThickness& of : measured)
    mean_mm += of.mean_mm / static_cast<double>(measured.size());
  if (options.thickness_measured) {
    if (measured.empty())
      return Error{ErrorCode::MissingField, "/thickness_measured",
                   "needs thick leaflets; these are sheets, so give a thickness in millimetres"};
    decisions.push_back({"thickness", significant(mean_mm, 2) + " mm", "as measured", true});
    return mean_mm;
  }
  if (options.thickness_mm) {
    decisions.push_back({"thickness", significant(*options.thickness_mm, 3) + " mm", "as given"});
    return *options.thickness_mm;
  }
  if (!measured.empty())
    decisions.push_back({"thickness",
                         "tissue keeps " + significant(own_mm, 2) + " mm; the shells measure " +
                             significant(mean_mm, 2) + " mm",
                         "segmentation thickens by about a voxel (--thickness measured takes it)"});
  return own_mm;
}

std::string sentence(const ImportDecision& of) {
  return of.about + ": " + of.decision + (of.reason.empty() ? "" : "; " + of.reason);
}

}  // namespace

Expected<ImportedValve> import_with_decisions(ImportSource source, const ImportOptions& options) {
  ProblemList problems;
  check_options(source, options, problems);
  if (!problems.empty()) return std::move(problems).take();
  const LengthUnit unit = options.units.value_or(unit_of(source));
  scale(source, in_mm(unit));
  const bool ring_given = source.annulus_mm.rows() > 0;
  Expected<SheetPreparation> prepared = prepare_sheets(source);
  if (!prepared) return prepared.errors();
  JudgedState state;
  if (can_be_judged(source)) state = judged_state(source, options, prepared->thickness);
  const Expected<FramedSource> framed =
      into_import_frame(source, options.chordae_seed.has_value(), state.closed);
  if (!framed) return framed.errors();
  const Expected<Skirt> skirt =
      resample_skirt(*framed, options.triangles, {state.closed, options.hidden_mm});
  if (!skirt) return skirt.errors();
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
  std::vector<ImportDecision> decisions =
      state.closed ? closed_decisions(*skirt, options.hidden_mm, valve)
                   : mesh_decisions(*framed, *skirt, valve, source.tissue.has_value());
  std::vector<ImportDecision> first = {{"units", to_string(unit),
                                        options.units ? "as given"
                                        : ring_given  ? "by the annulus's circumference"
                                                      : "by the leaflets' size"},
                                       framed->change};
  first.insert(first.end(), prepared->decisions.begin(), prepared->decisions.end());
  first.insert(first.end(), state.decisions.begin(), state.decisions.end());
  decisions.insert(decisions.begin(), first.begin(), first.end());
  if (const std::string given = given_names(framed->landmarks); !given.empty())
    decisions.push_back({"landmarks", given + " as given", "moved to the annulus"});
  const Expected<double> thickness_mm =
      tissue_thickness(options, prepared->thickness, valve.tissue.thickness_mm, decisions);
  if (!thickness_mm) return thickness_mm.errors();
  valve.tissue.thickness_mm = *thickness_mm;
  if (options.chordae_seed) {
    Expected<Valve> made = drawn(std::move(valve), framed->tips, *options.chordae_seed, decisions);
    if (!made) return made.errors();
    valve = *std::move(made);
  } else if (Errors errors = add_imported_chordae(*framed, *skirt, options, valve, decisions);
             !errors.empty()) {
    return errors;
  }
  decisions.insert(decisions.begin(), source.decisions.begin(), source.decisions.end());
  for (const ImportDecision& decision : decisions) valve.provenance.push_back(sentence(decision));
  Errors invalid = validate(valve);
  for (Error& error : invalid) error.message = "of the resampled valve " + error.message;
  if (!invalid.empty()) return invalid;
  return ImportedValve{
      std::move(valve),
      std::move(decisions),
      {framed->leaflets, framed->annulus_mm, framed->chordae, framed->tips, state.closed},
      unit,
      std::move(prepared->thickness)};
}

Expected<Valve> import_valve(ImportSource source, const ImportOptions& options) {
  Expected<ImportedValve> imported = import_with_decisions(std::move(source), options);
  if (!imported) return imported.errors();
  return std::move(imported->valve);
}

}  // namespace coapt
