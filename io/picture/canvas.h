// A sheet of pixels to draw on with cairo, and the colours of coapt's pictures.
#pragma once

#include <cairo.h>

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>

namespace coapt {

struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;
};

/// "#e8998a".
constexpr Colour hex(std::string_view text) {
  const auto part = [text](std::size_t at) {
    int value = 0;
    for (const char digit : text.substr(at, 2))
      value = 16 * value + (digit <= '9' ? digit - '0' : digit - 'a' + 10);
    return value / 255.0;
  };
  return {part(1), part(3), part(5)};
}

// Of tissue, leak and repair as on the page (clients/web/src/viewer/colours.ts; a test of the page compares).
namespace palette {
inline constexpr Colour kPaper{1.0, 1.0, 1.0};
inline constexpr Colour kInk{0.11, 0.15, 0.20};
inline constexpr Colour kMuted{0.40, 0.45, 0.52};
inline constexpr Colour kHairline{0.82, 0.85, 0.88};
inline constexpr Colour kWarning{0.75, 0.11, 0.11};
inline constexpr Colour kAnterior = hex("#e8998a");
inline constexpr Colour kPosterior = hex("#f2c491");
inline constexpr Colour kCommissure = hex("#c39bb4");
inline constexpr Colour kOpening = hex("#1668d6");
inline constexpr Colour kAnnulus = hex("#29384d");
inline constexpr Colour kChorda = hex("#8c7861");
inline constexpr Colour kAdded = hex("#0f8a5f");  ///< sutures, stitches, neochordae
inline constexpr Colour kPapillary = hex("#943f3d");
inline constexpr Colour kRing = hex("#e4e7ec");
inline constexpr Colour kSurface = hex("#9db4d6");  ///< given, its leaflets not told apart
inline constexpr Colour kBefore{0.72, 0.75, 0.79};
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
