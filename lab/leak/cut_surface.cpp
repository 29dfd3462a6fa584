#include "lab/leak/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/metrics/surface_tree.h"

namespace coapt {
namespace {

constexpr std::array<float, 5> kLevels = {0.3F, 0.4F, 0.5F, 0.6F, 0.7F};
constexpr int kCarriedOn = 3;  // cells into the tissue
constexpr int kSmoothed = 4;   // times: by about a cell

/// Corner n of a cube lies at bits 1, 2, 4 of n along x, y, z; six tetrahedra around the diagonal from corner 0 to 7.
constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                   {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

/// u, with what lies in tissue taken from its neighbours; NaN deeper in.
std::vector<float> carried_on(const VoxelBand& band, const AxisFields& shares,
                              const std::vector<float>& side) {
  std::vector<float> known(static_cast<std::size_t>(band.cells) + 1,
                           std::numeric_limits<float>::quiet_NaN());
  std::vector<std::array<int, 6>> beside(known.size());
  for_each_cell(band, [&](const Cell& cell, int index) {
    const auto at = static_cast<std::size_t>(index);
    for (std::size_t n = 0; n < 6; ++n) {
      Cell other = cell;
      other[n / 2] += n % 2 ? 1 : -1;
      const auto neighbour = static_cast<std::size_t>(band.find(other));
      beside[at][n] = static_cast<int>(neighbour);
      if (neighbour > 0 && shares[n / 2][n % 2 ? at : neighbour] > 0.0F) known[at] = side[at];
    }
    if (band.is_fixed[at]) known[at] = side[at];
  });
  const auto mean_around = [&](std::size_t at, float own_weight) {
    float sum = own_weight > 0.0F ? own_weight * known[at] : 0.0F, weight = own_weight;
    for (const int neighbour : beside[at]) {
      const float value = known[static_cast<std::size_t>(neighbour)];
      if (std::isnan(value)) continue;
      sum += value;
      weight += 1.0F;
    }
    return sum / weight;  // NaN where nothing is known around it
  };
  for (int step = 0; step < kCarriedOn + kSmoothed; ++step) {
    std::vector<float> next = known;
    for (std::size_t at = 1; at < known.size(); ++at)
      if (std::isnan(known[at]) == (step < kCarriedOn))
        next[at] = mean_around(at, step < kCarriedOn ? 0.0F : 2.0F);
    known = std::move(next);
  }
  return known;
}

struct Corner {
  Vec3 place_mm;
  float side;
};

/// Where the line between two corners passes a level.
Vec3 crossing_mm(const Corner& a, const Corner& b, float level) {
  const double share = (level - a.side) / (b.side - a.side);
  return a.place_mm + share * (b.place_mm - a.place_mm);
}

/// visit(a, b, c) for the triangles of a level in one tetrahedron: none, one, or two of a quadrangle.
template <class Visit>
void for_each_triangle(const std::array<Corner, 4>& corners, float level, const Visit& visit) {
  std::array<const Corner*, 4> order;
  std::size_t below = 0, above = 4;
  for (const Corner& corner : corners)
    if (corner.side < level)
      order[below++] = &corner;
    else
      order[--above] = &corner;
  const auto cross = [&](std::size_t a, std::size_t b) {
    return crossing_mm(*order[a], *order[b], level);
  };
  if (below == 1) visit(cross(0, 1), cross(0, 2), cross(0, 3));
  if (below == 3) visit(cross(3, 0), cross(3, 1), cross(3, 2));
  if (below != 2) return;
  visit(cross(0, 2), cross(0, 3), cross(1, 3));
  visit(cross(0, 2), cross(1, 3), cross(1, 2));
}

double area_mm2(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * (b - a).cross(c - a).norm();
}

/// Share of a triangle that lies in the blood: of its middle and of those of its corners' quarters.
double blood_share(const SurfaceTree& leaflets, double half_mm, const Vec3& a, const Vec3& b,
                   const Vec3& c) {
  const Vec3 middle = (a + b + c) / 3.0;
  int in_blood = 0;
  for (const Vec3& point :
       {middle, Vec3(0.5 * (a + middle)), Vec3(0.5 * (b + middle)), Vec3(0.5 * (c + middle))})
    in_blood += leaflets.nearest(point, half_mm).face < 0;
  return 0.25 * in_blood;
}

}  // namespace

double cut_surface_mm2(const VoxelBand& band, const AxisFields& shares,
                       const std::vector<float>& side, const LeakSurface& surface) {
  const SurfaceTree leaflets(surface.points_mm, surface.faces);
  const double half_mm = surface.half_thickness_mm;
  const std::vector<float> known = carried_on(band, shares, side);
  std::array<double, kLevels.size()> areas_mm2{};
  for_each_cell(band, [&](const Cell& cell, int) {
    std::array<Corner, 8> cube;
    float least = 1.0F, most = 0.0F;
    bool at_tissue = false;
    for (std::size_t n = 0; n < 8; ++n) {
      const Cell at = {cell[0] + static_cast<int>(n & 1U), cell[1] + static_cast<int>(n >> 1 & 1U),
                       cell[2] + static_cast<int>(n >> 2)};
      const auto index = static_cast<std::size_t>(band.find(at));
      if (std::isnan(known[index])) return;
      cube[n] = {band.lattice.centre_mm(at), known[index]};
      least = std::min(least, known[index]);
      most = std::max(most, known[index]);
      for (const auto& axis : shares) at_tissue = at_tissue || axis[index] < 1.0F;
    }
    for (std::size_t l = 0; l < kLevels.size(); ++l) {
      if (kLevels[l] <= least || kLevels[l] > most) continue;
      for (const auto& corners : kTetrahedra)
        for_each_triangle({cube[corners[0]], cube[corners[1]], cube[corners[2]], cube[corners[3]]},
                          kLevels[l], [&](const Vec3& a, const Vec3& b, const Vec3& c) {
                            const double share =
                                at_tissue ? blood_share(leaflets, half_mm, a, b, c) : 1.0;
                            areas_mm2[l] += share * area_mm2(a, b, c);
                          });
    }
  });
  return *std::min_element(areas_mm2.begin(), areas_mm2.end());
}

}  // namespace coapt
