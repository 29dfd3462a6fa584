// A sheet of pixels to draw on with cairo, and the colours of coapt's pictures.
#pragma once

#include <cairo.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace coapt {

struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;
};

namespace palette {
inline constexpr Colour kPaper{1.0, 1.0, 1.0};
inline constexpr Colour kInk{0.11, 0.15, 0.20};
inline constexpr Colour kMuted{0.40, 0.45, 0.52};
inline constexpr Colour kHairline{0.82, 0.85, 0.88};
inline constexpr Colour kWarning{0.75, 0.11, 0.11};
inline constexpr Colour kAnterior{0.91, 0.60, 0.54};
inline constexpr Colour kPosterior{0.95, 0.77, 0.57};
inline constexpr Colour kOrifice{0.07, 0.22, 0.85};
inline constexpr Colour kAnnulus{0.16, 0.22, 0.30};
inline constexpr Colour kChorda{0.55, 0.47, 0.38};
inline constexpr Colour kNeochorda{0.02, 0.52, 0.48};
inline constexpr Colour kPapillary{0.58, 0.26, 0.24};
inline constexpr Colour kRing{0.98, 0.96, 0.89};
inline constexpr Colour kBefore{0.72, 0.75, 0.79};
inline constexpr Colour kSuture{0.46, 0.07, 0.48};
}  // namespace palette

/// Pixels, y down.
struct Box {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

enum class Align { Left, Centre, Right };

struct TextStyle {
  double size = 15.0;
  Colour colour = palette::kInk;
  Align align = Align::Left;
  bool bold = false;
  double halo = 0.0;  ///< width of a paper-coloured rim that keeps text readable over tissue
};

struct Canvas {
  using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
  using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
  Surface surface;
  Context context;
};

/// Transparent. `scale`: pixels of the sheet for each unit that is drawn.
Canvas make_canvas(int width, int height, double scale = 1.0);

void fill_box(const Canvas& canvas, const Box& box, const Colour& colour);
void fill_circle(const Canvas& canvas, const Eigen::Vector2d& centre, double radius,
                 const Colour& colour);
void set_colour(const Canvas& canvas, const Colour& colour);

/// Text of any origin; `at` is its baseline. Cut short with an ellipsis beyond `max_width` (0:
/// never).
void draw_text(const Canvas& canvas, const Eigen::Vector2d& at, const std::string& text,
               const TextStyle& style, double max_width = 0.0);
double text_width(const Canvas& canvas, const std::string& text, const TextStyle& style);

/// PNG bytes, empty if there was no memory to draw in.
std::string to_png(const Canvas& canvas);

}  // namespace coapt
