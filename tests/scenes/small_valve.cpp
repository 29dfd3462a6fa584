#include "tests/scenes/small_valve.h"

#include <cmath>
#include <numbers>

namespace coapt {
namespace {

constexpr int kColumns = 8;
constexpr int kRings = 3;

Points rest_shape() {
  Points points(kRings * kColumns, 3);
  for (int ring = 0; ring < kRings; ++ring) {
    for (int column = 0; column < kColumns; ++column) {
      const double angle = 2.0 * std::numbers::pi * column / kColumns;
      const double width = 1.0 - 0.25 * ring;
      points.row(ring * kColumns + column) << 18.0 * width * std::cos(angle),
          14.0 * width * std::sin(angle), 0.0 - 8.0 * ring;
    }
  }
  return points;
}

Faces skirt() {
  Faces faces(2 * (kRings - 1) * kColumns, 3);
  int face = 0;
  for (int column = 0; column < kColumns; ++column) {
    const int next = (column + 1) % kColumns;
    for (int ring = 0; ring + 1 < kRings; ++ring) {
      const int upper = ring * kColumns;
      const int lower = upper + kColumns;
      faces.row(face++) << upper + column, upper + next, lower + column;
      faces.row(face++) << upper + next, lower + next, lower + column;
    }
  }
  return faces;
}

Points circumferential(const Points& points, const Faces& faces) {
  Points fibre(faces.rows(), 3);
  for (int face = 0; face < faces.rows(); ++face) {
    // The horizontal edge: between the two vertices of one ring.
    const bool upper = face % 2 == 0;
    const int from = upper ? faces(face, 0) : faces(face, 2);
    fibre.row(face) = (points.row(faces(face, 1)) - points.row(from)).normalized();
  }
  return fibre;
}

// A segment from `start` to the third vertex of `face`.
ChordaSegment inserting(const Valve& valve, int parent, const Vec3& start, int face) {
  ChordaSegment segment;
  segment.parent = parent;
  segment.inserts = true;
  segment.insertion = {face, {0.0, 0.0, 1.0}};
  segment.zone_mm = 0.0;
  segment.rest_length_mm = (position(segment.insertion, valve.faces, valve.rest_mm) - start).norm();
  return segment;
}

Chorda branching(const Valve& valve) {
  const Vec3& tip = valve.heads[0].tip_mm;
  ChordaSegment trunk;
  trunk.branch_point_mm = Vec3(-12.0, -4.0, -21.0);
  trunk.rest_length_mm = (trunk.branch_point_mm - tip).norm();
  return {"AL1-P1-marginal-1",
          ChordaKind::Marginal,
          0,
          false,
          {trunk, inserting(valve, 0, trunk.branch_point_mm, 18),
           inserting(valve, 0, trunk.branch_point_mm, 22)}};
}

Chorda single(const Valve& valve) {
  return {"PM1-A2-strut-1",
          ChordaKind::Strut,
          1,
          false,
          {inserting(valve, -1, valve.heads[1].tip_mm, 10)}};
}

}  // namespace

Valve small_valve() {
  Valve valve;
  valve.name = "small";
  valve.provenance = {"made by hand for tests"};
  valve.rest_mm = rest_shape();
  valve.faces = skirt();
  const std::array<Segment, kColumns> columns = {Segment::A3, Segment::A2, Segment::A2,
                                                 Segment::A1, Segment::P1, Segment::P2,
                                                 Segment::P2, Segment::P3};
  for (const Segment segment : columns) {
    valve.segments.insert(valve.segments.end(), 2 * (kRings - 1), segment);
  }
  valve.fibre = circumferential(valve.rest_mm, valve.faces);
  valve.annulus = {0, 1, 2, 3, 4, 5, 6, 7};
  valve.annulus_mm = valve.rest_mm.topRows(kColumns);
  valve.landmarks = {.anterolateral_trigone = 3,
                     .posteromedial_trigone = 1,
                     .saddle_peak = 2,
                     .mid_posterior = 6,
                     .anterolateral_commissure = 4,
                     .posteromedial_commissure = 0};
  const Vec3 left(-12.0, -2.0, -26.0);
  const Vec3 right(12.0, -2.0, -26.0);
  valve.heads = {{.id = "AL1", .side = Side::Anterolateral, .rest_mm = left, .tip_mm = left},
                 {.id = "PM1", .side = Side::Posteromedial, .rest_mm = right, .tip_mm = right}};
  valve.chordae = {branching(valve), single(valve)};
  valve.tissue.bending_n_mm = 0.0;
  return valve;
}

Valve fitting_valve() {
  Valve valve = small_valve();
  valve.rest_mm *= 1.5;
  return valve;
}

}  // namespace coapt
