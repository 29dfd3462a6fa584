// Leaflets and openings are drawn at twice the size and scaled down, because cairo's mesh gradients
// have hard edges; lines and words come over them.
#include "io/picture/atrial_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "io/picture/atrial_names.h"
#include "io/picture/leaflet_paint.h"
#include "io/picture/opening_paint.h"
#include "io/picture/repair_paint.h"
#include "io/picture/text.h"
#include "io/picture/view_frame.h"

namespace coapt {
namespace {

constexpr double kSupersampling = 2.0;          // of the sheet's own pixels
constexpr Colour kVentricle{0.93, 0.91, 0.91};  // the ventricle, through an open valve
constexpr double kSeenThrough = 0.5;            // of the leak's colour, through the tissue above it
constexpr double kOverChordae = 0.25;           // of the opening's
constexpr Colour kChordaBelow{0.66, 0.59, 0.52};

void trace(const Canvas& canvas, const std::vector<Vec2>& polygon_mm, const Mapping& map) {
  for (const Vec2& point : polygon_mm)
    cairo_line_to(canvas.context.get(), map(point).x(), map(point).y());
  cairo_close_path(canvas.context.get());
}

void draw_annulus(const Canvas& canvas, const std::vector<Vec2>& annulus, const Mapping& map) {
  cairo_t* cairo = canvas.context.get();
  trace(canvas, annulus, map);
  set_colour(canvas, palette::kAnnulus);
  cairo_set_line_width(cairo, 0.32 * map.pixels_per_mm);
  cairo_stroke(cairo);
}

/// Of the annulus that a ring drew in, on the plane of the annulus now.
Eigen::AlignedBox2d extent_before_mm(const ClosedValve& closed, const AnnulusFrame& plane) {
  Eigen::AlignedBox2d extent;
  const Points& loop_mm = closed.repair.annulus_before_mm;
  for (Eigen::Index i = 0; i < loop_mm.rows(); ++i)
    extent.extend(project(plane, loop_mm.row(i).transpose()));
  return extent;
}

/// What differs between the views of a closed and an open valve.
struct Painters {
  /// The leaflets, at twice the size.
  std::function<void(const Canvas&, const Mapping&)> below, above;
  bool inside_alone;  ///< of the annulus: open leaflets bulge behind the atrium's wall
  std::function<void(const Mapping&)> last;  ///< over everything
};

void draw_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
               const AnnulusFrame& plane, const Painters& painters) {
  const Valve& valve = closed.valve;
  const std::vector<Vec2> annulus_mm = annulus_polygon(valve, plane);
  Eigen::AlignedBox2d extent;
  for (const Vec2& point : annulus_mm) extent.extend(point);
  const Box& box = frame.box;
  // Before and after side by side have the annulus before at the same place.
  const Vec2 centre_mm = closed.repair.annulus_before_mm.rows() > 0
                             ? Vec2(extent_before_mm(closed, plane).center())
                             : Vec2(extent.center());
  const Mapping map{centre_mm, Vec2(box.x + 0.5 * box.width, box.y + 0.5 * box.height),
                    frame.pixels_per_mm};

  cairo_t* cairo = canvas.context.get();
  cairo_matrix_t sheet;
  cairo_get_matrix(cairo, &sheet);
  const double fine = kSupersampling * sheet.xx;
  const Canvas large =
      make_canvas(static_cast<int>(fine * box.width), static_cast<int>(fine * box.height));
  const Mapping large_map{centre_mm, 0.5 * fine * Vec2(box.width, box.height),
                          fine * frame.pixels_per_mm};
  const std::vector<PaintedFace> faces =
      painted_faces(valve, closed.closure.closed_mm, plane, large_map);
  cairo_save(large.context.get());
  trace(large, annulus_mm, large_map);
  cairo_clip(large.context.get());
  painters.below(large, large_map);
  paint_rims(large, faces, valve.tissue.thickness_mm * large_map.pixels_per_mm);
  if (!painters.inside_alone) cairo_reset_clip(large.context.get());
  paint_leaflets(large, faces);
  painters.above(large, large_map);
  cairo_restore(large.context.get());

  cairo_save(cairo);
  cairo_translate(cairo, box.x, box.y);
  cairo_scale(cairo, 1.0 / fine, 1.0 / fine);
  cairo_set_source_surface(cairo, large.surface.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
  cairo_paint(cairo);
  cairo_restore(cairo);

  const Vec2 middle_px = map(extent.center());
  draw_annulus(canvas, annulus_mm, map);
  const RepairSheet repair{canvas,
                           [&](const Vec3& point_mm) { return map(project(plane, point_mm)); },
                           frame.pixels_per_mm};
  cairo_save(cairo);
  cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
  cairo_clip(cairo);
  draw_ring(repair, closed);
  cairo_restore(cairo);
  draw_seams(repair, closed);
  draw_segment_names(canvas, valve, plane, map, middle_px);
  draw_landmarks(canvas, valve, plane, map, middle_px);
  draw_sutures(repair, closed);
  painters.last(map);
  draw_scale_bar(canvas, frame);
}

/// Chordae under the open leaflets, those that are not ruptured.
void paint_chordae(const Canvas& canvas, const ClosedValve& open, const AnnulusFrame& plane,
                   const Mapping& map) {
  const Valve& valve = open.valve;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    if (chorda.ruptured) continue;
    const Points& ends_mm = open.closure.branch_points_mm[c];
    for (std::size_t s = 0; s < chorda.segments.size(); ++s) {
      const int parent = chorda.segments[s].parent;
      const Vec3 from_mm = parent < 0 ? valve.heads[static_cast<std::size_t>(chorda.head)].tip_mm
                                      : Vec3(ends_mm.row(parent).transpose());
      const Vec3 to_mm = ends_mm.row(static_cast<Eigen::Index>(s)).transpose();
      for (const Vec3& end_mm : {from_mm, to_mm}) {
        const Vec2 at = map(project(plane, end_mm));
        cairo_line_to(canvas.context.get(), at.x(), at.y());
      }
      cairo_new_sub_path(canvas.context.get());
    }
  }
  cairo_set_line_width(canvas.context.get(), 0.35 * map.pixels_per_mm);
  set_colour(canvas, kChordaBelow);
  cairo_stroke(canvas.context.get());
}

}  // namespace

