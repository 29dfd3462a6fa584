#include "io/picture/view_frame.h"

#include "core/valve/types.h"

namespace coapt {

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

void draw_unknown(const Canvas& canvas, const ViewFrame& frame) {
  draw_text(canvas, {frame.box.x + 0.5 * frame.box.width, frame.box.y + 0.5 * frame.box.height},
            "The closure diverged, so there is nothing to draw.",
            {16.0, palette::kWarning, Align::Centre}, frame.box.width);
}

}  // namespace coapt
