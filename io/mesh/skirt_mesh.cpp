#include "io/mesh/skirt_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/mesh/given_landmarks.h"

namespace coapt {
namespace {

constexpr double kTrigone =
    0.66;  // of the way from saddle peak to commissure, as in parametric valves
constexpr double kCommissureAlong = 0.07;  // share of a leaflet's arc that counts as commissure
constexpr double kPeakBias_mm =
    0.5;  // a flat annulus has its saddle peak in the middle of the front
constexpr double kDiagonalRatio = 1.3;

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

}  // namespace

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

}  // namespace coapt
