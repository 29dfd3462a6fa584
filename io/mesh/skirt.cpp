// Eight cuts a station. A cut is kept as offsets (distance from the axis, z) from its annulus point
// at rows + 1 equal lengths; a station is the mean of the cuts around it, weighted by a hat that
// falls to zero a sixtieth of the annulus away (or a station, if that is more): the roots of single
// chordae make steps in the free edge that are steeper than a fine mesh can follow, and the shape
// shall not depend on the mesh. The notch between two sheets counts as bare: cuts shorter than half
// the median within a twentieth of the annulus from where they meet. Bare cuts are interpolated
// linearly between their neighbours.

#include "io/mesh/skirt.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/metrics/surface_tree.h"
#include "core/valve/contour.h"
#include "core/valve/median.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"
#include "io/mesh/given_landmarks.h"
#include "io/mesh/hanging_profile.h"
#include "io/mesh/leaflet_cut.h"

namespace coapt {
namespace {

constexpr int kCutsPerStation = 8;
constexpr int kScan = 720;                // cuts that look for the commissures
constexpr double kStationsPerRow = 10.0;  // edges of about 2 x 2 mm at 720 triangles
constexpr double kNotchShare = 0.5;       // of the median length
constexpr double kNotchReach = 0.05;  // share of the annulus on both sides of where the sheets meet
constexpr double kSmoothArc = 1.0 / 60.0;
constexpr double kMostBare = 1.0 / 3.0;
constexpr double kWellCut = 0.35 / 0.5;  // of half the annulus's width, beyond it sections graze
constexpr double kMostGrazed =
    0.6;  // of the annulus, of closed leaflets: also what is near commissures
constexpr double kCommissureShare =
    9.0 / 39.0;                        // height over width of a human valve (parametric.h)
constexpr double kAnteriorArc = 0.38;  // share of the annulus, where one skirt does not tell

struct Profile {
  bool bare = true;
  double length_mm = 0.0, bridge_mm = 0.0, gap_mm = 0.0;
  double exposed_mm = 0.0;   ///< of a leaflet that was imaged closed
  Eigen::MatrixX2d offsets;  // rows + 1 x (distance from the axis, z), from the annulus point
};

/// Points at equal lengths along a line, relative to its first.
Eigen::MatrixX2d resample(const std::vector<Eigen::Vector2d>& line, double length, int rows) {
  Eigen::MatrixX2d points = Eigen::MatrixX2d::Zero(rows + 1, 2);
  double passed = 0.0;
  std::size_t i = 1;
  for (int row = 1; row <= rows; ++row) {
    const double target = length * row / rows;
    while (i + 1 < line.size() && passed + (line[i] - line[i - 1]).norm() < target) {
      passed += (line[i] - line[i - 1]).norm();
      ++i;
    }
    const double span = (line[i] - line[i - 1]).norm();
    const double share = span > 0.0 ? std::min(1.0, (target - passed) / span) : 0.0;
    points.row(row) = line[i - 1] + share * (line[i] - line[i - 1]) - line.front();
  }
  return points;
}

Profile profile_at(const FramedSource& source, const Vec3& annulus, int rows) {
  const LeafletCut cut = cut_leaflets(source.leaflets, annulus);
  Profile profile;
  profile.offsets = Eigen::MatrixX2d::Zero(rows + 1, 2);
  if (cut.line_mm.empty()) return profile;
  profile.bare = false;
  profile.length_mm = cut.length_mm();
  profile.bridge_mm = cut.widest_bridge_mm;
  profile.gap_mm = (cut.line_mm[1] - cut.line_mm[0]).norm();
  profile.offsets = resample(cut.line_mm, profile.length_mm, rows);
  return profile;
}

/// Of a leaflet that was imaged closed: hanging straight, as tall as it is unpressurised.
Profile hanging_profile(double height_mm, int rows) {
  const double angle = kHangingInclination_deg * std::numbers::pi / 180.0;
  const Eigen::RowVector2d down(-std::sin(angle), -std::cos(angle));
  Profile profile;
  profile.bare = false;
  profile.length_mm = height_mm;
  profile.offsets = Eigen::VectorXd::LinSpaced(rows + 1, 0.0, height_mm) * down;
  return profile;
}

/// `opposite`: the other leaflet. Bare where the section grazes the leaflet, near the commissures, and where none begins at the annulus.
Profile closed_profile(const FramedSource& source, const SurfaceTree& opposite, const Vec3& annulus,
                       std::size_t sheet, double hidden_mm, int rows) {
  Profile bare;
  bare.offsets = Eigen::MatrixX2d::Zero(rows + 1, 2);
  const double half_width = source.annulus_mm.col(0).cwiseAbs().maxCoeff();
  if (std::abs(annulus.x()) > kWellCut * half_width) return bare;
  const std::optional<ExposedLeaflet> exposed =
      exposed_leaflet(source.leaflets[sheet], annulus, CutOptions{}.reach_mm);
  if (!exposed) return bare;
  const bool meets = opposite.nearest(exposed->end_mm).distance_mm < kMeet_mm;
  Profile profile =
      hanging_profile(exposed->length_mm / kClosedStretch + (meets ? hidden_mm : 0.0), rows);
  profile.exposed_mm = exposed->length_mm;
  return profile;
}

/// Arcs of both commissures.
struct Commissures {
  double medial_mm = 0.0, lateral_mm = 0.0;
  bool measured = false, given = false;
  double off_mm = 0.0;  ///< of given ones from measured ones
};

/// Walks from the front of the annulus to the first cut that begins with the posterior sheet; the
/// answer lies midway between that and the last cut that begins with the anterior one. Negative
/// steps walk clockwise.
std::optional<double> find_commissure(const FramedSource& source, const ArcLength& arc,
                                      double step_mm, const ClosureBudget& budget) {
  const double front = arc.crossing_mm(true);
  int last = -1;
  for (int i = 0; i < kScan && !budget.is_cancelled(); ++i) {
    const int sheet = cut_leaflets(source.leaflets, arc.at(front + i * step_mm)).sheet;
    if (sheet == 0) last = i;
    if (sheet != 1) continue;
    if (last < 0) return std::nullopt;
    return front + 0.5 * (last + i) * step_mm;
  }
  return std::nullopt;
}

/// Where they were given: the lateral one further along the annulus than the medial one.
Commissures given_commissures(const FramedSource& source, const ArcLength& arc) {
  const double medial = nearest_arc_mm(arc, *source.landmarks.posteromedial_commissure_mm);
  const double lateral = nearest_arc_mm(arc, *source.landmarks.anterolateral_commissure_mm);
  return {medial, lateral + (lateral < medial ? arc.total_mm() : 0.0), false, true};
}

/// For both leaflets: the anterior one's share of the annulus.
bool leaves_room(double share) { return share > 0.1 && share < 0.9; }

/// Where two sheets meet.
std::optional<Commissures> measured_commissures(const FramedSource& source, const ArcLength& arc,
                                                const ClosureBudget& budget) {
  const double total = arc.total_mm();
  const std::optional<double> medial = find_commissure(source, arc, -total / kScan, budget);
  const std::optional<double> lateral = find_commissure(source, arc, total / kScan, budget);
  if (!medial || !lateral) return std::nullopt;
  const Commissures found{*medial + total, *lateral + total, true, false};
  if (!leaves_room((found.lateral_mm - found.medial_mm) / total)) return std::nullopt;
  return found;
}

Expected<Commissures> find_commissures(const FramedSource& source, const ArcLength& arc,
                                       const ClosureBudget& budget) {
  const double total = arc.total_mm(), front = arc.crossing_mm(true);
  const GivenLandmarks& seen = source.landmarks;
  if (seen.posteromedial_commissure_mm && seen.anterolateral_commissure_mm) {
    Commissures given = given_commissures(source, arc);
    const double share = (given.lateral_mm - given.medial_mm) / total;
    if (!leaves_room(share))
      return Error{
          ErrorCode::BadGeometry, "/landmarks/anterolateral_commissure_mm",
          "lies " + shown(std::round(100.0 * share)) +
              " % of the annulus from the posteromedial commissure, measured over the front; "
              "must be from 10 to 90 %"};
    if (source.leaflets.size() == 1) return given;
    if (const auto measured = measured_commissures(source, arc, budget))
      given.off_mm =
          std::max(std::abs(std::remainder(given.medial_mm - measured->medial_mm, total)),
                   std::abs(std::remainder(given.lateral_mm - measured->lateral_mm, total)));
    return given;
  }
  if (source.leaflets.size() == 1) {
    const double half = 0.5 * kAnteriorArc * total;
    return Commissures{front - half, front + half};
  }
  if (const auto measured = measured_commissures(source, arc, budget)) return *measured;
  return Error{ErrorCode::BadGeometry, "/leaflets",
               "must meet at two commissures, with the anterior sheet in front, the posterior "
               "sheet behind, and both beginning within 3 mm of the annulus"};
}

double median_length(const std::vector<Profile>& profiles) {
  std::vector<double> lengths;
  for (const Profile& profile : profiles) {
    if (!profile.bare) lengths.push_back(profile.length_mm);
  }
  return lengths.empty() ? 0.0 : median(lengths);
}

/// Marks the cuts of the notch around cut `centre`.
void bare_notch(int centre, double shortest_mm, std::vector<Profile>& profiles) {
  const int n = static_cast<int>(profiles.size());
  const int reach = static_cast<int>(std::lround(kNotchReach * n));
  for (int i = centre - reach; i <= centre + reach; ++i) {
    Profile& profile = profiles[static_cast<std::size_t>((i % n + n) % n)];
    if (profile.length_mm >= shortest_mm) continue;
    profile.bare = true;
    profile.bridge_mm = 0.0;
  }
}

/// @pre some profile is not bare.
void interpolate_bare(std::vector<Profile>& profiles) {
  const std::size_t n = profiles.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!profiles[i].bare) continue;
    std::size_t back = 1, ahead = 1;
    while (profiles[(i + n - back) % n].bare) ++back;
    while (profiles[(i + ahead) % n].bare) ++ahead;
    const double share = static_cast<double>(back) / static_cast<double>(back + ahead);
    profiles[i].offsets = (1.0 - share) * profiles[(i + n - back) % n].offsets +
                          share * profiles[(i + ahead) % n].offsets;
  }
}

