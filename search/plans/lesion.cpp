#include "search/plans/lesion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "core/valve/leaflet_of.h"

namespace coapt {
namespace {

constexpr double kFallback_mm = 20.0;
/// Scallops side by side.
constexpr std::array<std::array<Segment, 3>, 2> kRows = {
    {{Segment::A1, Segment::A2, Segment::A3}, {Segment::P1, Segment::P2, Segment::P3}}};

/// Mean rest length from the head to the insertions.
double reach_mm(const Chorda& chorda) {
  std::vector<double> to_end;
  double sum = 0.0;
  int insertions = 0;
  for (const ChordaSegment& segment : chorda.segments) {
    const double before = segment.parent < 0 ? 0.0 : to_end[segment.parent];
    to_end.push_back(before + segment.rest_length_mm);
    if (!segment.inserts) continue;
    sum += to_end.back();
    ++insertions;
  }
  return sum / insertions;
}

LeafletPoint mean_point(const Valve& valve, const LeafletCoordinates& coordinates,
                        const Chorda& chorda) {
  LeafletPoint mean{Leaflet::Posterior, 0.0, 0.0};
  int insertions = 0;
  for (const ChordaSegment& segment : chorda.segments) {
    if (!segment.inserts) continue;
    const LeafletPoint point = leaflet_point(valve, coordinates, segment.insertion);
    mean.leaflet = point.leaflet;
    mean.along += point.along;
    mean.height += point.height;
    ++insertions;
  }
  mean.along /= insertions;
  mean.height /= insertions;
  return mean;
}

std::string nearest_head(const Valve& valve, Side side, const Vec3& point) {
  std::string id;
  double nearest = std::numeric_limits<double>::infinity();
  for (const PapillaryHead& head : valve.heads) {
    const double distance = (head.rest_mm - point).norm();
    if (head.side != side || distance >= nearest) continue;
    nearest = distance;
    id = head.id;
  }
  return id;
}

double usual_length_mm(const Valve& valve, const LeafletCoordinates& coordinates, Leaflet leaflet) {
  double on_leaflet = 0.0, anywhere = 0.0;
  int leaflet_count = 0, count = 0;
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Marginal || chorda.ruptured) continue;
    const double reach = reach_mm(chorda);
    anywhere += reach;
    ++count;
    if (mean_point(valve, coordinates, chorda).leaflet != leaflet) continue;
    on_leaflet += reach;
    ++leaflet_count;
  }
  if (leaflet_count > 0) return on_leaflet / leaflet_count;
  return count > 0 ? anywhere / count : kFallback_mm;
}

/// Indices of intact marginal chordae of one leaflet, by their distance from `along`.
std::vector<int> by_distance(const Valve& valve, const LeafletCoordinates& coordinates,
                             Leaflet leaflet, double along) {
  std::vector<std::pair<double, int>> found;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.kind != ChordaKind::Marginal || chorda.ruptured) continue;
    const LeafletPoint point = mean_point(valve, coordinates, chorda);
    if (point.leaflet == leaflet)
      found.emplace_back(std::abs(point.along - along), static_cast<int>(c));
  }
  std::sort(found.begin(), found.end());
  std::vector<int> indices;
  for (const auto& [distance, index] : found) indices.push_back(index);
  return indices;
}

/// Takes the segments of `left` that hang together with this one, from the anterolateral side on; none if it was taken.
std::vector<Segment> take_run(std::set<Segment>& left, Segment segment) {
  const auto of = std::find_if(kRows.begin(), kRows.end(), [&](const auto& row) {
    return std::find(row.begin(), row.end(), segment) != row.end();
  });
  std::vector<Segment> run;
  bool found = false;
  for (const Segment next : *of) {
    if (left.contains(next)) {
      run.push_back(next);
      found = found || next == segment;
    } else if (found) {
      break;
    } else {
      run.clear();
    }
  }
  if (!found) return {};
  for (const Segment taken : run) left.erase(taken);
  return run;
}

/// The commissure beside a run of segments that is one scallop there.
std::optional<Side> commissure_of(const std::vector<Segment>& run) {
  if (run == std::vector{Segment::A1} || run == std::vector{Segment::P1})
    return Side::Anterolateral;
  if (run == std::vector{Segment::A3} || run == std::vector{Segment::P3})
    return Side::Posteromedial;
  return std::nullopt;
}

}  // namespace

