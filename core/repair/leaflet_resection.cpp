#include "core/repair/leaflet_resection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/repair/leaflet_cut.h"
#include "core/repair/limits.h"
#include "core/repair/sewn_shape.h"

namespace coapt {
namespace {

constexpr double kAtCommissure = 1e-6;  // of `along`
constexpr double kUnmoved = 1e-9;       // of `along`
constexpr int kSeamPieces = 12;
constexpr int kPathPieces = 4;  // of an edge, along the folds that it leads over

Range widths_mm(const LeafletResection& step) {
  if (step.shape == ResectionShape::Quadrangular) return kQuadrangularMm;
  return step.leaflet == Leaflet::Anterior ? kAnteriorTriangularMm : kTriangularMm;
}

/// A vertex of the leaflet that is cut.
struct Place {
  bool on_leaflet = false;
  double along = 0.0, height = 0.0;
};

class Resected {
 public:
  Resected(const LeafletCut& cut, const LeafletCoordinates& coordinates, const Valve& valve)
      : cut_(cut), coordinates_(coordinates), valve_(valve) {
    for (Index v = 0; v < valve.rest_mm.rows(); ++v) {
      const LeafletPoint point = leaflet_point(coordinates.around[v], coordinates.height[v]);
      places_.push_back({point.leaflet == cut.step().leaflet, point.along, point.height});
    }
  }

  Points rest_mm() const {
    std::map<std::array<int, 2>, double> lengths;
    for (const auto& face : valve_.faces.rowwise())
      for (int k = 0; k < 3; ++k) {
        const int a = face[k], b = face[(k + 1) % 3];
        lengths.try_emplace({std::min(a, b), std::max(a, b)}, length_mm(a, b));
      }
    std::vector<EdgeLength> edges;
    for (const auto& [vertices, length] : lengths) edges.push_back({vertices, length});
    return sewn_shape(valve_.rest_mm, edges, free_vertices());
  }

 private:
  /// Of the tissue that an edge on one side of the seam stands for, over the leaflet: a fold between its ends has tissue, too.
  double path_mm(const Place& from, const Place& to, int side, double before_mm) const {
    const double first = cut_.tissue_at(from.along, from.height, side),
                 last = cut_.tissue_at(to.along, to.height, side);
    if (std::abs(first - from.along) < kUnmoved && std::abs(last - to.along) < kUnmoved)
      return before_mm;
    const auto at_mm = [&](int piece) {
      const double share = static_cast<double>(piece) / kPathPieces;
      return rest_position_mm(valve_, coordinates_,
                              {cut_.step().leaflet, std::lerp(first, last, share),
                               std::lerp(from.height, to.height, share)});
    };
    double sum = 0.0;
    Vec3 reached = at_mm(0);
    for (int piece = 1; piece <= kPathPieces; ++piece) {
      const Vec3 next = at_mm(piece);
      sum += (next - reached).norm();
      reached = next;
    }
    return sum;
  }

  double length_mm(int a, int b) const {
    const Place &p = places_[a], &q = places_[b];
    const double before = (valve_.rest_mm.row(a) - valve_.rest_mm.row(b)).norm();
    if (!p.on_leaflet || !q.on_leaflet) return before;
    const double middle = cut_.step().along;
    if (p.along <= middle && q.along <= middle) return path_mm(p, q, -1, before);
    if (p.along >= middle && q.along >= middle) return path_mm(p, q, 1, before);
    const auto [from, to] = p.along < q.along ? std::tie(p, q) : std::tie(q, p);
    return before * cut_.across_seam({from.along, from.height}, {to.along, to.height});
  }

  std::vector<bool> free_vertices() const {
    std::vector<bool> free;
    for (const Place& place : places_)
      free.push_back(place.on_leaflet && place.along > kAtCommissure &&
                     place.along < 1.0 - kAtCommissure);
    return free;
  }