/// Cuts from the top of the hat to where it is zero.
int hat_cuts(int cuts) {
  return std::max(kCutsPerStation, static_cast<int>(std::lround(kSmoothArc * cuts)));
}

void place_station(const std::vector<Profile>& profiles, const Vec3& annulus, int station,
                   Skirt& skirt) {
  const int n = static_cast<int>(profiles.size());
  const int centre = station * kCutsPerStation;
  const int width = hat_cuts(n);
  Eigen::MatrixX2d offsets = Eigen::MatrixX2d::Zero(skirt.rows + 1, 2);
  for (int k = 1 - width; k < width; ++k) {
    const double weight = static_cast<double>(width - std::abs(k)) / (width * width);
    offsets += weight * profiles[static_cast<std::size_t>(((centre + k) % n + n) % n)].offsets;
  }
  const Vec3 outwards = Vec3(annulus.x(), annulus.y(), 0.0).normalized();
  for (int row = 0; row <= skirt.rows; ++row) {
    skirt.vertices_mm.row(row * skirt.stations + station) =
        annulus + offsets(row, 0) * outwards + offsets(row, 1) * Vec3::UnitZ();
  }
  skirt.interpolated.push_back(profiles[static_cast<std::size_t>(centre)].bare);
}

}  // namespace

SkirtSize skirt_size(int triangles) {
  SkirtSize size;
  size.rows =
      std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / (2.0 * kStationsPerRow)))));
  size.stations = 2 * std::max(6, static_cast<int>(std::lround(triangles / (4.0 * size.rows))));
  return size;
}

