#include "io/picture/picture.h"

#include <algorithm>

#include "core/closure/standing.h"
#include "io/json/version.h"
#include "io/picture/atrial_view.h"
#include "io/picture/repair_paint.h"
#include "io/picture/section_map.h"
#include "io/picture/section_view.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kMargin = 32.0;
constexpr double kDense = 2.0;  // pixels a unit, for print

struct Line {
  std::string text;
  TextStyle style;
};

std::vector<Line> caption(const ClosedValve& closed) {
  const ValveMeasure& measure = closed.measure;
  const Coaptation& coaptation = measure.coaptation;
  const auto touching = std::count_if(coaptation.sections.begin(), coaptation.sections.end(),
                                      [](const CoaptationSection& s) { return s.contact; });
  std::vector<Line> lines;
  lines.push_back({"Leak " + with_error(measure.leak.area_mm2, measure.leak_error_mm2, "mm²"),
                   {24.0, palette::kInk, Align::Left, true}});
  lines.push_back({"Coaptation height " + fixed(coaptation.height_mean_mm, 1) + " mm mean, " +
                       fixed(coaptation.height_min_mm, 1) + " mm minimum; contact in " +
                       std::to_string(touching) + " of 9 sections",
                   {15.0}});
  if (touching < 9)
    lines.push_back(
        {"Leaflets up to " + fixed(coaptation.distance_max_mm, 1) + " mm apart", {15.0}});
  const ClosureResult& closure = closed.closure;
  const std::string doubt = doubt_about(closure);
  lines.push_back(
      {(doubt.empty() ? "Closure converged" : doubt) + ", residual " + fixed(closure.residual, 3),
       {15.0, doubt.empty() ? palette::kInk : palette::kWarning, Align::Left, !doubt.empty()}});
  lines.push_back({closure.crossing
                       ? counted(closure.crossing_pairs, "pair") + " of triangles cross"
                       : "The leaflets do not cross",
                   {15.0}});
  return lines;
}

/// Returns where it ends.
double draw_caption(const Canvas& canvas, const Eigen::Vector2d& at, const ClosedValve& closed,
                    double width) {
  double y = at.y();
  for (const Line& line : caption(closed)) {
    y += 1.5 * line.style.size;
    draw_text(canvas, {at.x(), y}, line.text, line.style, width);
  }
  return y;
}

void draw_notice(const Canvas& canvas, double width, double height) {
  draw_text(canvas, {0.5 * width, height - 16.0}, std::string(kResearchNotice),
            {13.0, palette::kMuted, Align::Centre}, width - 2.0 * kMargin);
}

void draw_heading(const Canvas& canvas, const Box& box, const std::string& text) {
  draw_text(canvas, {box.x + 4.0, box.y - 12.0}, text, {16.0, palette::kMuted});
}

/// The largest scale at which both fit.
double common_scale(double (*scale)(const Box&, const ClosedValve&), const Box& box,
                    const ClosedValve& before, const ClosedValve& after) {
  return std::min(scale(box, before), scale(box, after));
}

}  // namespace

std::string closure_picture_png(const ClosedValve& closed, const std::string& diastole) {
  constexpr int kWidth = 1600, kHeight = 880;
  const Canvas canvas = make_canvas(kWidth, kHeight);
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  draw_text(canvas, {kMargin, 46.0}, closed.valve.name, {24.0, palette::kInk, Align::Left, true},
            kWidth - 2.0 * kMargin);
  const Box atrial{kMargin, 110.0, 880.0, 700.0};
  const Box section{960.0, 110.0, kWidth - 960.0 - kMargin, 510.0};
  draw_heading(canvas, atrial, "From the atrium");
  draw_atrial_view(canvas, {atrial, atrial_scale(atrial, closed)}, closed);
  draw_heading(canvas, section, "Long axis, through the middle of both leaflets");
  draw_section_view(canvas, {section, section_scale(section, closed)}, closed);
  draw_legend(canvas, {atrial.x + 4.0, atrial.y + atrial.height + 4.0}, kWidth - 2.0 * kMargin,
              {&closed});
  const double end = draw_caption(canvas, {section.x + 4.0, section.y + section.height + 20.0},
                                  closed, section.width);
  if (!diastole.empty())
    draw_text(canvas, {section.x + 4.0, end + 22.5}, diastole, {15.0}, section.width);
  draw_notice(canvas, kWidth, kHeight);
  return to_png(canvas);
}

