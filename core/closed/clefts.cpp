#include "core/closed/clefts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/valve/leaflet_point.h"

namespace coapt {
namespace {

constexpr std::array<std::pair<Segment, Segment>, 2> kBetween = {
    {{Segment::P1, Segment::P2}, {Segment::P2, Segment::P3}}};

bool is_scallop(Segment segment) {
  return segment == Segment::P1 || segment == Segment::P2 || segment == Segment::P3;
}

/// Sum of the openings that two scallops, and no other of the posterior leaflet, border.
double leak_between(const ValveMeasure& measure, Segment first, Segment second) {
  double leak_mm2 = 0.0;
  for (const LeakOpening& opening : measure.leak.openings) {
    const std::vector<Segment>& of = opening.segments;
    const auto has = [&of](Segment segment) {
      return std::find(of.begin(), of.end(), segment) != of.end();
    };
    if (has(first) && has(second) && std::count_if(of.begin(), of.end(), is_scallop) == 2)
      leak_mm2 += opening.area_mm2;
  }
  return leak_mm2;
}

/// The height of the posterior leaflet, from the annulus straight to the free edge, along it.
class Heights {
 public:
  explicit Heights(const Valve& valve) : valve_(valve), coordinates_(leaflet_coordinates(valve)) {}

  double at(double along) const {
    return (rest_position_mm(valve_, coordinates_, {Leaflet::Posterior, along, 1.0}) -
            rest_position_mm(valve_, coordinates_, {Leaflet::Posterior, along, 0.0}))
        .norm();
  }

  double middle_of(Segment segment) const { return middle_along(valve_, coordinates_, segment); }

 private:
  const Valve& valve_;
  LeafletCoordinates coordinates_;
};

/// As deep as the free edge lies below the line between the middles of two scallops; its root is the middle of what lies half as deep.
Cleft cleft_between(const Heights& heights, Segment first, Segment second) {
  constexpr int kPlaces = 60;
  const double from = heights.middle_of(first), to = heights.middle_of(second);
  const double from_mm = heights.at(from), to_mm = heights.at(to);
  Cleft cleft{first, second};
  std::vector<double> depth_mm;
  for (int i = 0; i <= kPlaces; ++i) {
    const double part = static_cast<double>(i) / kPlaces;
    const double level_mm = from_mm + part * (to_mm - from_mm);
    depth_mm.push_back(level_mm - heights.at(from + part * (to - from)));
    if (depth_mm.back() <= cleft.depth_mm) continue;
    cleft.depth_mm = depth_mm.back();
    cleft.share = cleft.depth_mm / level_mm;
  }
  const auto deep = [&](double depth) { return depth >= 0.5 * cleft.depth_mm; };
  const auto begins = std::find_if(depth_mm.begin(), depth_mm.end(), deep);
  const auto ends = std::find_if(depth_mm.rbegin(), depth_mm.rend(), deep).base() - 1;
  const double middle =
      0.5 * static_cast<double>((begins - depth_mm.begin()) + (ends - depth_mm.begin()));
  cleft.along = from + middle / kPlaces * (to - from);
  return cleft;
}

}  // namespace

std::vector<Cleft> leaking_clefts(const Valve& valve, const ValveMeasure& measure,
                                  double least_mm2) {
  std::vector<Cleft> clefts;
  std::optional<Heights> heights;
  for (const auto& [first, second] : kBetween) {
    const double leak_mm2 = leak_between(measure, first, second);
    if (leak_mm2 <= least_mm2) continue;
    if (!heights) heights.emplace(valve);
    Cleft cleft = cleft_between(*heights, first, second);
    cleft.leak_mm2 = leak_mm2;
    if (cleft.share >= kDeepCleft) clefts.push_back(cleft);
  }
  return clefts;
}

double leak_through(const std::vector<Cleft>& clefts) {
  double leak_mm2 = 0.0;
  for (const Cleft& cleft : clefts) leak_mm2 += cleft.leak_mm2;
  return leak_mm2;
}

}  // namespace coapt
