#include "io/picture/opening_paint.h"

#include <algorithm>

#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kLabelled_mm2 = 0.5;  // smaller openings are coloured, not labelled

void draw_pill(const Canvas& canvas, const Vec2& from, const Vec2& to, const std::string& text) {
  const TextStyle style{15.0, palette::kPaper, Align::Centre, true};
  cairo_t* cairo = canvas.context.get();
  set_colour(canvas, palette::kOpening);
  cairo_set_line_width(cairo, 2.0);
  cairo_move_to(cairo, from.x(), from.y());
  cairo_line_to(cairo, to.x(), to.y());
  cairo_stroke(cairo);
  const double width = text_width(canvas, text, style);
  cairo_set_line_width(cairo, 24.0);
  cairo_move_to(cairo, to.x() - 0.5 * width, to.y());
  cairo_line_to(cairo, to.x() + 0.5 * width, to.y());
  cairo_stroke(cairo);
  draw_text(canvas, to + Vec2(0.0, 5.5), text, style);
}

}  // namespace

void paint_openings(const Canvas& canvas, const Leak& leak, const AnnulusFrame& plane,
                    const Mapping& map, double share) {
  cairo_t* cairo = canvas.context.get();
  Colour colour = palette::kOpening;
  colour.alpha = share;
  set_colour(canvas, colour);
  cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
  for (const LeakOpening& opening : leak.openings) {
    for (const auto& face : opening.surface.faces.rowwise()) {
      std::array<Vec2, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = map(
            project(plane, opening.surface.points_mm.row(face[static_cast<int>(k)]).transpose()));
      // All wind alike, so that triangles over each other do not cancel.
      const Vec2 u = corners[1] - corners[0], v = corners[2] - corners[0];
      if (u.x() * v.y() < u.y() * v.x()) std::swap(corners[1], corners[2]);
      cairo_move_to(cairo, corners[0].x(), corners[0].y());
      cairo_line_to(cairo, corners[1].x(), corners[1].y());
      cairo_line_to(cairo, corners[2].x(), corners[2].y());
      cairo_close_path(cairo);
    }
    cairo_fill(cairo);
  }
}

void draw_rims_of_openings(const Canvas& canvas, const Leak& leak, const AnnulusFrame& plane,
                           const Mapping& map) {
  cairo_t* cairo = canvas.context.get();
  for (const LeakOpening& opening : leak.openings) {
    for (const int vertex : opening.surface.outline) {
      const Vec2 at = map(project(plane, opening.surface.points_mm.row(vertex).transpose()));
      cairo_line_to(cairo, at.x(), at.y());
    }
    cairo_close_path(cairo);
    cairo_new_sub_path(cairo);
  }
  set_colour(canvas, palette::kOpening);
  cairo_set_line_width(cairo, 0.2 * map.pixels_per_mm);
  cairo_stroke(cairo);
}

void draw_opening_cuts(const Canvas& canvas, const Leak& leak, const SectionPlane& plane,
                       const SectionMap& map) {
  cairo_t* cairo = canvas.context.get();
  set_colour(canvas, palette::kOpening);
  cairo_set_line_width(cairo, 3.0);
  for (const LeakOpening& opening : leak.openings)
    for (const SectionLine& line : cut(opening.surface.faces, opening.surface.points_mm, plane)) {
      for (const Vec3& point : line.points_mm) {
        const Vec2 at = map(point);
        cairo_line_to(cairo, at.x(), at.y());
      }
      cairo_stroke(cairo);
    }
}

void label_openings(const Canvas& canvas, const ClosedValve& closed, const AnnulusFrame& plane,
                    const Mapping& map) {
  constexpr std::size_t kMost = 6;
  const Vec2 out(0.0, 5.5 * map.pixels_per_mm);
  struct Labelled {
    Vec2 at_mm;
    double area_mm2;
  };
  std::vector<Labelled> labelled;
  for (const LeakOpening& opening : closed.measure.leak.openings)
    if (opening.area_mm2 >= kLabelled_mm2 && labelled.size() < kMost)
      labelled.push_back({project(plane, opening.centroid_mm), opening.area_mm2});
  std::stable_sort(labelled.begin(), labelled.end(),
                   [](const Labelled& a, const Labelled& b) { return a.at_mm.x() < b.at_mm.x(); });
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const Vec2 from = map(labelled[i].at_mm);
    draw_pill(canvas, from, from + (i % 2 ? out : -out),
              known_digits(labelled[i].area_mm2, closed.measure.leak_error_mm2) + " mm²");
  }
}

}  // namespace coapt
