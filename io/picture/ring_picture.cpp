#include "io/picture/ring_picture.h"

#include <array>

#include "core/repair/rings.h"
#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kSheetWidth = 900.0, kSheetHeight = 430.0, kPixelsPerMm = 8.5;
constexpr double kTopX = 230.0, kSideX = 660.0, kMiddleY = 205.0;
constexpr std::array kDashes = {"", "7 4", "2 3"};
constexpr const char* kSubject = "#0072b2";
constexpr const char* kOthers = "#7a828c";

struct RingView {
  double x = 0.0, y = 0.0;      // of the origin, px
  int across = 0, upwards = 1;  // columns of the contour
};

std::string ring_outline(const RingView& view, const DrawnRing& ring,
                         const std::string& attributes) {
  std::string points;
  for (Index i = 0; i < ring.contour_mm.rows(); i += 3)
    points += fixed(view.x + kPixelsPerMm * ring.contour_mm(i, view.across), 1) + "," +
              fixed(view.y - kPixelsPerMm * ring.contour_mm(i, view.upwards), 1) + " ";
  return "<polygon fill=\"none\" stroke-linejoin=\"round\" " + attributes + " points=\"" + points +
         "\"/>\n";
}

/// Of the ring at `index` in the list.
std::string style_of(std::size_t index) {
  if (index == 0) return std::string("stroke=\"") + kSubject + "\" stroke-width=\"4\"";
  return std::string("stroke=\"") + kOthers + "\" stroke-width=\"1.5\" stroke-dasharray=\"" +
         kDashes[(index - 1) % kDashes.size()] + "\"";
}

}  // namespace

std::string ring_picture_svg(const std::vector<DrawnRing>& rings) {
  const std::array views = {RingView{kTopX, kMiddleY, 0, 1}, RingView{kSideX, kMiddleY, 0, 2}};
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    fixed(kSheetWidth, 0) + " " + fixed(kSheetHeight, 0) +
                    "\" font-family=\"sans-serif\" font-size=\"15\" fill=\"#1c2733\">\n"
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  const std::string middle = "text-anchor=\"middle\"",
                    muted = middle + " fill=\"#66737f\" font-size=\"13\"";
  svg += text_at(kTopX, 26.0, middle + " font-weight=\"600\"", "From the atrium");
  svg += text_at(kSideX, 26.0, middle + " font-weight=\"600\"", "From behind");
  for (const RingView& view : views)
    for (std::size_t k = rings.size(); k-- > 0;) svg += ring_outline(view, rings[k], style_of(k));
  svg += text_at(kTopX, 46.0, muted, "anterior above, P3 at the lower right");
  svg += text_at(kSideX, 46.0, muted, "atrium above, P3 on the right");
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const double x = 30.0 + 290.0 * static_cast<double>(k % 3);
    const double y = kSheetHeight - 46.0 + 22.0 * static_cast<double>(k / 3);
    svg += "<path d=\"M" + fixed(x, 0) + " " + fixed(y - 5.0, 0) + "h34\" " + style_of(k) + "/>\n";
    svg += text_at(x + 42.0, y, "", rings[k].label);
  }
  const double bar = 10.0 * kPixelsPerMm;
  svg += "<path d=\"M" + fixed(kSheetWidth - 30.0 - bar, 1) + " " + fixed(kSheetHeight - 24.0, 1) +
         "h" + fixed(bar, 1) + "\" stroke=\"#1c2733\" stroke-width=\"2\"/>\n";
  svg += text_at(kSheetWidth - 30.0 - 0.5 * bar, kSheetHeight - 30.0, middle, "10 mm");
  return svg + "</svg>\n";
}

std::vector<DrawnRing> beside_generic(const DesignedShape& shape, double size_mm) {
  std::vector<DrawnRing> rings = {
      {shape.name + ", " + fixed(size_mm, 0) + " mm", ring_contour_mm(shape.terms, size_mm)}};
  for (const RingShape& generic : kRingShapes)
    rings.push_back(
        {std::string(generic.name), ring_contour_mm(generic, size_mm / generic.transverse_factor)});
  return rings;
}

}  // namespace coapt
