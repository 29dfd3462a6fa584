// Where the chordae of a parametric valve go. Per muscle: five marginal trunks with three
// insertions each (two on the anterior half, one at the commissure, two on the posterior half), one
// strut chorda with two insertions at mid-height of the anterior leaflet, two basal chordae of the
// posterior leaflet: eight chordae a muscle with 19 insertions (counts: about 10 a muscle, n = 116
// hearts). First lengths: a marginal insertion is expected at rest on the line of coaptation, the
// others where they are unstressed and a little slack. core/presets replaces them by lengths of a
// closed state.

#include "core/valve/parametric_chordae.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace coapt {
namespace {

constexpr double kBranchAt = 0.75;    // of the way from tip to insertions (three quarters trunk)
constexpr double kBasalSlack = 1.15;  // first length over unstressed distance, strut and basal
constexpr double kLineBehind =
    0.22;  // line of coaptation, behind the centre, share of the AP diameter
constexpr double kLineBeforeTips = 0.15;  // the line lies at most so far in front of the tips: the
                                          // free edge swings until it is above them
constexpr double kLineFarthest = 0.68;  // from the saddle peak: no anterior leaflet reaches farther
constexpr double kLineDepth = 0.36;   // free edge below the annulus there, share of the AP diameter
constexpr double kLineWidth = 0.8;    // of the half-width of the annulus at the commissures
constexpr double kDiameter_mm = 1.0;  // thesis table 2.1

/// On the other side of the midline.
Segment mirrored(Segment segment) {
  switch (segment) {
    case Segment::A1:
      return Segment::A3;
    case Segment::A3:
      return Segment::A1;
    case Segment::P1:
      return Segment::P3;
    case Segment::P3:
      return Segment::P1;
    case Segment::AC:
      return Segment::PC;
    case Segment::PC:
      return Segment::AC;
    case Segment::A2:
    case Segment::P2:
      return segment;
  }
  return segment;
}

double wrap(double around) { return around - std::floor(around); }

/// Barycentric point of the structured skirt at (around, height).
Insertion insertion_at(const SkirtGrid& grid, const Valve& valve, const ChordaSite& site) {
  const double around = wrap(site.around);
  int i = grid.stations - 1;
  while (i > 0 && grid.around[i] > around) --i;
  const double low = grid.around[i];
  const double high = i + 1 < grid.stations ? grid.around[i + 1] : 1.0;
  const double u = (around - low) / (high - low);
  const double depth = site.height * grid.rows;
  const int row = std::min(grid.rows - 1, static_cast<int>(depth));
  const double v = depth - row;
  // The face of the cell, a unit square in (u, v), that holds the target.
  const Eigen::Vector2d target(u, v);
  const auto corner = [&](int vertex) {
    return Eigen::Vector2d(vertex % grid.stations == i ? 0.0 : 1.0, vertex / grid.stations - row);
  };
  const auto cross = [](const Eigen::Vector2d& s, const Eigen::Vector2d& t) {
    return s.x() * t.y() - s.y() * t.x();
  };
  Insertion best;
  double best_low = -1e300;
  const int cell = 2 * (row * grid.stations + i);
  for (int f = cell; f < cell + 2; ++f) {
    const Eigen::Vector2d origin = corner(valve.faces(f, 0));
    const Eigen::Vector2d p = corner(valve.faces(f, 1)) - origin,
                          q = corner(valve.faces(f, 2)) - origin, t = target - origin;
    const double w1 = cross(t, q) / cross(p, q), w2 = cross(p, t) / cross(p, q);
    const double lowest = std::min({1.0 - w1 - w2, w1, w2});
    if (lowest <= best_low) continue;
    best_low = lowest;
    const double x1 = std::max(0.0, w1), x2 = std::max(0.0, w2);
    best = {f, {std::max(0.0, 1.0 - x1 - x2), x1, x2}};
  }
  return best;
}

/// Where a free-edge point is expected in the closed valve: on a smile-shaped line behind the
/// centre, farther behind if the tips are. Expected in front of its muscle it would get a chorda so
/// long that it swings back and up to the annulus, and the leaflet billows.
Vec3 closed_free_edge(const Valve& valve, const ChordaSite& site, const Vec3& muscle) {
  const Vec3 medial = annulus_position_mm(valve, valve.landmarks.posteromedial_commissure);
  const Vec3 lateral = annulus_position_mm(valve, valve.landmarks.anterolateral_commissure);
  const Vec3 peak = annulus_position_mm(valve, valve.landmarks.saddle_peak);
  const double ap = (peak - annulus_position_mm(valve, valve.landmarks.mid_posterior)).norm();
  const double from_commissure =
      std::min({wrap(site.around), std::abs(wrap(site.around) - 0.5), 1.0 - wrap(site.around)}) /
      0.25;  // 0 commissure, 1 midline
  const bool medial_half = wrap(site.around + 0.25) < 0.5;
  const double towards = 0.5 - (medial_half ? 0.5 : -0.5) * kLineWidth * (1.0 - from_commissure);
  const double bow = std::sin(0.5 * 3.14159265358979323846 * from_commissure);
  Vec3 edge = medial + towards * (lateral - medial) -
              ap * Vec3(0.0, kLineBehind * bow, kLineDepth * (0.55 + 0.45 * bow));
  const double line = 0.5 * (medial.y() + lateral.y()) - kLineBehind * ap;
  const double allowed = std::max(muscle.y() + kLineBeforeTips * ap, peak.y() - kLineFarthest * ap);
  edge.y() -= bow * std::max(0.0, line - allowed);
  return edge;
}

Chorda make_chorda(const InsertionAt& insertion_at, const Valve& valve, const ChordaGroup& group,
                   int head, const std::string& id) {
  const Vec3 tip = valve.heads[head].tip_mm;
  const Vec3 muscle = papillary_tip_mm(valve, valve.heads[head].side);
  Chorda chorda{id, group.kind, head, false, {}};
  std::vector<Insertion> insertions;
  std::vector<Vec3> ends;
  Vec3 rest_mean = Vec3::Zero(), mean = Vec3::Zero();
  for (const ChordaSite& site : group.sites) {
    insertions.push_back(insertion_at(site));
    const Vec3 rest = position(insertions.back(), valve.faces, valve.rest_mm);
    ends.push_back(group.kind == ChordaKind::Marginal ? closed_free_edge(valve, site, muscle)
                                                      : tip + kBasalSlack * (rest - tip));
    rest_mean += rest / static_cast<double>(group.sites.size());
    mean += ends.back() / static_cast<double>(group.sites.size());
  }
  const bool branches = group.sites.size() > 1;
  const Vec3 fork = tip + kBranchAt * (mean - tip);
  if (branches) {
    ChordaSegment trunk;
    trunk.rest_length_mm = (fork - tip).norm();
    trunk.branch_point_mm = tip + kBranchAt * (rest_mean - tip);
    trunk.diameter_mm = kDiameter_mm;
    chorda.segments.push_back(trunk);
  }
  for (std::size_t i = 0; i < insertions.size(); ++i) {
    ChordaSegment twig;
    twig.parent = branches ? 0 : -1;
    twig.rest_length_mm = (ends[i] - (branches ? fork : tip)).norm();
    twig.diameter_mm = kDiameter_mm;
    twig.inserts = true;
    twig.insertion = insertions[i];
    chorda.segments.push_back(twig);
  }
  return chorda;
}

/// Heads of one muscle ordered from anterior to posterior.
std::vector<int> add_heads(const Points& tips_mm, Side side, Valve& valve) {
  std::vector<Vec3> tips;
  for (Index i = 0; i < tips_mm.rows(); ++i)
    if ((tips_mm(i, 0) < 0.0) == (side == Side::Anterolateral)) tips.push_back(tips_mm.row(i));
  if (tips.size() == 1) {
    const Vec3 middle = tips[0];
    const double outwards = side == Side::Anterolateral ? -1.0 : 1.0;
    tips = {middle + Vec3(0.0, 2.5, 0.0), middle + Vec3(outwards, 0.0, 0.0),
            middle - Vec3(0.0, 2.5, 0.0)};
  }
  std::sort(tips.begin(), tips.end(), [](const Vec3& p, const Vec3& q) { return p.y() > q.y(); });
  std::vector<int> heads;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    heads.push_back(static_cast<int>(valve.heads.size()));
    valve.heads.push_back({(side == Side::Anterolateral ? "AL" : "PM") + std::to_string(i + 1),
                           side, tips[i], tips[i]});
  }
  return heads;
}

}  // namespace

