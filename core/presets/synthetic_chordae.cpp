#include "core/presets/synthetic_chordae.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/presets/human_presets.h"
#include "core/presets/taut_valve.h"
#include "core/valve/leaflet_coordinates.h"
#include "core/valve/leaflet_point.h"
#include "core/valve/parametric_chordae.h"
#include "core/valve/problem_list.h"
#include "core/valve/validate.h"

namespace coapt {
namespace {

constexpr double kValveSlackSd = 0.05, kChordaSlackSd = 0.03;
// Tips of a human valve of 29 x 39 mm (parametric.h), in proportion; sd of cadavers for the depth.
constexpr double kDepth = 23.5 / 29.0, kSpread = 26.0 / 39.0, kBehind = 4.0 / 29.0;
constexpr double kDepthSd_mm = 3.8, kAcrossSd_mm = 2.0;
constexpr double kHalf = 0.25;  // of the annulus, from a commissure to the midlines
constexpr Range kTipDepth_mm = {5.0, 60.0};

/// Numbers of one draw, always the same ones (Vigna's splitmix64); those of seed 0 are the means.
class Draw {
 public:
  explicit Draw(int seed) : is_mean_(seed == 0), state_(static_cast<std::uint64_t>(seed)) {}

  double share() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    z ^= z >> 31;
    return is_mean_ ? 0.5 : static_cast<double>(z >> 11) * 0x1p-53;
  }
  double within(double half_width) { return half_width * (2.0 * share() - 1.0); }
  /// Sum of twelve uniform numbers: at most six standard deviations, the same bits everywhere.
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += share();
    return sum;
  }

 private:
  bool is_mean_;
  std::uint64_t state_;
};