  const LeafletCut& cut_;
  const LeafletCoordinates& coordinates_;
  const Valve& valve_;
  std::vector<Place> places_;
};

/// Unit vectors of the faces, turned with their sides.
Points turned_fibres(const Valve& valve, const Points& rest_mm) {
  Points fibres = valve.fibre;
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    const auto sides = [&](const Points& points) {
      const Vec3 corner = points.row(valve.faces(f, 0));
      Eigen::Matrix<double, 3, 2> both;
      both << points.row(valve.faces(f, 1)).transpose() - corner,
          points.row(valve.faces(f, 2)).transpose() - corner;
      return both;
    };
    const Eigen::Matrix<double, 3, 2> before = sides(valve.rest_mm), now = sides(rest_mm);
    if (before == now) continue;
    const Vec3 fibre = valve.fibre.row(f);
    fibres.row(f) = (now * (before.transpose() * before).inverse() * (before.transpose() * fibre))
                        .normalized()
                        .transpose();
  }
  return fibres;
}

/// The annulus where the tissue was cut out is gathered away: its two halves, as long as they are,
/// turn about their commissures until they meet.
void plicate(const LeafletCut& cut, Valve& valve) {
  const LeafletResection& step = cut.step();
  const auto at_mm = [&](double along) {
    return annulus_point_mm(valve, around({Leaflet::Posterior, along, 0.0}));
  };
  const double half = 0.5 * cut.width_along(0.0);
  const Vec3 lateral = at_mm(0.0), medial = at_mm(1.0);
  const Vec3 from = at_mm(step.along - half), to = at_mm(step.along + half);
  // The triangle of both commissures and where the halves meet, in the plane of the gap's middle.
  const Vec3 base = medial - lateral, across = base.normalized();
  const Vec3 gap = 0.5 * (from + to) - lateral;
  const Vec3 outwards = (gap - across * across.dot(gap)).normalized();
  const double a = (from - lateral).norm(), b = (to - medial).norm(), c = base.norm();
  const double x = (a * a - b * b + c * c) / (2.0 * c);
  const Vec3 meeting = lateral + x * across + std::sqrt(std::max(0.0, a * a - x * x)) * outwards;
  const auto turn = [&](const Vec3& about, const Vec3& end) {
    return Eigen::Quaterniond::FromTwoVectors(end - about, meeting - about).toRotationMatrix();
  };
  const Eigen::Matrix3d lateral_turn = turn(lateral, from), medial_turn = turn(medial, to);
  const std::vector<double> places = annulus_around(valve);
  Points annulus_mm = valve.annulus_mm;
  for (Index i = 0; i < annulus_mm.rows(); ++i) {
    const LeafletPoint point = leaflet_point(places[i], 0.0);
    if (point.leaflet != Leaflet::Posterior) continue;
    const bool is_lateral = point.along <= step.along;
    const Vec3 site = at_mm(cut.tissue_at(point.along, 0.0, is_lateral ? -1 : 1));
    annulus_mm.row(i) = is_lateral ? lateral + lateral_turn * (site - lateral)
                                   : medial + medial_turn * (site - medial);
  }
  valve.annulus_mm = annulus_mm;
}

/// Branches that lead to what was cut out are taken from the chorda; one that had no others is
/// ruptured, and hangs at the seam.
void cut_branches(const std::vector<bool>& taken, Chorda& chorda) {
  const std::size_t count = chorda.segments.size();
  std::vector<bool> kept(count, false);
  for (std::size_t s = count; s-- > 0;) {  // parents come before their children
    if (chorda.segments[s].inserts) kept[s] = !taken[s];
    if (kept[s] && chorda.segments[s].parent >= 0) kept[chorda.segments[s].parent] = true;
  }
  if (std::none_of(kept.begin(), kept.end(), [](bool k) { return k; })) {
    chorda.ruptured = true;
    return;
  }
  std::vector<int> now(count, -1);
  std::vector<ChordaSegment> segments;
  for (std::size_t s = 0; s < count; ++s) {
    if (!kept[s]) continue;
    now[s] = static_cast<int>(segments.size());
    segments.push_back(chorda.segments[s]);
    if (segments.back().parent >= 0) segments.back().parent = now[segments.back().parent];
  }
  chorda.segments = std::move(segments);
}

void move_chordae(const LeafletCut& cut, const LeafletCoordinates& coordinates, Valve& valve) {
  for (Chorda& chorda : valve.chordae) {
    std::vector<bool> taken(chorda.segments.size(), false);
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      ChordaSegment& segment = chorda.segments[s];
      if (!segment.inserts) continue;
      LeafletPoint point = leaflet_point(valve, coordinates, segment.insertion);
      if (point.leaflet != cut.step().leaflet) continue;
      taken[s] = cut.takes(point.along, point.height);
      const double place = cut.place_of(point.along, point.height);
      if (std::abs(place - point.along) < kUnmoved) continue;
      point.along = place;
      segment.insertion = locate(valve, coordinates, point);
    }
    if (std::find(taken.begin(), taken.end(), true) != taken.end()) cut_branches(taken, chorda);
  }
}

}  // namespace

