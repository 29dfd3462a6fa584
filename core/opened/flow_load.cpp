#include "core/opened/flow_load.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {
namespace {

constexpr int kLoops = 24;  // from the annulus to the free edge
// Loops at a height of vertices themselves would be cut where faces end.
constexpr double kInside = 1e-6;
constexpr double kLeastThroat_mm2 = 20.0;  // of leaflets that nearly touch: no endless pressure
// Of the jet's area over the throat's: 0.87 behind domes of 1.5 cm2, 0.73 behind flat leaflets (Gilon 1996, Circulation 94:452).
constexpr double kContraction = 0.87;
constexpr double kBlood_kg_m3 = 1060.0, kPaPerMmhg = 133.322;

struct Loop {
  Vec3 area_mm2 = Vec3::Zero();  // its vector
  double length_mm = 0.0;
};

double height_of(int loop) {
  return std::clamp(static_cast<double>(loop) / kLoops, kInside, 1.0 - kInside);
}

/// Where the leaflets have that height, all pieces running as the annulus does.
Loop loop_at(const Valve& valve, const std::vector<double>& heights, const Points& open_mm,
             const Vec3& origin_mm, double height) {
  Loop loop;
  for (const auto& face : valve.faces.rowwise()) {
    Vec3 down = Vec3::Zero(), up = Vec3::Zero();  // they stay if the face is not cut
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      const double at_a = heights[static_cast<std::size_t>(a)],
                   at_b = heights[static_cast<std::size_t>(b)];
      if ((at_a < height) == (at_b < height)) continue;
      const double share = (height - at_a) / (at_b - at_a);
      const Vec3 point = (1.0 - share) * open_mm.row(a) + share * open_mm.row(b);
      (at_a < height ? down : up) = point - origin_mm;
    }
    loop.area_mm2 += 0.5 * up.cross(down);
    loop.length_mm += (down - up).norm();
  }
  return loop;
}

}  // namespace

FlowLoad flow_load(const Valve& valve, const std::vector<double>& heights, const Points& open_mm) {
  const Vec3 origin_mm = valve.annulus_mm.colwise().mean();
  std::array<double, kLoops + 1> areas_mm2{};
  int throat = 0;
  double throat_length_mm = 0.0;
  for (int i = 0; i <= kLoops; ++i) {
    const Loop loop = loop_at(valve, heights, open_mm, origin_mm, height_of(i));
    areas_mm2.at(i) = std::max(kLeastThroat_mm2, loop.area_mm2.norm());
    if (i > 0 && areas_mm2.at(i) >= areas_mm2.at(throat)) continue;
    throat = i;
    throat_length_mm = loop.length_mm;
  }
  const double throat_mm2 = areas_mm2.at(throat);
  std::array<double, kLoops + 1> left{};  // of the pressure
  for (int i = 0; i <= throat; ++i)
    left.at(i) = 1.0 - std::pow(kContraction * throat_mm2 / areas_mm2.at(i), 2.0);
  FlowLoad load;
  load.jet_mm2 =
      kContraction *
      std::max(kLeastThroat_mm2, throat_mm2 - 0.5 * valve.tissue.thickness_mm * throat_length_mm);
  load.share.reserve(static_cast<std::size_t>(valve.faces.rows()));
  for (const auto& face : valve.faces.rowwise()) {
    double sum = 0.0;
    for (const int vertex : face) {
      const double at = kLoops * heights[static_cast<std::size_t>(vertex)];
      const int below = std::clamp(static_cast<int>(at), 0, kLoops - 1);
      sum += left.at(below) + (at - below) * (left.at(below + 1) - left.at(below));
    }
    load.share.push_back(sum / 3.0);
  }
  return load;
}

double bernoulli_mmhg(double flow_ml_s, double area_mm2) {
  const double speed_m_s = flow_ml_s / area_mm2;
  return 0.5 * kBlood_kg_m3 * speed_m_s * speed_m_s / kPaPerMmhg;
}

}  // namespace coapt