/// Marginal trunks over the muscle's half of the free edge, each in its own part, somewhere about its middle; three
/// insertions a third of the part apart.
std::vector<ChordaGroup> marginal_groups(Draw& draw) {
  constexpr int kFewest = 3, kMost = 7;
  const int trunks = kFewest + static_cast<int>(draw.share() * (kMost - kFewest + 1));
  const double part = 2.0 * kHalf / trunks;
  std::vector<ChordaGroup> groups;
  for (int i = 0; i < trunks; ++i) {
    const double middle = kHalf - (i + 0.5) * part + draw.within(0.25 * part);
    const bool in_front = middle > 0.5 * part, behind = middle < -0.5 * part;
    ChordaGroup group{ChordaKind::Marginal, in_front ? 0 : behind ? 2 : 1, Segment::PC, {}};
    for (const int twig : {1, 0, -1}) group.sites.push_back({middle + twig * part / 3.0, 1.0});
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Of the posteromedial muscle.
std::vector<ChordaGroup> groups_of(Draw& draw) {
  constexpr double kAlong = 0.02, kDown = 0.1;
  std::vector<ChordaGroup> groups = marginal_groups(draw);
  for (ChordaGroup group : parametric_groups()) {
    if (group.kind == ChordaKind::Marginal) continue;
    const double along = draw.within(kAlong), down = draw.within(kDown);
    for (ChordaSite& site : group.sites) {
      site.around += along;
      site.height += down;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Row 0 anterolateral, row 1 posteromedial.
Points drawn_tips(const Valve& valve, Draw& draw) {
  const auto at = [&](int vertex) { return annulus_position_mm(valve, vertex); };
  const Landmarks& marks = valve.landmarks;
  const double width =
      (at(marks.posteromedial_commissure) - at(marks.anterolateral_commissure)).norm();
  const double ap = (at(marks.saddle_peak) - at(marks.mid_posterior)).norm();
  const Vec3 middle = valve.annulus_mm.colwise().mean();
  Points tips_mm(2, 3);
  for (const int row : {0, 1}) {
    const double outwards = row == 0 ? -0.5 * kSpread * width : 0.5 * kSpread * width;
    const double x = kAcrossSd_mm * draw.normal(), y = kAcrossSd_mm * draw.normal();
    const Vec3 by(x, y, kDepthSd_mm * draw.normal());
    tips_mm.row(row) = (middle + Vec3(outwards, -kBehind * ap, -kDepth * ap) + by).transpose();
  }
  return tips_mm;
}

Errors check_tips(const Points& tips_mm) {
  ProblemList problems;
  bool lateral = false, medial = false;
  for (Eigen::Index i = 0; i < tips_mm.rows(); ++i) {
    (tips_mm(i, 0) < 0.0 ? lateral : medial) = true;
    check_range(problems, "/tips_mm/" + std::to_string(i), -tips_mm(i, 2), kTipDepth_mm, " mm");
  }
  if (!lateral || !medial)
    problems.add(ErrorCode::BadGeometry, "/tips_mm",
                 "must lie on both sides of the midline: one papillary muscle has none");
  return std::move(problems).take();
}

/// By how much the heads of one side move under pressure, on average.
Vec3 displacement_mm(const std::vector<PapillaryHead>& heads, Side side) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const PapillaryHead& head : heads) {
    if (head.side != side) continue;
    sum += head.tip_mm - head.rest_mm;
    ++count;
  }
  return count > 0 ? Vec3(sum / count) : sum;
}

/// Names and segments follow from where chordae ended up.
void name_chordae(Valve& valve) {
  for (std::size_t i = 0; i < valve.chordae.size(); ++i) {
    Chorda& chorda = valve.chordae[i];
    const ChordaSegment& end = chorda.segments[chorda.segments.size() / 2];
    const Segment at = valve.segments[static_cast<std::size_t>(end.insertion.face)];
    chorda.id = valve.heads[static_cast<std::size_t>(chorda.head)].id + '-' + to_string(at) + '-' +
                to_string(chorda.kind) + '-' + std::to_string(i + 1);
  }
}

/// Lengths of the closed state, times the healthy preset's slack of the group, one drawn for the valve and one for each chorda.
Expected<Valve> with_drawn_lengths(const Valve& valve, Draw& draw, const ClosureBudget& budget) {
  Expected<Valve> made = taut_when_closed(valve, budget);
  if (!made) return made;
  const ChordalSlack healthy = human_normal().dimensions.slack;
  const double slack = 1.0 + kValveSlackSd * draw.normal();
  for (Chorda& chorda : made->chordae) {
    const double own =
        slack * (1.0 + kChordaSlackSd * draw.normal()) * slack_of(healthy, *made, chorda);
    for (ChordaSegment& segment : chorda.segments) segment.rest_length_mm *= own;
  }
  return made;
}

}  // namespace

Expected<Valve> with_synthetic_chordae(Valve valve, int seed, const Points& tips_mm,
                                       const ClosureBudget& budget) {
  const Points pressed_mm = valve.annulus_mm;
  const std::vector<PapillaryHead> old_heads = valve.heads;
  valve.annulus_mm = valve.rest_mm(valve.annulus, Eigen::all);
  valve.heads.clear();
  valve.chordae.clear();
  Draw draw(seed);
  const Points drawn_mm = drawn_tips(valve, draw);  // drawn in any case: the rest is the same
  const Points& at_mm = tips_mm.rows() > 0 ? tips_mm : drawn_mm;
  if (Errors errors = check_tips(at_mm); !errors.empty()) {
    if (tips_mm.rows() > 0) return errors;
    return Error{
        ErrorCode::OutOfRange, "/annulus_mm",
        "is of a size for which no papillary tips can be synthesised: the depth of a tip " +
            errors[0].message};
  }
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  const auto located = [&](const ChordaSite& site) {
    return locate(valve, coordinates, leaflet_point(site.around, site.height));
  };
  std::vector<ChordaGroup> lateral;
  for (const ChordaGroup& group : groups_of(draw)) lateral.push_back(mirrored(group));
  add_muscle(at_mm, Side::Anterolateral, lateral, located, valve);
  add_muscle(at_mm, Side::Posteromedial, groups_of(draw), located, valve);
  name_chordae(valve);
  if (Errors errors = validate(valve); !errors.empty()) return errors;
  Expected<Valve> made = with_drawn_lengths(valve, draw, budget);
  if (!made) return made;
  made->annulus_mm = pressed_mm;
  for (PapillaryHead& head : made->heads) head.tip_mm += displacement_mm(old_heads, head.side);
  made->drawn_chordae = DrawnChordae{seed, tips_mm.rows() > 0};
  if (Errors errors = validate(*made); !errors.empty()) return errors;
  return made;
}

Expected<Valve> redrawn_chordae(const Valve& valve, int seed, const ClosureBudget& budget) {
  Points tips_mm(0, 3);
  if (valve.drawn_chordae && valve.drawn_chordae->tips_given) {
    tips_mm.resize(std::ssize(valve.heads), 3);
    for (Eigen::Index i = 0; i < tips_mm.rows(); ++i)
      tips_mm.row(i) = valve.heads[static_cast<std::size_t>(i)].rest_mm.transpose();
  }
  return with_synthetic_chordae(valve, seed, tips_mm, budget);
}

}  // namespace coapt
