// Leaflets and orifices are drawn at twice the size and scaled down, because cairo's mesh gradients
// have hard edges; lines and words come over them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/metrics/orifice.h"
#include "io/picture/leaflet_paint.h"
#include "io/picture/opening_paint.h"
#include "io/picture/repair_paint.h"
#include "io/picture/text.h"
#include "io/picture/views.h"

namespace coapt {
namespace {

constexpr double kSupersampling = 2.0;  // of the sheet's own pixels

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

struct Label {
  Vec2 at;
  double left, right;
};

/// Lines further out, up or down, that keep it off the labels placed before.
void keep_apart(Label& label, bool upwards, const std::vector<Label>& placed) {
  constexpr double kLine = 15.0;
  const auto covers = [&](const Label& other) {
    return label.left < other.right && other.left < label.right &&
           std::abs(label.at.y() - other.at.y()) < kLine;
  };
  for (int lines = 0; lines < 3 && std::any_of(placed.begin(), placed.end(), covers); ++lines)
    label.at.y() += upwards ? -kLine : kLine;
}

void draw_landmarks(const Canvas& canvas, const Valve& valve, const AnnularPlane& plane,
                    const Mapping& map, const Vec2& centre_px) {
  const Landmarks& marks = valve.landmarks;
  const std::pair<int, const char*> labelled[] = {
      {marks.saddle_peak, "saddle peak"},           {marks.mid_posterior, "mid-posterior"},
      {marks.anterolateral_commissure, "AL comm."}, {marks.posteromedial_commissure, "PM comm."},
      {marks.anterolateral_trigone, "AL trigone"},  {marks.posteromedial_trigone, "PM trigone"}};
  std::vector<Label> placed;
  for (const auto& [vertex, words] : labelled) {
    const Vec2 at = map(project(plane, annulus_position_mm(valve, vertex)));
    const Vec2 outwards = (at - centre_px).normalized();
    fill_circle(canvas, at, 5.5, palette::kAnnulus);
    fill_circle(canvas, at, 3.5, palette::kPaper);
    const Align align = outwards.x() > 0.35    ? Align::Left
                        : outwards.x() < -0.35 ? Align::Right
                                               : Align::Centre;
    const TextStyle style{13.0, palette::kMuted, align, false, 3.0};
    const double width = text_width(canvas, words, style);
    Label label{at + 13.0 * outwards + Vec2(0.0, 5.0 + 4.0 * outwards.y()), 0.0, 0.0};
    label.left = label.at.x() - (align == Align::Right    ? width
                                 : align == Align::Centre ? 0.5 * width
                                                          : 0.0);
    label.right = label.left + width;
    keep_apart(label, outwards.y() < 0.0, placed);
    draw_text(canvas, label.at, words, style);
    placed.push_back(label);
  }
}

/// A1 to P3 just inside the annulus, where each segment hangs on it.
void draw_segment_names(const Canvas& canvas, const Valve& valve, const AnnularPlane& plane,
                        const Mapping& map, const Vec2& centre_px) {
  constexpr double kLeastInwards = 20.0;  // px: clear of a ring
  std::vector<char> on_annulus(static_cast<std::size_t>(valve.rest_mm.rows()), 0);
  for (const int vertex : valve.annulus) on_annulus[static_cast<std::size_t>(vertex)] = 1;
  for (const Segment segment :
       {Segment::A1, Segment::A2, Segment::A3, Segment::P1, Segment::P2, Segment::P3}) {
    Vec2 sum_mm = Vec2::Zero();
    int count = 0;
    for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int vertex = valve.faces(f, k);
        if (valve.segments[static_cast<std::size_t>(f)] != segment ||
            !on_annulus[static_cast<std::size_t>(vertex)])
          continue;
        sum_mm += project(plane, annulus_position_mm(valve, vertex));
        ++count;
      }
    if (count == 0) continue;
    const Vec2 at = map(sum_mm / count);
    const Vec2 inwards = (centre_px - at).normalized();
    const double way = std::max(kLeastInwards, 2.6 * map.pixels_per_mm);
    draw_text(canvas, at + way * inwards + Vec2(0.0, 5.0), to_string(segment),
              {14.0, {0.35, 0.16, 0.12}, Align::Centre, true, 1.8});
  }
}

/// Of the annulus that a ring drew in, on the plane of the annulus now.
Eigen::AlignedBox2d extent_before_mm(const ClosedValve& closed, const AnnularPlane& plane) {
  Eigen::AlignedBox2d extent;
  const Points& loop_mm = closed.repair.annulus_before_mm;
  for (Eigen::Index i = 0; i < loop_mm.rows(); ++i)
    extent.extend(project(plane, loop_mm.row(i).transpose()));
  return extent;
}

}  // namespace

