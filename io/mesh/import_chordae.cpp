#include "io/mesh/import_chordae.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/closure/contact.h"
#include "core/valve/counted.h"
#include "core/valve/leaflet_of.h"
#include "core/valve/number_text.h"
#include "core/valve/problem_list.h"

namespace coapt {
namespace {

constexpr double kSameTip_mm = 0.1;
constexpr double kMarginalReach_mm = 3.0;
constexpr double kSurfaceReach_mm = 8.0;
constexpr double kSurelyNearer_mm = 2.0;
constexpr double kUsualShift_mm = 4.0;  // of an insertion: more is looked at
// Of all insertions: 0.4 mm in the BodyParts3D valve, whose table has 1.6 to 2.2 mm where it lies 2 mm too high or too low.
constexpr double kUsualMeanShift_mm = 1.5;
constexpr double kTwigArc =
    1.0 / 60.0;  // between twigs, share of the annulus: a station of 720 triangles

/// A point of the free edge, counted in stations.
struct EdgePoint {
  double station = 0.0;
  Vec3 position_mm;
  double distance_mm = 1e300;
};

Vec3 edge_vertex(const Skirt& skirt, int station) {
  return skirt.vertices_mm.row(skirt.rows * skirt.stations + station % skirt.stations);
}

EdgePoint nearest_on_edge(const Skirt& skirt, const Vec3& point) {
  EdgePoint best;
  for (int i = 0; i < skirt.stations; ++i) {
    const Vec3 a = edge_vertex(skirt, i), along = edge_vertex(skirt, i + 1) - a;
    const double share = std::clamp(along.dot(point - a) / along.squaredNorm(), 0.0, 1.0);
    const Vec3 nearest = a + share * along;
    const double distance = (nearest - point).norm();
    if (distance < best.distance_mm) best = {i + share, nearest, distance};
  }
  return best;
}

/// The last row's lower faces end in the edge from station i + 1 to station i (corners 1 and 2).
Insertion on_edge(const Skirt& skirt, double station) {
  const double wrapped = station - skirt.stations * std::floor(station / skirt.stations);
  const int i = std::min(static_cast<int>(wrapped), skirt.stations - 1);
  const double share = wrapped - i;
  return {2 * ((skirt.rows - 1) * skirt.stations + i) + 1, {0.0, share, 1.0 - share}};
}

struct SurfacePoint {
  Insertion insertion;
  double distance_mm = 1e300;
};

SurfacePoint nearest_on_surface(const Valve& valve, const Vec3& point,
                                std::optional<Leaflet> leaflet = {}) {
  SurfacePoint best;
  for (int f = 0; f < valve.faces.rows(); ++f) {
    const Segment segment = valve.segments[static_cast<std::size_t>(f)];
    if (leaflet && leaflet_of(segment).value_or(*leaflet) != *leaflet) continue;
    const Vec3 a = valve.rest_mm.row(valve.faces(f, 0)), b = valve.rest_mm.row(valve.faces(f, 1)),
               c = valve.rest_mm.row(valve.faces(f, 2));
    const Vec3 weights = closest_point_weights(point, a, b, c);
    const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - point).norm();
    if (distance >= best.distance_mm) continue;
    best = {{f, {weights[0], weights[1], weights[2]}}, distance};
  }
  return best;
}

/// Index of the head at a tip; heads are ordered from anterior to posterior.
void add_heads(const std::vector<ImportedChorda>& chordae, Valve& valve) {
  for (const Side side : {Side::Anterolateral, Side::Posteromedial}) {
    std::vector<Vec3> tips;  // at rest
    std::vector<PapillaryHead> heads;
    for (const ImportedChorda& chorda : chordae) {
      const auto same = [&](const Vec3& tip) {
        return (tip - chorda.tip_mm).norm() <= kSameTip_mm;
      };
      if (chorda.side != side || std::any_of(tips.begin(), tips.end(), same)) continue;
      tips.push_back(chorda.tip_mm);
      heads.push_back({"", side, chorda.tip_mm, chorda.pressed_tip_mm.value_or(chorda.tip_mm)});
    }
    std::stable_sort(heads.begin(), heads.end(),
                     [](const auto& p, const auto& q) { return p.rest_mm.y() > q.rest_mm.y(); });
    for (std::size_t i = 0; i < heads.size(); ++i) {
      heads[i].id = (side == Side::Anterolateral ? "AL" : "PM") + std::to_string(i + 1);
      valve.heads.push_back(heads[i]);
    }
  }
}

int head_of(const ImportedChorda& chorda, const Valve& valve) {
  const auto found =
      std::find_if(valve.heads.begin(), valve.heads.end(), [&](const PapillaryHead& head) {
        return head.side == chorda.side && (head.rest_mm - chorda.tip_mm).norm() <= kSameTip_mm;
      });
  return static_cast<int>(found - valve.heads.begin());
}

/// Straight pieces from the head to the insertions, over a branch point if there are several.
std::vector<ChordaSegment> grow(const std::vector<Insertion>& insertions, const Vec3& tip,
                                const ImportOptions& options, const Valve& valve) {
  std::vector<ChordaSegment> segments;
  Vec3 from = tip;
  if (insertions.size() > 1) {
    Vec3 mean = Vec3::Zero();
    for (const Insertion& insertion : insertions)
      mean += position(insertion, valve.faces, valve.rest_mm);
    mean /= static_cast<double>(insertions.size());
    from = tip + options.branch_at * (mean - tip);
    ChordaSegment trunk;
    trunk.rest_length_mm = options.slack * (from - tip).norm();
    trunk.branch_point_mm = from;
    segments.push_back(trunk);
  }
  for (const Insertion& insertion : insertions) {
    ChordaSegment twig;
    twig.parent = insertions.size() > 1 ? 0 : -1;
    twig.inserts = true;
    twig.insertion = insertion;
    twig.rest_length_mm =
        options.slack * (position(insertion, valve.faces, valve.rest_mm) - from).norm();
    segments.push_back(twig);
  }
  return segments;
}

/// Where a traced end goes: the free edge if that is near, else the nearest point of the surface.
struct Landing {
  Insertion insertion;
  bool at_edge = false;
  double distance_mm = 0.0;
};

Landing land(const Vec3& end_mm, ChordaKind kind, const Skirt& skirt, const Valve& valve) {
  const EdgePoint edge = nearest_on_edge(skirt, end_mm);
  if (kind == ChordaKind::Marginal && edge.distance_mm <= kMarginalReach_mm)
    return {on_edge(skirt, edge.station), true, edge.distance_mm};
  const SurfacePoint nearest = nearest_on_surface(valve, end_mm);
  return {nearest.insertion, false, nearest.distance_mm};
}

/// The traced tree with its insertions where `landings` (one for each that inserts) say.
std::vector<ChordaSegment> traced(const ImportedChorda& imported,
                                  const std::vector<Landing>& landings, const Vec3& tip,
                                  double slack, const Valve& valve) {
  std::vector<ChordaSegment> segments;
  std::vector<Vec3> ends_mm;
  for (std::size_t i = 0, landed = 0; i < imported.segments.size(); ++i) {
    const ImportedSegment& piece = imported.segments[i];
    ChordaSegment& segment = segments.emplace_back();
    segment.parent = piece.parent;
    segment.diameter_mm = piece.diameter_mm;
    segment.inserts = piece.inserts;
    Vec3 end_mm = piece.end_mm;
    if (piece.inserts) {
      segment.insertion = landings[landed++].insertion;
      end_mm = position(segment.insertion, valve.faces, valve.rest_mm);
    } else {
      segment.branch_point_mm = end_mm;
    }
    const auto parent = static_cast<std::size_t>(piece.parent);
    const bool from_tip = piece.parent < 0;
    const double length = (end_mm - (from_tip ? tip : ends_mm[parent])).norm();
    const double traced_length =
        (piece.end_mm - (from_tip ? imported.tip_mm : imported.segments[parent].end_mm)).norm();
    segment.rest_length_mm =
        piece.rest_length_mm ? *piece.rest_length_mm + length - traced_length : slack * length;
    ends_mm.push_back(end_mm);
  }
  return segments;
}

/// What was done, for the provenance.
struct Attached {
  int marginal = 0, inner = 0, trees = 0, lengths = 0;
  double edge_max_mm = 0.0, surface_max_mm = 0.0;
  double shift_sum_mm = 0.0, insertions = 0.0;
  std::array<int, 2> meant_marginal = {},
                     at_edge = {};  ///< chordae of each leaflet, as given and as attached

