#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/metrics/coaptation.h"
#include "io/picture/text.h"
#include "io/picture/views.h"

namespace coapt {
namespace {

constexpr double kChordaReach_mm = 10.0;  // chordae that insert farther off the plane are left out

/// Section coordinates in pixels: right is posterior, up is atrial.
struct SectionMap {
  Vec3 origin_mm, right, up, out;
  Vec2 origin_px;
  double pixels_per_mm;
  Vec2 operator()(const Vec3& point) const {
    const Vec3 offset = point - origin_mm;
    return {origin_px.x() + pixels_per_mm * offset.dot(right),
            origin_px.y() - pixels_per_mm * offset.dot(up)};
  }
  double off_plane_mm(const Vec3& point) const { return std::abs((point - origin_mm).dot(out)); }
};

SectionMap make_map(const ViewFrame& frame, const Valve& valve) {
  const Box& box = frame.box;
  const SectionPlane plane = mid_valve_plane(valve);
  const Vec3 up = annular_plane(valve).normal;
  const Vec3 middle_mm = 0.5 * (annulus_position_mm(valve, valve.landmarks.saddle_peak) +
                                annulus_position_mm(valve, valve.landmarks.mid_posterior));
  return {middle_mm,
          plane.normal.cross(up),
          up,
          plane.normal,
          Vec2(box.x + 0.5 * box.width, box.y + 0.2 * box.height),
          frame.pixels_per_mm};
}

void line(const Canvas& canvas, const Vec2& from, const Vec2& to) {
  cairo_move_to(canvas.context.get(), from.x(), from.y());
  cairo_line_to(canvas.context.get(), to.x(), to.y());
}

void draw_leaflets(const Canvas& canvas, const ClosedValve& closed, const SectionMap& map) {
  cairo_t* cairo = canvas.context.get();
  const std::vector<Leaflet> sides = leaflet_sides(closed.valve);
  const std::vector<SectionLine> lines =
      cut(closed.valve.faces, closed.closure.closed_mm, mid_valve_plane(closed.valve));
  const double width = closed.valve.tissue.thickness_mm * map.pixels_per_mm;
  const auto stroke = [&](Leaflet side, double stroke_width, const Colour& colour) {
    for (const SectionLine& section : lines)
      for (std::size_t i = 0; i < section.faces.size(); ++i)
        if (sides[static_cast<std::size_t>(section.faces[i])] == side)
          line(canvas, map(section.points_mm[i]), map(section.points_mm[i + 1]));
    set_colour(canvas, colour);
    cairo_set_line_width(cairo, stroke_width);
    cairo_stroke(cairo);
  };
  const auto outline = [](const Colour& tint) {
    return Colour{0.55 * tint.red, 0.55 * tint.green, 0.55 * tint.blue};
  };
  for (const auto& [side, tint] : {std::pair(Leaflet::Anterior, palette::kAnterior),
                                   std::pair(Leaflet::Posterior, palette::kPosterior)}) {
    stroke(side, width, outline(tint));
    stroke(side, std::max(1.0, width - 2.5), tint);
  }
}

/// Chordae that insert near the plane, whole, and fainter the farther off they insert.
void draw_chordae(const Canvas& canvas, const ClosedValve& closed, const SectionMap& map) {
  const Valve& valve = closed.valve;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    const int segments = static_cast<int>(chorda.segments.size());
    const bool solved = c < closed.closure.branch_points_mm.size() &&
                        closed.closure.branch_points_mm[c].rows() == segments;
    if (chorda.ruptured || !solved) continue;
    const auto end_mm = [&](int segment) -> Vec3 {
      return segment < 0 ? valve.heads[static_cast<std::size_t>(chorda.head)].tip_mm
                         : Vec3(closed.closure.branch_points_mm[c].row(segment).transpose());
    };
    double nearness = 0.0;
    for (int s = 0; s < segments; ++s)
      if (chorda.segments[static_cast<std::size_t>(s)].inserts)
        nearness = std::max(nearness, 1.0 - map.off_plane_mm(end_mm(s)) / kChordaReach_mm);
    if (nearness == 0.0) continue;
    Colour colour = chorda.kind == ChordaKind::Neochorda ? palette::kNeochorda : palette::kChorda;
    colour.alpha = 0.2 + 0.7 * nearness;
    for (int s = 0; s < segments; ++s) {
      const ChordaSegment& segment = chorda.segments[static_cast<std::size_t>(s)];
      line(canvas, map(end_mm(segment.parent)), map(end_mm(s)));
      cairo_set_line_width(canvas.context.get(),
                           std::max(1.2, 0.2 * segment.diameter_mm * map.pixels_per_mm));
      set_colour(canvas, colour);
      cairo_stroke(canvas.context.get());
    }
  }
}

void draw_tips(const Canvas& canvas, const Valve& valve, const SectionMap& map) {
  if (valve.heads.empty()) return;
  Vec2 lowest = map(valve.heads.front().tip_mm);
  for (const PapillaryHead& head : valve.heads) {
    const Vec2 at = map(head.tip_mm);
    if (at.y() > lowest.y()) lowest = at;
    fill_circle(canvas, at, 6.0, palette::kPapillary);
  }
  draw_text(canvas, lowest + Vec2(0.0, 24.0), "papillary tips",
            {13.0, palette::kMuted, Align::Centre});
}

void draw_tenting(const Canvas& canvas, const Tenting& tenting, const SectionMap& map,
                  const Vec2& saddle_peak, const Vec2& mid_posterior) {
  cairo_t* cairo = canvas.context.get();
  const Vec2 point = map(tenting.coaptation_point_mm);
  const Vec2 along = (mid_posterior - saddle_peak).normalized();
  const Vec2 foot = saddle_peak + (point - saddle_peak).dot(along) * along;
  const double dashes[] = {5.0, 5.0};
  cairo_set_dash(cairo, dashes, 2, 0.0);
  cairo_set_line_width(cairo, 1.8);
  set_colour(canvas, palette::kInk);
  line(canvas, foot, point);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
  fill_circle(canvas, point, 4.0, palette::kInk);
  const bool billows = tenting.height_mm < 0.0;
  draw_text(canvas, foot + Vec2(0.0, billows ? 24.0 : -12.0),
            (billows ? "billow " : "tenting ") + fixed(std::abs(tenting.height_mm), 1) + " mm",
            {13.0, palette::kInk, Align::Centre, false, 3.0});
}

}  // namespace

