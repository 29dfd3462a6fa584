#include "search/neochordae.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coapt {
namespace {

constexpr double kSpacing = 0.07;  // of `along`, between neochordae: 3 to 4 mm of the free edge
constexpr double kFallback_mm = 20.0;

/// Mean rest length from the head to the insertions.
double reach_mm(const Chorda& chorda) {
  std::vector<double> to_end;
  double sum = 0.0;
  int insertions = 0;
  for (const ChordaSegment& segment : chorda.segments) {
    const double before =
        segment.parent < 0 ? 0.0 : to_end[static_cast<std::size_t>(segment.parent)];
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

}  // namespace

std::vector<NeochordaGroup> neochordae_for_ruptures(const Valve& valve, int count) {
  const LeafletCoordinates coordinates = leaflet_coordinates(valve);
  // The leaflet with more ruptures; its lesion runs from the first to the last of them.
  std::vector<double> along_posterior, along_anterior;
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Marginal || !chorda.ruptured) continue;
    const LeafletPoint point = mean_point(valve, coordinates, chorda);
    (point.leaflet == Leaflet::Posterior ? along_posterior : along_anterior).push_back(point.along);
  }
  const bool posterior = along_posterior.size() >= along_anterior.size();
  const std::vector<double>& along = posterior ? along_posterior : along_anterior;
  if (along.empty()) return {};
  const Leaflet leaflet = posterior ? Leaflet::Posterior : Leaflet::Anterior;
  const auto [first, last] = std::minmax_element(along.begin(), along.end());
  const double middle = 0.5 * (*first + *last);

  const double length = usual_length_mm(valve, coordinates, leaflet);
  NeochordaGroup anterolateral{{}, length}, posteromedial{{}, length};
  for (int k = 0; k < count; ++k) {
    const double place = std::clamp(middle + kSpacing * (k - 0.5 * (count - 1)), 0.0, 1.0);
    const LeafletPoint point{leaflet, place, 1.0};
    const Vec3 edge = position(locate(valve, coordinates, point), valve.faces, valve.rest_mm);
    const Side side = place < 0.5 ? Side::Anterolateral : Side::Posteromedial;
    const std::string head = nearest_head(valve, side, edge);
    if (head.empty()) continue;
    (side == Side::Anterolateral ? anterolateral : posteromedial)
        .steps.push_back({head, point, length});
  }
  std::vector<NeochordaGroup> groups;
  for (const NeochordaGroup& group : {anterolateral, posteromedial})
    if (!group.steps.empty()) groups.push_back(group);
  return groups;
}

}  // namespace coapt