std::optional<Lesion> find_lesion(const Valve& valve, const LeafletCoordinates& coordinates) {
  std::vector<double> along_posterior, along_anterior;
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Marginal || !chorda.ruptured) continue;
    const LeafletPoint point = mean_point(valve, coordinates, chorda);
    (point.leaflet == Leaflet::Posterior ? along_posterior : along_anterior).push_back(point.along);
  }
  const bool posterior = along_posterior.size() >= along_anterior.size();
  const std::vector<double>& along = posterior ? along_posterior : along_anterior;
  if (along.empty()) return std::nullopt;
  const auto [first, last] = std::minmax_element(along.begin(), along.end());
  const Leaflet leaflet = posterior ? Leaflet::Posterior : Leaflet::Anterior;
  return Lesion{leaflet, 0.5 * (*first + *last), 0.5 * (*last - *first),
                usual_length_mm(valve, coordinates, leaflet)};
}

std::vector<Lesion> find_lesions(const Valve& valve, const LeafletCoordinates& coordinates,
                                 const std::optional<Diagnosis>& diagnosis) {
  std::vector<Lesion> lesions;
  if (!diagnosis) {
    if (const auto lesion = find_lesion(valve, coordinates)) lesions.push_back(*lesion);
    return lesions;
  }
  std::vector<SegmentDiagnosis> segments = prolapsing(*diagnosis);
  std::stable_sort(segments.begin(), segments.end(),
                   [](const auto& a, const auto& b) { return a.override_mm > b.override_mm; });
  std::set<Segment> left;
  for (const SegmentDiagnosis& segment : segments) left.insert(segment.segment);
  for (const SegmentDiagnosis& segment : segments) {
    const std::vector<Segment> run = take_run(left, segment.segment);
    if (run.empty()) continue;
    const Leaflet leaflet = *leaflet_of(segment.segment);  // prolapsing() knows scallops alone
    const double first = middle_along(valve, coordinates, run.front());
    const double last = middle_along(valve, coordinates, run.back());
    lesions.push_back({leaflet, 0.5 * (first + last), 0.5 * (last - first),
                       usual_length_mm(valve, coordinates, leaflet), commissure_of(run)});
  }
  for (Lesion& lesion : lesions)
    if (std::count_if(lesions.begin(), lesions.end(), [&](const Lesion& other) {
          return other.commissure == lesion.commissure;
        }) < 2)
      lesion.commissure.reset();
  return lesions;
}

const Lesion* posterior_lesion(const std::vector<Lesion>& lesions) {
  const auto found = std::find_if(lesions.begin(), lesions.end(), [](const Lesion& lesion) {
    return lesion.leaflet == Leaflet::Posterior;
  });
  return found == lesions.end() ? nullptr : &*found;
}

std::vector<Side> commissures_of(const std::vector<Lesion>& lesions) {
  std::vector<Side> sides;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial})
    if (std::any_of(lesions.begin(), lesions.end(),
                    [side](const Lesion& lesion) { return lesion.commissure == side; }))
      sides.push_back(side);
  return sides;
}

Neochorda neochorda_at(const Valve& valve, const LeafletCoordinates& coordinates,
                       const Lesion& lesion, double along) {
  const LeafletPoint point{lesion.leaflet, std::clamp(along, 0.0, 1.0), 1.0};
  const Vec3 edge = position(locate(valve, coordinates, point), valve.faces, valve.rest_mm);
  const Side side = point.along < 0.5 ? Side::Anterolateral : Side::Posteromedial;
  return {nearest_head(valve, side, edge), point, lesion.length_mm};
}

std::vector<int> chordae_beside(const Valve& valve, const LeafletCoordinates& coordinates,
                                const Lesion& lesion, int most) {
  std::vector<int> found = by_distance(valve, coordinates, lesion.leaflet, lesion.middle);
  if (std::ssize(found) > most) found.resize(most);
  return found;
}

int chorda_opposite(const Valve& valve, const LeafletCoordinates& coordinates,
                    const Lesion& lesion) {
  const Leaflet other =
      lesion.leaflet == Leaflet::Posterior ? Leaflet::Anterior : Leaflet::Posterior;
  const std::vector<int> found = by_distance(valve, coordinates, other, lesion.middle);
  return found.empty() ? -1 : found.front();
}

std::vector<int> anterior_struts(const Valve& valve, const LeafletCoordinates& coordinates) {
  std::vector<int> found;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.kind == ChordaKind::Strut && !chorda.ruptured &&
        mean_point(valve, coordinates, chorda).leaflet == Leaflet::Anterior)
      found.push_back(static_cast<int>(c));
  }
  return found;
}

}  // namespace coapt
