#include "io/exchange/exported_valve.h"

#include <algorithm>

#include "core/closure/standing.h"

namespace coapt {
namespace {

Eigen::Index as_row(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// The ends of all chordae; `branch_point(chorda, segment)` where a segment does not insert.
template <class BranchPoint>
std::vector<Points> chorda_ends(const Valve& valve, const Points& vertices_mm,
                                const BranchPoint& branch_point) {
  std::vector<Points> all;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const std::vector<ChordaSegment>& segments = valve.chordae[c].segments;
    Points& ends = all.emplace_back(std::ssize(segments), 3);
    for (std::size_t s = 0; s < segments.size(); ++s)
      ends.row(as_row(s)) = segments[s].inserts
                                ? position(segments[s].insertion, valve.faces, vertices_mm)
                                : Vec3(branch_point(c, s));
  }
  return all;
}

}  // namespace

ValveShape closed_shape(const ClosedValve& exported) {
  const Valve& valve = exported.valve;
  Points heads(std::ssize(valve.heads), 3);
  for (std::size_t h = 0; h < valve.heads.size(); ++h) heads.row(as_row(h)) = valve.heads[h].tip_mm;
  return {exported.closure.closed_mm, std::move(heads), exported.closure.branch_points_mm,
          exported.closure.tension_n, doubt_about(exported.closure)};
}

ValveShape unstressed_shape(const Valve& valve) {
  Points heads(std::ssize(valve.heads), 3);
  for (std::size_t h = 0; h < valve.heads.size(); ++h)
    heads.row(as_row(h)) = valve.heads[h].rest_mm;
  const auto at_rest = [&](std::size_t c, std::size_t s) {
    return valve.chordae[c].segments[s].branch_point_mm;
  };
  return {valve.rest_mm, std::move(heads), chorda_ends(valve, valve.rest_mm, at_rest)};
}

std::vector<ValveShape> motion_shapes(const ClosedValve& exported) {
  const Valve& valve = exported.valve;
  std::vector<ValveShape> shapes;
  for (const Points& state_mm : exported.closure.motion_mm) {
    const Points vertices = state_mm.topRows(valve.rest_mm.rows());
    Eigen::Index next = vertices.rows();
    const auto kept = [&](std::size_t, std::size_t) { return Vec3(state_mm.row(next++)); };
    std::vector<Points> ends = chorda_ends(valve, vertices, kept);
    shapes.push_back({vertices, state_mm.bottomRows(std::ssize(valve.heads)), std::move(ends)});
  }
  return shapes;
}

Vec3 segment_start(const ValveShape& shape, const Chorda& chorda, std::size_t index_of_chorda,
                   std::size_t segment) {
  const int parent = chorda.segments[segment].parent;
  return parent < 0 ? shape.heads_mm.row(chorda.head)
                    : shape.chorda_ends_mm[index_of_chorda].row(parent);
}

int attached_vertex(const Valve& valve, const Insertion& insertion) {
  const auto heaviest = std::max_element(insertion.weights.begin(), insertion.weights.end());
  return valve.faces(insertion.face, heaviest - insertion.weights.begin());
}

ValveShape attached_shape(const Valve& valve, ValveShape shape) {
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    for (std::size_t s = 0; s < valve.chordae[c].segments.size(); ++s) {
      const ChordaSegment& segment = valve.chordae[c].segments[s];
      if (segment.inserts)
        shape.chorda_ends_mm[c].row(as_row(s)) =
            shape.vertices_mm.row(attached_vertex(valve, segment.insertion));
    }
  return shape;
}

double attachment_shift_mm(const Valve& valve, const ValveShape& shape) {
  const ValveShape attached = attached_shape(valve, shape);
  double most = 0.0;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c)
    most = std::max(
        most, (attached.chorda_ends_mm[c] - shape.chorda_ends_mm[c]).rowwise().norm().maxCoeff());
  return most;
}

}  // namespace coapt
