#include "io/picture/opening_picture.h"

#include <cmath>

#include "core/closed/closed_valve.h"
#include "core/valve/number_text.h"
#include "io/json/version.h"
#include "io/picture/atrial_view.h"
#include "io/picture/repair_paint.h"
#include "io/picture/section_map.h"
#include "io/picture/section_view.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr int kWide = 1600, kHigh = 880;
constexpr double kEdge = 32.0;

std::string cm2(double mm2) { return fixed(0.01 * mm2, 1) + " cm²"; }

/// What views draw of it.
ClosedValve as_drawn(const OpenedValve& opened, const Valve& before, const RepairPlan& plan) {
  ClosedValve drawn{opened.valve, opened.closure, {}};
  drawn.measure.annulus = measure_annulus(opened.valve);
  drawn.measure.leak = opened.leak;
  const Expected<Valve> open_before = in_diastole(before);
  return open_before ? with_repair(std::move(drawn), *open_before, plan) : drawn;
}

void draw_words(const Canvas& canvas, const Vec2& at, const OpenedValve& opened, double width) {
  double y = at.y();
  double size = 24.0;
  for (const std::string& line : opening_words(opened.measure)) {
    y += 1.5 * size;
    draw_text(canvas, {at.x(), y}, line, {size, palette::kInk, Align::Left, size > 20.0}, width);
    size = 15.0;
  }
  if (trusted(opened.closure)) return;
  draw_text(canvas, {at.x(), y + 30.0},
            opened.closure.crossing
                ? "The leaflets cross, so nothing was measured"
                : "The leaflets did not reach equilibrium, so nothing was measured",
            {15.0, palette::kWarning, Align::Left, true}, width);
}

}  // namespace

std::vector<std::string> opening_words(const OpeningMeasure& measure) {
  if (std::isnan(measure.opening_area_mm2)) return {};
  return {"Opening " + cm2(measure.opening_area_mm2),
          "mean gradient " + fixed(measure.gradient_mmhg, 1) + " mmHg at " +
              significant(measure.flow_ml_s, 3) + " ml/s, " +
              fixed(measure.gradient_exercise_mmhg, 1) + " mmHg at " +
              significant(measure.flow_exercise_ml_s, 3) + " ml/s",
          "projected on the annular plane " + cm2(measure.projected_area_mm2) +
              "; annulus in diastole " + cm2(measure.annulus_area_mm2)};
}

std::string opening_line(const OpenedValve& opened) {
  if (!trusted(opened.closure))
    return "In diastole the leaflets cross or did not reach equilibrium";
  return "Opening " + cm2(opened.measure.opening_area_mm2) + ", mean gradient " +
         fixed(opened.measure.gradient_mmhg, 1) + " mmHg at " +
         significant(opened.measure.flow_ml_s, 3) + " ml/s in diastole";
}

std::string opening_picture_png(const OpenedValve& opened, const Valve& before,
                                const RepairPlan& plan) {
  const Canvas canvas = make_canvas(kWide, kHigh);
  fill_box(canvas, {0.0, 0.0, kWide, kHigh}, palette::kPaper);
  draw_text(canvas, {kEdge, 46.0}, opened.valve.name + ", open",
            {24.0, palette::kInk, Align::Left, true}, kWide - 2.0 * kEdge);
  const Box atrial{kEdge, 110.0, 880.0, 700.0};
  const Box section{960.0, 110.0, kWide - 960.0 - kEdge, 510.0};
  const auto heading = [&](const Box& box, const char* text) {
    draw_text(canvas, {box.x + 4.0, box.y - 12.0}, text, {16.0, palette::kMuted});
  };
  const ClosedValve drawn = as_drawn(opened, before, plan);
  heading(atrial, "From the atrium, in diastole");
  draw_open_atrial_view(canvas, {atrial, atrial_scale(atrial, drawn)}, drawn);
  heading(section, "Long axis, through the middle of both leaflets");
  draw_open_section_view(canvas, {section, section_scale(section, drawn)}, drawn);
  draw_legend(canvas, {atrial.x + 4.0, atrial.y + atrial.height + 4.0}, kWide - 2.0 * kEdge,
              {&drawn});
  draw_words(canvas, {section.x + 4.0, section.y + section.height + 20.0}, opened, section.width);
  draw_text(canvas, {0.5 * kWide, kHigh - 16.0}, std::string(kResearchNotice),
            {13.0, palette::kMuted, Align::Centre}, kWide - 2.0 * kEdge);
  return to_png(canvas);
}

}  // namespace coapt