void draw_scale_bar(const Canvas& canvas, const ViewFrame& frame) {
  cairo_t* cairo = canvas.context.get();
  const double length = 10.0 * frame.pixels_per_mm;
  const Vec2 at(frame.box.x + 16.0, frame.box.y + frame.box.height - 18.0);
  set_colour(canvas, palette::kMuted);
  cairo_set_line_width(cairo, 2.0);
  cairo_move_to(cairo, at.x(), at.y());
  cairo_line_to(cairo, at.x() + length, at.y());
  cairo_stroke(cairo);
  draw_text(canvas, at + Vec2(0.5 * length, -8.0), "10 mm", {13.0, palette::kMuted, Align::Centre});
}

double atrial_scale(const Box& box, const ClosedValve& closed) {
  constexpr double kLabels = 105.0;  // pixels beside the annulus, on either side
  const AnnulusMeasure& annulus = closed.measure.annulus;
  Vec2 size_mm(annulus.al_pm_mm, annulus.ap_mm);
  if (closed.repair.annulus_before_mm.rows() > 0)
    size_mm = size_mm.cwiseMax(extent_before_mm(closed, annular_plane(closed.valve)).sizes());
  return std::min((box.width - 2.0 * kLabels) / size_mm.x(),
                  (box.height - 0.8 * kLabels) / size_mm.y());
}

void draw_unknown(const Canvas& canvas, const ViewFrame& frame) {
  draw_text(canvas, {frame.box.x + 0.5 * frame.box.width, frame.box.y + 0.5 * frame.box.height},
            "The closure diverged: there is nothing to draw.",
            {16.0, palette::kWarning, Align::Centre}, frame.box.width);
}

void draw_atrial_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed) {
  if (!closed.closure.closed_mm.allFinite()) return draw_unknown(canvas, frame);
  const Valve& valve = closed.valve;
  const OrificeView view =
      view_orifices(valve, closed.closure.closed_mm, 0.5 * valve.tissue.thickness_mm);
  const std::vector<Vec2> annulus_mm = annulus_polygon(valve, view.plane);
  const Box& box = frame.box;
  // Before and after side by side have the annulus before at the same place.
  const Vec2 centre_mm = closed.repair.annulus_before_mm.rows() > 0
                             ? Vec2(extent_before_mm(closed, view.plane).center())
                             : view.centre_mm;
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
      painted_faces(valve, closed.closure.closed_mm, view.plane, large_map);
  cairo_save(large.context.get());
  trace(large, annulus_mm, large_map);
  cairo_clip(large.context.get());
  paint_rims(large, faces, valve.tissue.thickness_mm * large_map.pixels_per_mm);
  cairo_restore(large.context.get());
  paint_leaflets(large, faces);
  paint_orifices(large, view, large_map);
  const std::vector<GapStrip> gaps = hidden_gaps(closed, view);
  paint_hidden_gaps(large, gaps, large_map);

  cairo_save(cairo);
  cairo_translate(cairo, box.x, box.y);
  cairo_scale(cairo, 1.0 / fine, 1.0 / fine);
  cairo_set_source_surface(cairo, large.surface.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
  cairo_paint(cairo);
  cairo_restore(cairo);

  const Vec2 middle_px = map(view.centre_mm);
  draw_annulus(canvas, annulus_mm, map);
  const RepairSheet repair{canvas,
                           [&](const Vec3& point_mm) { return map(project(view.plane, point_mm)); },
                           frame.pixels_per_mm};
  cairo_save(cairo);
  cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
  cairo_clip(cairo);
  draw_ring(repair, closed);
  cairo_restore(cairo);
  draw_seams(repair, closed);
  draw_segment_names(canvas, valve, view.plane, map, middle_px);
  draw_landmarks(canvas, valve, view.plane, map, middle_px);
  draw_sutures(repair, closed);
  label_openings(canvas, closed, view, gaps, map);
  draw_scale_bar(canvas, frame);
}

}  // namespace coapt