double atrial_scale(const Box& box, const ClosedValve& closed) {
  constexpr double kLabels = 105.0;  // pixels beside the annulus, on either side
  const AnnulusMeasure& annulus = closed.measure.annulus;
  Vec2 size_mm(annulus.al_pm_mm, annulus.ap_mm);
  if (closed.repair.annulus_before_mm.rows() > 0)
    size_mm = size_mm.cwiseMax(
        extent_before_mm(closed, annulus_frame(closed.valve, AnnulusAxis::Commissures)).sizes());
  return std::min((box.width - 2.0 * kLabels) / size_mm.x(),
                  (box.height - 0.8 * kLabels) / size_mm.y());
}

void draw_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed) {
  if (!closed.closure.closed_mm.allFinite()) return draw_unknown(canvas, frame);
  const AnnulusFrame plane = annulus_frame(closed.valve, AnnulusAxis::Commissures);
  const Leak& leak = closed.measure.leak;
  draw_view(canvas, frame, closed, plane,
            {[&](const Canvas& large, const Mapping& map) {
               paint_openings(large, leak, plane, map, 1.0);
             },
             [&](const Canvas& large, const Mapping& map) {
               paint_openings(large, leak, plane, map, kSeenThrough);
               draw_rims_of_openings(large, leak, plane, map);
             },
             false, [&](const Mapping& map) { label_openings(canvas, closed, plane, map); }});
}

void draw_open_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open) {
  if (!open.closure.closed_mm.allFinite()) return draw_unknown(canvas, frame);
  const AnnulusFrame plane = annulus_frame(open.valve, AnnulusAxis::Commissures);
  const Leak& leak = open.measure.leak;
  draw_view(canvas, frame, open, plane,
            {[&](const Canvas& large, const Mapping& map) {
               set_colour(large, kVentricle);
               cairo_paint(large.context.get());
               paint_chordae(large, open, plane, map);
               paint_openings(large, leak, plane, map, kOverChordae);
             },
             [&](const Canvas& large, const Mapping& map) {
               draw_rims_of_openings(large, leak, plane, map);
             },
             true,
             [&](const Mapping& map) {
               for (const LeakOpening& opening : leak.openings) {
                 // Specks beside the only opening count in the area that words give.
                 const double area_mm2 =
                     leak.openings.size() == 1 ? leak.area_mm2 : opening.area_mm2;
                 draw_text(canvas, map(project(plane, opening.centroid_mm)),
                           fixed(0.01 * area_mm2, 1) + " cm²",
                           {20.0, palette::kOpening, Align::Centre, true, 4.0});
               }
             }});
}

}  // namespace coapt
