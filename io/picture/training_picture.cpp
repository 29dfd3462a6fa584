#include "io/picture/training_picture.h"

#include <algorithm>

#include "core/metrics/annulus.h"
#include "io/json/version.h"
#include "io/picture/atrial_view.h"

namespace coapt {
namespace {

constexpr double kRim = 24.0, kTitle = 40.0, kNotice = 30.0;
constexpr double kCaseWidth = 640.0, kCaseHeight = 520.0;

void draw_case_title(const Canvas& canvas, const Box& box, const std::string& text) {
  draw_text(canvas, {box.x + 4.0, box.y - 12.0}, text, {22.0, palette::kInk, Align::Left, true});
}

void draw_case_notice(const Canvas& canvas, double width, double height) {
  draw_text(canvas, {0.5 * width, height - 10.0}, std::string(kResearchNotice),
            {13.0, palette::kMuted, Align::Centre}, width - 2.0 * kRim);
}

}  // namespace

std::string choices_picture_png(const std::array<const ClosedValve*, kChoices>& choices) {
  constexpr double kWidth = 2.0 * kCaseWidth + 3.0 * kRim;
  constexpr double kHeight = 2.0 * (kTitle + kCaseHeight) + kRim + kNotice;
  const Canvas canvas = make_canvas(static_cast<int>(kWidth), static_cast<int>(kHeight));
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  const auto box = [](std::size_t i) {
    return Box{kRim + static_cast<double>(i % 2) * (kCaseWidth + kRim),
               kTitle + static_cast<double>(i / 2) * (kCaseHeight + kTitle), kCaseWidth,
               kCaseHeight};
  };
  double pixels_per_mm = atrial_scale(box(0), *choices[0]);
  for (const ClosedValve* choice : choices)
    pixels_per_mm = std::min(pixels_per_mm, atrial_scale(box(0), *choice));
  for (std::size_t i = 0; i < kChoices; ++i) {
    draw_case_title(canvas, box(i), std::to_string(i + 1));
    draw_atrial_view(canvas, {box(i), pixels_per_mm}, *choices[i]);
  }
  draw_case_notice(canvas, kWidth, kHeight);
  return to_png(canvas);
}

std::string flaccid_picture_png(const Valve& valve, const Points& flaccid_mm) {
  constexpr double kWidth = kCaseWidth + 2.0 * kRim, kHeight = kTitle + kCaseHeight + kNotice;
  const Canvas canvas = make_canvas(static_cast<int>(kWidth), static_cast<int>(kHeight));
  fill_box(canvas, {0.0, 0.0, kWidth, kHeight}, palette::kPaper);
  ClosedValve flaccid{valve, {}, {}};
  flaccid.valve.chordae.clear();
  flaccid.closure.closed_mm = flaccid_mm;
  flaccid.measure.annulus = measure_annulus(valve);
  const Box box{kRim, kTitle, kCaseWidth, kCaseHeight};
  draw_case_title(canvas, box, "Without pressure, from the atrium");
  draw_open_atrial_view(canvas, {box, atrial_scale(box, flaccid)}, flaccid);
  draw_case_notice(canvas, kWidth, kHeight);
  return to_png(canvas);
}

}  // namespace coapt
