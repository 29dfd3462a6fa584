#include "io/picture/atrial_names.h"

#include <algorithm>

#include "core/metrics/annulus.h"

namespace coapt {
namespace {

struct Label {
  Vec2 at;
  double left, right;
};

/// Lines further out, up or down, that keep it off the labels placed before.
void keep_apart(Label& label, bool upwards, const std::vector<Label>& placed) {
  constexpr double kLine = 15.0;
  const auto covers = [&](const Label& other) {
    return label.left < other.right && other.left < label.right &&
           std::abs(label.at.y() - other.at.y()) < kLine;
  };
  for (int lines = 0; lines < 3 && std::any_of(placed.begin(), placed.end(), covers); ++lines)
    label.at.y() += upwards ? -kLine : kLine;
}

}  // namespace

void draw_landmarks(const Canvas& canvas, const Valve& valve, const AnnulusFrame& plane,
                    const Mapping& map, const Vec2& centre_px) {
  const Landmarks& marks = valve.landmarks;
  const std::pair<int, const char*> labelled[] = {
      {marks.saddle_peak, "saddle peak"},           {marks.mid_posterior, "mid-posterior"},
      {marks.anterolateral_commissure, "AL comm."}, {marks.posteromedial_commissure, "PM comm."},
      {marks.anterolateral_trigone, "AL trigone"},  {marks.posteromedial_trigone, "PM trigone"}};
  std::vector<Label> placed;
  for (const auto& [vertex, words] : labelled) {
    const Vec2 at = map(project(plane, annulus_position_mm(valve, vertex)));
    const Vec2 outwards = (at - centre_px).normalized();
    fill_circle(canvas, at, 5.5, palette::kAnnulus);
    fill_circle(canvas, at, 3.5, palette::kPaper);
    const Align align = outwards.x() > 0.35    ? Align::Left
                        : outwards.x() < -0.35 ? Align::Right
                                               : Align::Centre;
    const TextStyle style{13.0, palette::kMuted, align, false, 3.0};
    const double width = text_width(canvas, words, style);
    Label label{at + 13.0 * outwards + Vec2(0.0, 5.0 + 4.0 * outwards.y()), 0.0, 0.0};
    label.left = label.at.x() - (align == Align::Right    ? width
                                 : align == Align::Centre ? 0.5 * width
                                                          : 0.0);
    label.right = label.left + width;
    keep_apart(label, outwards.y() < 0.0, placed);
    draw_text(canvas, label.at, words, style);
    placed.push_back(label);
  }
}

void draw_segment_names(const Canvas& canvas, const Valve& valve, const AnnulusFrame& plane,
                        const Mapping& map, const Vec2& centre_px) {
  constexpr double kLeastInwards = 20.0;  // px: clear of a ring
  std::vector<char> on_annulus(static_cast<std::size_t>(valve.rest_mm.rows()), 0);
  for (const int vertex : valve.annulus) on_annulus[static_cast<std::size_t>(vertex)] = 1;
  for (const Segment segment :
       {Segment::A1, Segment::A2, Segment::A3, Segment::P1, Segment::P2, Segment::P3}) {
    Vec2 sum_mm = Vec2::Zero();
    int count = 0;
    for (Eigen::Index f = 0; f < valve.faces.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int vertex = valve.faces(f, k);
        if (valve.segments[static_cast<std::size_t>(f)] != segment ||
            !on_annulus[static_cast<std::size_t>(vertex)])
          continue;
        sum_mm += project(plane, annulus_position_mm(valve, vertex));
        ++count;
      }
    if (count == 0) continue;
    const Vec2 at = map(sum_mm / count);
    const Vec2 inwards = (centre_px - at).normalized();
    const double way = std::max(kLeastInwards, 2.6 * map.pixels_per_mm);
    draw_text(canvas, at + way * inwards + Vec2(0.0, 5.0), to_string(segment),
              {14.0, {0.35, 0.16, 0.12}, Align::Centre, true, 1.8});
  }
}

}  // namespace coapt
