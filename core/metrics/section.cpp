#include "core/metrics/section.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace coapt {
namespace {

using MeshEdge = std::pair<int, int>;  // smaller vertex first

struct Piece {
  int face = 0;
  std::array<MeshEdge, 2> ends;
  bool used = false;
};

/// Which pieces end on an edge, sorted by edge.
using EdgeEnds = std::vector<std::pair<MeshEdge, std::size_t>>;

std::pair<EdgeEnds::const_iterator, EdgeEnds::const_iterator> pieces_at(const EdgeEnds& ends,
                                                                        const MeshEdge& edge) {
  const auto before = [](const auto& end, const MeshEdge& key) { return end.first < key; };
  const auto first = std::lower_bound(ends.begin(), ends.end(), edge, before);
  auto last = first;
  while (last != ends.end() && last->first == edge) ++last;
  return {first, last};
}

}  // namespace

std::vector<SectionLine> cut(const Faces& faces, const Points& points_mm,
                             const SectionPlane& plane) {
  const Eigen::VectorXd height = (points_mm.rowwise() - plane.point_mm.transpose()) * plane.normal;
  std::vector<Piece> pieces;
  EdgeEnds ends;
  for (int f = 0; f < static_cast<int>(faces.rows()); ++f) {
    Piece piece{f, {}, false};
    std::size_t count = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = faces(f, k), b = faces(f, (k + 1) % 3);
      if ((height(a) >= 0.0) != (height(b) >= 0.0)) piece.ends[count++] = std::minmax({a, b});
    }
    if (count < 2) continue;
    for (const MeshEdge& edge : piece.ends) ends.emplace_back(edge, pieces.size());
    pieces.push_back(piece);
  }
  std::sort(ends.begin(), ends.end());

  const auto crossing = [&](const MeshEdge& edge) -> Vec3 {
    const double t = height(edge.first) / (height(edge.first) - height(edge.second));
    return (1.0 - t) * points_mm.row(edge.first).transpose() +
           t * points_mm.row(edge.second).transpose();
  };
  const auto follow = [&](std::size_t start, MeshEdge from) {
    SectionLine line;
    line.points_mm.push_back(crossing(from));
    for (std::size_t here = start; here < pieces.size();) {
      Piece& piece = pieces[here];
      piece.used = true;
      from = piece.ends[piece.ends[0] == from ? 1 : 0];
      line.points_mm.push_back(crossing(from));
      line.faces.push_back(piece.face);
      here = pieces.size();
      for (auto [end, last] = pieces_at(ends, from); end != last; ++end)
        if (!pieces[end->second].used) here = end->second;
    }
    return line;
  };
  std::vector<SectionLine> lines;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const MeshEdge& edge : pieces[i].ends) {
      const auto [first, last] = pieces_at(ends, edge);
      if (!pieces[i].used && last - first == 1) lines.push_back(follow(i, edge));
    }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!pieces[i].used) lines.push_back(follow(i, pieces[i].ends[0]));
  return lines;
}

SectionPlane mid_valve_plane(const Valve& valve) {
  const Vec3 saddle_peak = annulus_position_mm(valve, valve.landmarks.saddle_peak);
  const Vec3 to_posterior = annulus_position_mm(valve, valve.landmarks.mid_posterior) - saddle_peak;
  return {saddle_peak,
          annulus_frame(valve, AnnulusAxis::Commissures).normal.cross(to_posterior).normalized()};
}

SectionPlane coaptation_plane(const Valve& valve, double along) {
  const Vec3 from = annulus_position_mm(valve, valve.landmarks.anterolateral_commissure);
  const Vec3 to = annulus_position_mm(valve, valve.landmarks.posteromedial_commissure);
  return {from + along * (to - from), (to - from).normalized()};
}

}  // namespace coapt
