#include "io/picture/opening_paint.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/gap.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kLabelled_mm2 = 0.5;  // smaller openings are coloured, not labelled
constexpr double kSeenThrough = 0.5;   // of the colour

/// Or as near to one as its rim, where the leaflets' thickness closes what their mid-surfaces leave open.
bool is_in_orifice(const OrificeView& view, const Vec2& coordinates_mm, double half_thickness_mm) {
  const Vec2 at = to_pixels(view, coordinates_mm);
  const double rim = half_thickness_mm / view.mm_per_pixel;
  return std::any_of(view.runs.begin(), view.runs.end(), [&](const PixelRun& run) {
    return run.row - rim <= at.y() && at.y() <= run.row + 1 + rim && run.first - rim <= at.x() &&
           at.x() <= run.last + 1 + rim;
  });
}

void draw_pill(const Canvas& canvas, const Vec2& from, const Vec2& to, const std::string& text) {
  const TextStyle style{15.0, palette::kPaper, Align::Centre, true};
  cairo_t* cairo = canvas.context.get();
  set_colour(canvas, palette::kOrifice);
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

std::vector<GapStrip> hidden_gaps(const ClosedValve& closed, const OrificeView& view) {
  const double half_thickness_mm = 0.5 * closed.valve.tissue.thickness_mm;
  std::vector<GapStrip> strips(1);
  for (const GapPlace& place : measure_gap(closed.valve, closed.closure.closed_mm).places) {
    const Vec2 anterior = project(view.plane, place.anterior_mm);
    const Vec2 posterior = project(view.plane, place.posterior_mm);
    if (place.width_mm == 0.0 ||
        is_in_orifice(view, 0.5 * (anterior + posterior), half_thickness_mm)) {
      strips.emplace_back();
    } else {
      strips.back().anterior.push_back(anterior);
      strips.back().posterior.push_back(posterior);
    }
  }
  std::erase_if(strips, [](const GapStrip& strip) { return strip.anterior.size() < 2; });
  return strips;
}

void paint_orifices(const Canvas& canvas, const OrificeView& view, const Mapping& map) {
  cairo_t* cairo = canvas.context.get();
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
  set_colour(canvas, palette::kOrifice);
  for (const PixelRun& run : view.runs) {
    const Vec2 from = map(from_pixels(view, Vec2(run.first, run.row)));
    const Vec2 to = map(from_pixels(view, Vec2(run.last + 1, run.row + 1)));
    cairo_rectangle(cairo, from.x(), from.y(), to.x() - from.x(), to.y() - from.y());
  }
  cairo_fill(cairo);
  cairo_set_antialias(cairo, CAIRO_ANTIALIAS_DEFAULT);
}

void paint_hidden_gaps(const Canvas& canvas, const std::vector<GapStrip>& gaps,
                       const Mapping& map) {
  cairo_t* cairo = canvas.context.get();
  for (const GapStrip& strip : gaps) {
    for (const Vec2& point : strip.anterior) cairo_line_to(cairo, map(point).x(), map(point).y());
    for (auto point = strip.posterior.rbegin(); point != strip.posterior.rend(); ++point)
      cairo_line_to(cairo, map(*point).x(), map(*point).y());
    cairo_close_path(cairo);
    Colour colour = palette::kOrifice;
    set_colour(canvas, colour);
    cairo_set_line_width(cairo, 0.2 * map.pixels_per_mm);
    cairo_stroke_preserve(cairo);
    colour.alpha = kSeenThrough;
    set_colour(canvas, colour);
    cairo_fill(cairo);
  }
}

void label_openings(const Canvas& canvas, const ClosedValve& closed, const OrificeView& view,
                    const std::vector<GapStrip>& gaps, const Mapping& map) {
  constexpr std::size_t kMost = 6;
  const Vec2 out(0.0, 5.5 * map.pixels_per_mm);
  const AreaErrors& error = closed.measure.error;
  std::vector<Orifice> labelled;
  for (const Orifice& orifice : closed.measure.orifice.orifices)
    if (orifice.area_mm2 >= kLabelled_mm2 && labelled.size() < kMost) labelled.push_back(orifice);
  std::stable_sort(labelled.begin(), labelled.end(), [&](const Orifice& a, const Orifice& b) {
    return project(view.plane, a.centroid_mm).x() < project(view.plane, b.centroid_mm).x();
  });
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const Vec2 from = map(project(view.plane, labelled[i].centroid_mm));
    draw_pill(canvas, from, from + (i % 2 ? out : -out),
              known_digits(labelled[i].area_mm2, error.orifice_mm2) + " mm²");
  }
  const double gap_mm2 = closed.measure.coaptation.gap_area_mm2;
  if (gap_mm2 < kLabelled_mm2 || gap_mm2 <= closed.measure.orifice.area_mm2 || gaps.empty()) return;
  const GapStrip& longest = *std::max_element(
      gaps.begin(), gaps.end(),
      [](const GapStrip& a, const GapStrip& b) { return a.anterior.size() < b.anterior.size(); });
  const std::size_t middle = longest.anterior.size() / 2;
  const Vec2 from = map(0.5 * (longest.anterior[middle] + longest.posterior[middle]));
  draw_pill(canvas, from, from - out, "gap " + known_digits(gap_mm2, error.gap_mm2) + " mm²");
}

}  // namespace coapt