bool check_resection(const LeafletResection& step, const LeafletCoordinates& coordinates,
                     const Valve& valve, const std::string& path, ProblemList& problems) {
  const bool quadrangular = step.shape == ResectionShape::Quadrangular;
  bool good = check_range(problems, path + "/along", step.along, kResectionAlong);
  good &= check_range(problems, path + "/width_mm", step.width_mm, widths_mm(step), " mm");
  if (!quadrangular)
    good &= check_range(problems, path + "/height", step.height, kTriangularHeight);
  if (quadrangular && step.leaflet != Leaflet::Posterior) {
    problems.add(ErrorCode::ImpossibleStep, path + "/leaflet",
                 "is anterior, must be posterior: of the anterior leaflet only a triangle is cut");
    return false;
  }
  if (!good) return false;
  const LeafletCut cut(step, coordinates, valve);
  if (quadrangular && step.width_mm > kMostResected * cut.row_mm(0.0)) {
    problems.add(ErrorCode::ImpossibleStep, path + "/width_mm",
                 "is " + shown(step.width_mm) + ", must be at most " +
                     with_decimals(kMostResected * cut.row_mm(0.0), 1) +
                     " mm: a third of the posterior annulus");
    return false;
  }
  if (quadrangular && !step.sliding && step.width_mm > kMostPlicated_mm) {
    problems.add(ErrorCode::ImpossibleStep, path + "/width_mm",
                 "is " + shown(step.width_mm) + ", must be at most " + shown(kMostPlicated_mm) +
                     " mm without sliding");
    return false;
  }
  const double beside = std::min(step.along, 1.0 - step.along);
  for (const double height : {0.0, 0.5, 1.0}) {
    if (0.5 * cut.width_along(height) <= (1.0 - kLeastBeside) * beside) continue;
    problems.add(ErrorCode::ImpossibleStep, path + "/width_mm",
                 "is " + shown(step.width_mm) +
                     ", which leaves less than half of the leaflet between the cut and the nearer "
                     "commissure");
    return false;
  }
  return true;
}

void apply_resection(const LeafletResection& step, const LeafletCoordinates& coordinates,
                     Valve& valve) {
  const LeafletCut cut(step, coordinates, valve);
  const Points rest_mm = Resected(cut, coordinates, valve).rest_mm();
  if (step.shape == ResectionShape::Quadrangular && !step.sliding) plicate(cut, valve);
  move_chordae(cut, coordinates, valve);
  valve.fibre = turned_fibres(valve, rest_mm);
  valve.rest_mm = rest_mm;
}

std::vector<Insertion> seam_of(const LeafletResection& step, const LeafletCoordinates& coordinates,
                               const Valve& valve) {
  const double end = step.shape == ResectionShape::Quadrangular ? 0.0 : 1.0 - step.height;
  std::vector<Insertion> seam;
  for (int i = 0; i <= kSeamPieces; ++i)
    seam.push_back(locate(valve, coordinates,
                          {step.leaflet, step.along, end + (1.0 - end) * i / kSeamPieces}));
  return seam;
}

}  // namespace coapt