void draw_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed) {
  if (!closed.closure.closed_mm.allFinite()) return draw_unknown(canvas, frame);
  const Valve& valve = closed.valve;
  const Box& box = frame.box;
  const Vec3 saddle_peak_mm = annulus_position_mm(valve, valve.landmarks.saddle_peak);
  const Vec3 mid_posterior_mm = annulus_position_mm(valve, valve.landmarks.mid_posterior);
  const SectionMap map = make_map(frame, valve);
  const Vec2 saddle_peak = map(saddle_peak_mm), mid_posterior = map(mid_posterior_mm);
  const Tenting tenting = measure_tenting(valve, closed.closure.closed_mm);

  cairo_t* cairo = canvas.context.get();
  cairo_save(cairo);
  cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
  cairo_clip(cairo);
  draw_chordae(canvas, closed, map);
  draw_tips(canvas, valve, map);
  draw_leaflets(canvas, closed, map);
  set_colour(canvas, palette::kAnnulus);
  cairo_set_line_width(cairo, 1.8);
  line(canvas, saddle_peak, mid_posterior);
  cairo_stroke(cairo);
  for (const Vec2& end : {saddle_peak, mid_posterior})
    fill_circle(canvas, end, 5.0, palette::kAnnulus);
  draw_tenting(canvas, tenting, map, saddle_peak, mid_posterior);
  draw_text(canvas, saddle_peak + Vec2(-14.0, 5.0), "anterior",
            {13.0, palette::kMuted, Align::Right});
  draw_text(canvas, mid_posterior + Vec2(14.0, 5.0), "posterior", {13.0, palette::kMuted});
  draw_text(canvas, Vec2(box.x + 0.5 * box.width, box.y + 22.0), "left atrium",
            {14.0, palette::kMuted, Align::Centre});
  draw_text(canvas, Vec2(box.x + box.width - 16.0, box.y + box.height - 18.0), "left ventricle",
            {14.0, palette::kMuted, Align::Right});
  cairo_restore(cairo);
  draw_scale_bar(canvas, frame);
}

double section_scale(const Box& box, const ClosedValve& closed) {
  constexpr double kLabels = 85.0, kBelow = 44.0;  // pixels beside the annulus, and under the tips
  const SectionMap map = make_map({box, 1.0}, closed.valve);
  double depth_mm = 12.0;
  for (const PapillaryHead& head : closed.valve.heads)
    depth_mm = std::max(depth_mm, map(head.tip_mm).y() - map.origin_px.y());
  return std::min((box.width - 2.0 * kLabels) / closed.measure.annulus.ap_mm,
                  (box.y + box.height - map.origin_px.y() - kBelow) / depth_mm);
}

}  // namespace coapt