Expected<Skirt> resample_skirt(const FramedSource& source, const SkirtSize& size,
                               const ImagedLeaflets& imaged, const ClosureBudget& budget) {
  const ArcLength arc(source.annulus_mm);
  const Expected<Commissures> commissures = find_commissures(source, arc, budget);
  if (!commissures) return commissures.errors();
  Skirt skirt;
  skirt.rows = size.rows;
  skirt.stations = size.stations;
  skirt.spacing_mm = arc.total_mm() / skirt.stations;
  skirt.commissures_measured = commissures->measured;
  skirt.commissures_given = commissures->given;
  skirt.commissures_off_mm = commissures->off_mm;
  const double anterior = commissures->lateral_mm - commissures->medial_mm;
  skirt.lateral_commissure = static_cast<int>(std::lround(anterior / skirt.spacing_mm));
  const auto arc_at = [&](double station) {
    return commissures->medial_mm + station * skirt.spacing_mm;
  };

  const int cuts = skirt.stations * kCutsPerStation;
  skirt.hat_mm = hat_cuts(cuts) * skirt.spacing_mm / kCutsPerStation;
  std::vector<SurfaceTree> surfaces;
  if (imaged.closed)
    for (const TriangleMesh& leaflet : source.leaflets)
      surfaces.emplace_back(leaflet.vertices_mm, leaflet.faces);
  std::vector<Profile> profiles;
  for (int i = 0; i < cuts; ++i) {
    if (budget.is_cancelled()) return Error{ErrorCode::Busy, "", "the import was cancelled"};
    const double station = static_cast<double>(i) / kCutsPerStation;
    const Vec3 annulus = arc.at(arc_at(station));
    const std::size_t sheet = station * skirt.spacing_mm < anterior ? 0 : 1;
    profiles.push_back(imaged.closed ? closed_profile(source, surfaces[1 - sheet], annulus, sheet,
                                                      imaged.hidden_mm, skirt.rows)
                                     : profile_at(source, annulus, skirt.rows));
  }
  if (imaged.closed) {
    const auto lateral =
        static_cast<std::size_t>(std::lround(anterior / skirt.spacing_mm * kCutsPerStation));
    skirt.anterior_exposed_mm = profiles[lateral / 2].exposed_mm;
    skirt.posterior_exposed_mm = profiles[(lateral + profiles.size()) / 2].exposed_mm;
    const double height_mm = kCommissureShare * (source.annulus_mm.col(0).maxCoeff() -
                                                 source.annulus_mm.col(0).minCoeff());
    profiles[0] = profiles[lateral] = hanging_profile(height_mm, skirt.rows);
  } else if (source.leaflets.size() == 2) {
    const double shortest = kNotchShare * median_length(profiles);
    bare_notch(0, shortest, profiles);
    bare_notch(static_cast<int>(std::lround(anterior / skirt.spacing_mm * kCutsPerStation)),
               shortest, profiles);
  }
  double bare = 0.0;
  for (const Profile& profile : profiles) {
    bare += profile.bare ? 1.0 : 0.0;
    skirt.widest_bridge_mm = std::max(skirt.widest_bridge_mm, profile.bridge_mm);
    skirt.annulus_gap_mm += profile.gap_mm / cuts;
  }
  if (bare > (imaged.closed ? kMostGrazed : kMostBare) * cuts) {
    return Error{ErrorCode::BadGeometry, "/leaflets",
                 "leave " + shown(std::round(100.0 * bare / cuts)) +
                     " % of the annulus without a sheet within 3 mm; at most a third is accepted"};
  }
  interpolate_bare(profiles);
  skirt.vertices_mm.resize((skirt.rows + 1) * skirt.stations, 3);
  for (int i = 0; i < skirt.stations; ++i) place_station(profiles, arc.at(arc_at(i)), i, skirt);
  return skirt;
}

}  // namespace coapt
