// Rings, papillary sutures, neochordae, ties and seams over a picture of the closed valve, and what its signs mean.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/closed/closed_valve.h"
#include "io/picture/view_frame.h"

namespace coapt {

/// Where points of a valve lie on a canvas.
struct RepairSheet {
  const Canvas& canvas;
  std::function<Eigen::Vector2d(const Vec3&)> place;
  double pixels_per_mm = 12.0;
};

/// The ring along the annulus, and dashed the annulus before it. Nothing without a ring.
void draw_ring(const RepairSheet& sheet, const ClosedValve& closed);

/// The ring cut across at two points of the annulus. Nothing without a ring.
void draw_ring_cut(const RepairSheet& sheet, const ClosedValve& closed,
                   const std::array<Vec3, 2>& at_mm);

/// Sutures dashed, neochordae dotted, ties of edge-to-edge repairs, and the muscle's way to its new place; from
/// the atrium all of these lie behind the leaflets.
void draw_sutures(const RepairSheet& sheet, const ClosedValve& closed);

/// Seams of resections, stitched. @pre closed_mm is finite
void draw_seams(const RepairSheet& sheet, const ClosedValve& closed);

/// What the signs in pictures of these valves mean, those that are there; from the left, in as many lines
/// as it takes. `at`: upper left corner.
void draw_legend(const Canvas& canvas, const Eigen::Vector2d& at, double width,
                 const std::vector<const ClosedValve*>& valves);

}  // namespace coapt