std::string comparison_picture_png(const ClosedValve& before, const ClosedValve& after) {
  constexpr int kWidth = 1300, kHeight = 1245;
  const Canvas canvas = make_canvas(kWidth, kHeight);
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  constexpr double kColumn = 0.5 * kWidth - 1.5 * kMargin;
  const auto atrial = [](double x) { return Box{x, 70.0, kColumn, 490.0}; };
  const auto section = [](double x) { return Box{x, 570.0, kColumn, 410.0}; };
  const double seen_from_atrium = common_scale(atrial_scale, atrial(0.0), before, after);
  const double seen_in_section = common_scale(section_scale, section(0.0), before, after);
  double x = kMargin;
  for (const auto& [closed, title] : {std::pair(&before, "Before"), std::pair(&after, "After")}) {
    draw_text(canvas, {x + 4.0, 44.0}, title, {24.0, palette::kInk, Align::Left, true});
    draw_atrial_view(canvas, {atrial(x), seen_from_atrium}, *closed);
    draw_section_view(canvas, {section(x), seen_in_section}, *closed);
    draw_caption(canvas, {x + 4.0, 990.0}, *closed, kColumn);
    x += kColumn + kMargin;
  }
  set_colour(canvas, palette::kHairline);
  cairo_set_line_width(canvas.context.get(), 1.0);
  cairo_move_to(canvas.context.get(), 0.5 * kWidth, 30.0);
  cairo_line_to(canvas.context.get(), 0.5 * kWidth, kHeight - 85.0);
  cairo_stroke(canvas.context.get());
  draw_legend(canvas, {kMargin + 4.0, kHeight - 72.0}, kWidth - 2.0 * kMargin, {&before, &after});
  draw_notice(canvas, kWidth, kHeight);
  return to_png(canvas);
}

std::string atrial_pair_png(const ClosedValve& before, const ClosedValve& after) {
  constexpr int kWidth = 960, kHeight = 340;
  const Canvas canvas = make_canvas(kWidth, kHeight, kDense);
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  const auto column = [](double x) { return Box{x, 26.0, 0.5 * kWidth - 4.0, 284.0}; };
  const double scale = common_scale(atrial_scale, column(0.0), before, after);
  double x = 0.0;
  for (const auto& [closed, title] :
       {std::pair(&before, "Before repair, seen from the atrium"), std::pair(&after, "After")}) {
    draw_text(canvas, {x + 8.0, 20.0}, title, {16.0, palette::kInk, Align::Left, true});
    draw_atrial_view(canvas, {column(x), scale}, *closed);
    x += 0.5 * kWidth + 4.0;
  }
  draw_legend(canvas, {8.0, 313.0}, kWidth - 16.0, {&before, &after});
  return to_png(canvas);
}

std::string after_pair_png(const ClosedValve& after) {
  constexpr int kWidth = 960, kHeight = 300;
  const Canvas canvas = make_canvas(kWidth, kHeight, kDense);
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  const Box atrial{0.0, 4.0, 0.5 * kWidth - 4.0, kHeight - 8.0};
  const Box section{0.5 * kWidth + 4.0, 4.0, 0.5 * kWidth - 4.0, kHeight - 8.0};
  draw_atrial_view(canvas, {atrial, atrial_scale(atrial, after)}, after);
  draw_section_view(canvas, {section, section_scale(section, after)}, after);
  return to_png(canvas);
}

std::string section_change_png(const ClosedValve& before, const ClosedValve& after) {
  constexpr int kWidth = 470, kHeight = 304;
  const Canvas canvas = make_canvas(kWidth, kHeight, kDense);
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  const Box section{0.0, 22.0, kWidth, kHeight - 22.0};
  draw_text(canvas, {8.0, 20.0}, "After repair, section through the middle; grey: before",
            {16.0, palette::kInk, Align::Left, true}, kWidth - 16.0);
  draw_section_view(canvas, {section, common_scale(section_scale, section, before, after)}, after,
                    &before);
  return to_png(canvas);
}

}  // namespace coapt