  void shift(const Landing& landing) {
    double& most = landing.at_edge ? edge_max_mm : surface_max_mm;
    most = std::max(most, landing.distance_mm);
    shift_sum_mm += landing.distance_mm;
    insertions += 1.0;
  }
  double mean_shift_mm() const { return shift_sum_mm / std::max(1.0, insertions); }
};

/// Signs that the table lies elsewhere than the leaflets do, each with its figure.
std::string doubts_of(const Attached& attached) {
  std::string doubts;
  if (std::max(attached.edge_max_mm, attached.surface_max_mm) > kUsualShift_mm)
    doubts += "; insertions usually lie within " + significant(kUsualShift_mm, 2) +
              " mm of where they are attached";
  if (attached.mean_shift_mm() > kUsualMeanShift_mm)
    doubts += "; insertions are moved by " + significant(attached.mean_shift_mm(), 2) +
              " mm on average, up to " + significant(kUsualMeanShift_mm, 2) + " mm is usual";
  for (const Leaflet leaflet : {Leaflet::Anterior, Leaflet::Posterior}) {
    const auto i = static_cast<std::size_t>(leaflet);
    if (attached.meant_marginal[i] == 0 || attached.at_edge[i] > 0) continue;
    doubts += "; none of " +
              counted(attached.meant_marginal[i], "marginal chorda", "marginal chordae") +
              " of the " + to_string(leaflet) + " leaflet ends within " +
              significant(kMarginalReach_mm, 2) + " mm of its free edge";
  }
  return doubts;
}

ImportDecision described(const Attached& attached, const Valve& valve,
                         const ImportOptions& options) {
  std::string text = std::to_string(attached.marginal) +
                     " marginal, moved to the free edge by at most " +
                     significant(attached.edge_max_mm, 3) + " mm, ";
  if (attached.trees > 0) {
    text += counted(attached.trees, "chorda", "chordae") + " with the traced tree";
  } else {
    text += "each with " + counted(options.branches, "insertion");
    if (options.branches > 1) {
      text += " a sixtieth of the annulus apart, branching at " +
              significant(100.0 * options.branch_at, 3) + " % of the way";
    }
  }
  if (attached.inner > 0) {
    text += "; " + std::to_string(attached.inner) +
            " strut and basal, moved to the leaflet by at most " +
            significant(attached.surface_max_mm, 3) + " mm";
  }
  if (attached.lengths > 0)
    text += "; " + counted(attached.lengths, "piece") + " with the imported slack";
  text += "; " + std::to_string(valve.heads.size()) + " papillary heads";
  const std::string doubts = doubts_of(attached);
  return {"chordae", text,
          "lengths are straight distances at rest times " + significant(options.slack, 3) +
              (attached.lengths > 0 ? " elsewhere" : "") + doubts,
          !doubts.empty(), doubts.empty() ? 1.0 : 0.5};
}

}  // namespace

