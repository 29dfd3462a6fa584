#include "core/metrics/opening_surface.h"

#include <algorithm>
#include <array>
#include <map>

namespace coapt {
namespace {

constexpr float kLevel = 0.5F;
constexpr int kSmoothings = 4;

/// Where u passes the level on its way from a voxel to the next one along an axis.
struct Crossing {
  int place = 0, next = 0;  // in the band
  int axis = 0;
};

std::vector<Crossing> crossings_of(const CutBand& band, const std::vector<int>& opening) {
  std::vector<Crossing> crossings;
  for (const int place : opening)
    for (int axis = 0; axis < 3; ++axis) {
      const BandVoxel& voxel = band.voxels[static_cast<std::size_t>(place)];
      if (voxel.free[static_cast<std::size_t>(axis)] == 0) continue;
      const int next = band.places[static_cast<std::size_t>(voxel.voxel + band.grid.stride(axis))];
      if (next < 0) continue;
      if ((band.surface.u[static_cast<std::size_t>(place)] < kLevel) !=
          (band.surface.u[static_cast<std::size_t>(next)] < kLevel))
        crossings.push_back({place, next, axis});
    }
  return crossings;
}

/// Corners that voxels share are numbered as the voxel behind which they lie along all axes.
class Net {
 public:
  Net(const CutBand& band, const std::vector<Crossing>& crossings) : band_(band) {
    for (const Crossing& crossing : crossings) add(crossing);
  }

  OpeningSurface result() {
    OpeningSurface surface;
    surface.points_mm.resize(std::ssize(corners_), 3);
    for (std::size_t i = 0; i < corners_.size(); ++i)
      surface.points_mm.row(static_cast<Index>(i)) = place_of(corners_[i]).transpose();
    surface.faces.resize(std::ssize(faces_), 3);
    for (std::size_t i = 0; i < faces_.size(); ++i)
      surface.faces.row(static_cast<Index>(i)) << faces_[i][0], faces_[i][1], faces_[i][2];
    const std::vector<std::vector<int>> rims = smoothed_rims(surface.points_mm);
    const auto length = [&](const std::vector<int>& rim) {
      double sum = 0.0;
      for (std::size_t i = 0; i < rim.size(); ++i)
        sum += (surface.points_mm.row(rim[i]) - surface.points_mm.row(rim[(i + 1) % rim.size()]))
                   .norm();
      return sum;
    };
    double longest = 0.0;
    for (const std::vector<int>& rim : rims)
      if (length(rim) > longest) {
        longest = length(rim);
        surface.outline = rim;
      }
    return surface;
  }

 private:
  struct Corner {
    int voxel = 0;
    Vec3 crossings_mm = Vec3::Zero(), normal = Vec3::Zero();  // sums
    int count = 0;
  };

  void add(const Crossing& crossing) {
    const BandVoxel& voxel = band_.voxels[static_cast<std::size_t>(crossing.place)];
    const float from = band_.surface.u[static_cast<std::size_t>(crossing.place)],
                to = band_.surface.u[static_cast<std::size_t>(crossing.next)];
    Vec3 at = band_.grid.centre_mm(band_.grid.place(voxel.voxel));
    at[crossing.axis] += band_.grid.side_mm * static_cast<double>((kLevel - from) / (to - from));
    const int first = band_.grid.stride((crossing.axis + 1) % 3),
              second = band_.grid.stride((crossing.axis + 2) % 3);
    // Around the square, counter-clockwise as seen against the axis.
    const std::array<int, 4> around{corner(voxel.voxel), corner(voxel.voxel - first),
                                    corner(voxel.voxel - first - second),
                                    corner(voxel.voxel - second)};
    for (const int c : around) {
      Corner& corner = corners_[static_cast<std::size_t>(c)];
      corner.crossings_mm += at;
      corner.normal += band_.surface.parts_mm2[static_cast<std::size_t>(crossing.place)];
      ++corner.count;
    }
    std::array<int, 4> ring = around;
    if (to < from) std::reverse(ring.begin(), ring.end());
    faces_.push_back({ring[0], ring[1], ring[2]});
    faces_.push_back({ring[0], ring[2], ring[3]});
  }

  int corner(int voxel) {
    const auto [at, is_new] = numbers_.try_emplace(voxel, static_cast<int>(corners_.size()));
    if (is_new) corners_.push_back({voxel, Vec3::Zero(), Vec3::Zero(), 0});
    return at->second;
  }

  Vec3 place_of(const Corner& corner) const {
    const Vec3 own = band_.grid.centre_mm(band_.grid.place(corner.voxel)) +
                     Vec3::Constant(0.5 * band_.grid.side_mm);
    const Vec3 normal = corner.normal.normalized();
    const double way = normal.dot(corner.crossings_mm / corner.count - own);
    return own + std::clamp(way, -band_.grid.side_mm, band_.grid.side_mm) * normal;
  }

  /// Loops of edges that faces have more often one way than the other; none passes a vertex twice. Their points are moved to the mean
  /// of their neighbours and themselves.
  std::vector<std::vector<int>> smoothed_rims(Points& points_mm) const {
    std::map<std::array<int, 2>, int> edges;
    for (const auto& face : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        ++edges[{face[k], face[(k + 1) % 3]}];
        --edges[{face[(k + 1) % 3], face[k]}];
      }
    std::multimap<int, int> next;
    for (const auto& [edge, count] : edges)
      for (int i = 0; i < count; ++i) next.emplace(edge[0], edge[1]);
    std::vector<std::vector<int>> rims;
    std::vector<int> way;
    while (!next.empty() || !way.empty()) {
      if (way.empty()) way.push_back(next.begin()->first);
      const auto step = next.find(way.back());
      if (step == next.end()) {
        way.clear();
        continue;
      }
      const auto met = std::find(way.begin(), way.end(), step->second);
      if (met == way.end()) {
        way.push_back(step->second);
      } else {
        rims.emplace_back(met, way.end());
        way.erase(met + 1, way.end());
      }
      next.erase(step);
    }
    for (const std::vector<int>& rim : rims)
      for (int step = 0; step < kSmoothings && rim.size() > 2; ++step) {
        const Points before = points_mm(rim, Eigen::all);
        const Index n = before.rows();
        for (Index i = 0; i < n; ++i)
          points_mm.row(rim[static_cast<std::size_t>(i)]) =
              0.5 * before.row(i) + 0.25 * (before.row((i + 1) % n) + before.row((i + n - 1) % n));
      }
    return rims;
  }

  const CutBand& band_;
  std::map<int, int> numbers_;
  std::vector<Corner> corners_;
  std::vector<std::array<int, 3>> faces_;
};

}  // namespace

OpeningSurface opening_surface(const CutBand& band, const std::vector<int>& opening) {
  return Net(band, crossings_of(band, opening)).result();
}

}  // namespace coapt
