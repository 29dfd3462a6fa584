#include "io/picture/canvas.h"

#include <cmath>
#include <numbers>

#include "io/picture/text.h"

namespace coapt {
namespace {

void choose_font(const Canvas& canvas, const TextStyle& style) {
  cairo_select_font_face(canvas.context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(canvas.context.get(), style.size);
}

/// Takes the last character off, all its bytes.
void shorten(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0u) == 0x80u)
    text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

Canvas make_canvas(int width, int height, double scale) {
  const auto pixels = [scale](int units) { return static_cast<int>(std::ceil(scale * units)); };
  Canvas canvas{{cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels(width), pixels(height)),
                 &cairo_surface_destroy},
                {nullptr, &cairo_destroy}};
  canvas.context.reset(cairo_create(canvas.surface.get()));
  cairo_scale(canvas.context.get(), scale, scale);
  cairo_set_line_join(canvas.context.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(canvas.context.get(), CAIRO_LINE_CAP_ROUND);
  return canvas;
}

void set_colour(const Canvas& canvas, const Colour& colour) {
  cairo_set_source_rgba(canvas.context.get(), colour.red, colour.green, colour.blue, colour.alpha);
}

void fill_box(const Canvas& canvas, const Box& box, const Colour& colour) {
  set_colour(canvas, colour);
  cairo_rectangle(canvas.context.get(), box.x, box.y, box.width, box.height);
  cairo_fill(canvas.context.get());
}

void fill_circle(const Canvas& canvas, const Eigen::Vector2d& centre, double radius,
                 const Colour& colour) {
  set_colour(canvas, colour);
  cairo_arc(canvas.context.get(), centre.x(), centre.y(), radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(canvas.context.get());
}

double text_width(const Canvas& canvas, const std::string& text, const TextStyle& style) {
  choose_font(canvas, style);
  cairo_text_extents_t extents;
  cairo_text_extents(canvas.context.get(), printable(text).c_str(), &extents);
  return extents.x_advance;
}

void draw_text(const Canvas& canvas, const Eigen::Vector2d& at, const std::string& text,
               const TextStyle& style, double max_width) {
  constexpr std::size_t kLongest = 400;  // characters; more never fit on a picture
  std::string shown = printable(text.substr(0, kLongest));
  if (max_width > 0.0 && text_width(canvas, shown, style) > max_width) {
    while (!shown.empty() && text_width(canvas, shown + "…", style) > max_width) shorten(shown);
    shown += "…";
  }
  double x = at.x();
  if (style.align == Align::Centre) x -= 0.5 * text_width(canvas, shown, style);
  if (style.align == Align::Right) x -= text_width(canvas, shown, style);
  choose_font(canvas, style);
  cairo_t* cairo = canvas.context.get();
  cairo_move_to(cairo, x, at.y());
  if (style.halo > 0.0) {
    cairo_text_path(cairo, shown.c_str());
    set_colour(canvas, palette::kPaper);
    cairo_set_line_width(cairo, 2.0 * style.halo);
    cairo_stroke(cairo);
    cairo_move_to(cairo, x, at.y());
  }
  set_colour(canvas, style.colour);
  cairo_show_text(cairo, shown.c_str());
  cairo_new_path(cairo);
}

std::string to_png(const Canvas& canvas) {
  std::string bytes;
  const auto append = [](void* sink, const unsigned char* part, unsigned int length) {
    static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(part), length);
    return CAIRO_STATUS_SUCCESS;
  };
  if (cairo_surface_write_to_png_stream(canvas.surface.get(), append, &bytes) !=
      CAIRO_STATUS_SUCCESS)
    bytes.clear();
  return bytes;
}

}  // namespace coapt