Errors add_imported_chordae(const FramedSource& source, const Skirt& skirt,
                            const ImportOptions& options, Valve& valve,
                            std::vector<ImportDecision>& decisions) {
  add_heads(source.chordae, valve);
  ProblemList problems;
  Attached attached;
  for (std::size_t i = 0; i < source.chordae.size(); ++i) {
    const ImportedChorda& imported = source.chordae[i];
    if (options.budget.is_cancelled()) return {{ErrorCode::Busy, "", "the import was cancelled"}};
    Chorda chorda;
    chorda.kind = imported.kind;
    chorda.head = head_of(imported, valve);
    const bool tree = !imported.segments.empty();
    std::vector<Landing> landings;
    for (const ImportedSegment& segment : imported.segments) {
      attached.lengths += segment.rest_length_mm ? 1 : 0;
      if (segment.inserts) landings.push_back(land(segment.end_mm, imported.kind, skirt, valve));
    }
    if (!tree) landings.push_back(land(imported.insertion_mm, imported.kind, skirt, valve));
    const bool marginal = std::any_of(landings.begin(), landings.end(),
                                      [](const Landing& landing) { return landing.at_edge; });
    std::vector<Insertion> insertions;
    for (const Landing& landing : landings) {
      insertions.push_back(landing.insertion);
      attached.shift(landing);
      if (landing.at_edge || landing.distance_mm <= kSurfaceReach_mm) continue;
      problems.add(
          ErrorCode::BadGeometry, "/chordae/" + std::to_string(i) + "/insertion_mm",
          "is " + shown(landing.distance_mm) + " mm from the leaflets, must be within 8 mm");
    }
    (marginal ? attached.marginal : attached.inner) += 1;
    attached.trees += tree ? 1 : 0;
    if (imported.kind == ChordaKind::Marginal) {
      const auto leaflet =
          leaflet_of(valve.segments[static_cast<std::size_t>(insertions.front().face)]);
      if (!marginal)
        chorda.kind = leaflet == Leaflet::Anterior ? ChordaKind::Strut : ChordaKind::Basal;
      if (leaflet) {
        ++attached.meant_marginal[static_cast<std::size_t>(*leaflet)];
        attached.at_edge[static_cast<std::size_t>(*leaflet)] += marginal ? 1 : 0;
      }
    }
    if (!tree && marginal) {
      const double station = nearest_on_edge(skirt, imported.insertion_mm).station;
      insertions.clear();
      for (int twig = 0; twig < options.branches; ++twig) {
        const double offset = (twig - 0.5 * (options.branches - 1)) * kTwigArc * skirt.stations;
        insertions.push_back(on_edge(skirt, station + offset));
      }
    }
    const PapillaryHead& head = valve.heads[static_cast<std::size_t>(chorda.head)];
    const Segment segment =
        valve.segments[static_cast<std::size_t>(insertions[insertions.size() / 2].face)];
    chorda.id =
        head.id + '-' + to_string(segment) + '-' + to_string(chorda.kind) + '-' + imported.id;
    chorda.segments = tree ? traced(imported, landings, head.rest_mm, options.slack, valve)
                           : grow(insertions, head.rest_mm, options, valve);
    valve.chordae.push_back(std::move(chorda));
  }
  decisions.push_back(described(attached, valve, options));
  return std::move(problems).take();
}