std::vector<ChordaGroup> parametric_groups() {
  using enum ChordaKind;
  using enum Segment;
  return {{Marginal, 0, A2, {{0.233, 1.0}, {0.200, 1.0}, {0.167, 1.0}}},
          {Marginal, 0, A3, {{0.133, 1.0}, {0.100, 1.0}, {0.067, 1.0}}},
          {Marginal, 1, PC, {{0.033, 1.0}, {0.0, 1.0}, {-0.033, 1.0}}},
          {Marginal, 2, P3, {{-0.067, 1.0}, {-0.100, 1.0}, {-0.133, 1.0}}},
          {Marginal, 2, P2, {{-0.167, 1.0}, {-0.200, 1.0}, {-0.233, 1.0}}},
          {Strut, 0, A2, {{0.175, 0.55}, {0.145, 0.55}}},
          {Basal, 2, P3, {{-0.085, 0.5}}},
          {Basal, 2, P2, {{-0.185, 0.5}}}};
}

ChordaGroup mirrored(ChordaGroup group) {
  for (ChordaSite& site : group.sites) site.around = wrap(0.5 - site.around);
  group.segment = mirrored(group.segment);
  return group;
}

void add_muscle(const Points& tips_mm, Side side, const std::vector<ChordaGroup>& groups,
                const InsertionAt& insertion_at, Valve& valve) {
  const std::vector<int> heads = add_heads(tips_mm, side, valve);
  const std::size_t last = heads.size() - 1;
  int number = 0;
  for (const ChordaGroup& group : groups) {
    const int head = heads[group.head == 0 ? 0 : group.head == 2 ? last : last / 2];
    ++number;
    valve.chordae.push_back(make_chorda(insertion_at, valve, group, head,
                                        valve.heads[head].id + "-" + to_string(group.segment) +
                                            "-" + to_string(group.kind) + "-" +
                                            std::to_string(number)));
  }
}

void add_parametric_chordae(const SkirtGrid& grid, const Points& tips_mm, Valve& valve) {
  const auto on_grid = [&](const ChordaSite& site) { return insertion_at(grid, valve, site); };
  const std::vector<ChordaGroup> medial = parametric_groups();
  std::vector<ChordaGroup> lateral;
  for (const ChordaGroup& group : medial) lateral.push_back(mirrored(group));
  add_muscle(tips_mm, Side::Anterolateral, lateral, on_grid, valve);
  add_muscle(tips_mm, Side::Posteromedial, medial, on_grid, valve);
}

}  // namespace coapt