Errors add_imported_ties(const FramedSource& source, bool closed, Valve& valve,
                         std::vector<ImportDecision>& decisions) {
  if (source.ties.empty()) return {};
  if (closed)
    return {{ErrorCode::Unsupported, "/ties",
             "cannot be placed on leaflets imaged closed, because their free edges are hidden; "
             "export the open shape, or leave the ties out"}};
  ProblemList problems;
  double moved_mm = 0.0;
  for (std::size_t i = 0; i < source.ties.size(); ++i) {
    const ImportedTie& imported = source.ties[i];
    const auto landed = [&](const Vec3& end_mm, Leaflet leaflet, const char* name) {
      SurfacePoint nearest = nearest_on_surface(valve, end_mm, leaflet);
      // Both ends of the sutures of a cleft are on the posterior leaflet.
      if (const SurfacePoint other = nearest_on_surface(valve, end_mm, Leaflet::Posterior);
          other.distance_mm + kSurelyNearer_mm < nearest.distance_mm)
        nearest = other;
      moved_mm = std::max(moved_mm, nearest.distance_mm);
      if (!(nearest.distance_mm <= kSurfaceReach_mm))
        problems.add(ErrorCode::BadGeometry, "/ties/" + std::to_string(i) + name,
                     "lies " + with_decimals(nearest.distance_mm, 1) + " mm from the " +
                         to_string(leaflet) + " leaflet; must lie within " +
                         shown(kSurfaceReach_mm) + " mm of it");
      return nearest.insertion;
    };
    Tie& tie = valve.ties.emplace_back();
    tie.id = imported.id;
    tie.anterior = landed(imported.anterior_mm, Leaflet::Anterior, "/anterior_mm");
    tie.posterior = landed(imported.posterior_mm, Leaflet::Posterior, "/posterior_mm");
    tie.rest_length_mm = valve.tissue.thickness_mm;
  }
  decisions.push_back({"ties",
                       std::to_string(source.ties.size()) + " of an edge-to-edge repair kept",
                       "moved onto the leaflets by at most " + with_decimals(moved_mm, 2) + " mm"});
  return std::move(problems).take();
}

}  // namespace coapt
