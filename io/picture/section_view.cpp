#include "io/picture/section_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/metrics/coaptation.h"
#include "core/metrics/leaflet_sides.h"
#include "io/picture/opening_paint.h"
#include "io/picture/repair_paint.h"
#include "io/picture/section_map.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kBillow_mm = 2.0;  // above the annular line; less is the belly of any leaflet
constexpr double kChordaReach_mm = 10.0;  // chordae that insert farther off the plane are left out

void line(const Canvas& canvas, const Vec2& from, const Vec2& to) {
  cairo_move_to(canvas.context.get(), from.x(), from.y());
  cairo_line_to(canvas.context.get(), to.x(), to.y());
}

void draw_leaflets(const Canvas& canvas, const ClosedValve& closed,
                   const std::vector<SectionLine>& lines, const SectionMap& map) {
  cairo_t* cairo = canvas.context.get();
  const std::vector<Leaflet> sides = leaflet_sides(closed.valve);
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

/// In the same plane, thin and grey.
void draw_before(const Canvas& canvas, const ClosedValve& before, const SectionPlane& plane,
                 const SectionMap& map) {
  if (!before.closure.closed_mm.allFinite()) return;
  for (const SectionLine& section : cut(before.valve.faces, before.closure.closed_mm, plane))
    for (std::size_t i = 0; i + 1 < section.points_mm.size(); ++i)
      line(canvas, map(section.points_mm[i]), map(section.points_mm[i + 1]));
  set_colour(canvas, palette::kBefore);
  cairo_set_line_width(canvas.context.get(),
                       0.6 * before.valve.tissue.thickness_mm * map.pixels_per_mm);
  cairo_stroke(canvas.context.get());
}

/// Native chordae that insert near the plane, whole, and fainter the farther off they insert.
void draw_chordae(const Canvas& canvas, const ClosedValve& closed, const SectionMap& map) {
  const Valve& valve = closed.valve;
  for (std::size_t c = 0; c < valve.chordae.size(); ++c) {
    const Chorda& chorda = valve.chordae[c];
    const int segments = static_cast<int>(chorda.segments.size());
    const bool solved = c < closed.closure.branch_points_mm.size() &&
                        closed.closure.branch_points_mm[c].rows() == segments;
    if (chorda.ruptured || !solved || chorda.kind == ChordaKind::Neochorda) continue;
    const auto end_mm = [&](int segment) -> Vec3 {
      return segment < 0 ? valve.heads[static_cast<std::size_t>(chorda.head)].tip_mm
                         : Vec3(closed.closure.branch_points_mm[c].row(segment).transpose());
    };
    double nearness = 0.0;
    for (int s = 0; s < segments; ++s)
      if (chorda.segments[static_cast<std::size_t>(s)].inserts)
        nearness = std::max(nearness, 1.0 - map.off_plane_mm(end_mm(s)) / kChordaReach_mm);
    if (nearness == 0.0) continue;
    Colour colour = palette::kChorda;
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

void draw_tips(const Canvas& canvas, const Valve& valve, const SectionMap& map, const Box& box) {
  if (valve.heads.empty()) return;
  Vec2 lowest = map(valve.heads.front().tip_mm);
  for (const PapillaryHead& head : valve.heads) {
    const Vec2 at = map(head.tip_mm);
    if (at.y() > lowest.y()) lowest = at;
    fill_circle(canvas, at, 6.0, palette::kPapillary);
  }
  const TextStyle style{13.0, palette::kMuted, Align::Centre};
  const double half_width = 0.5 * text_width(canvas, "papillary tips", style) + 4.0;
  const double x = std::clamp(lowest.x(), box.x + half_width, box.x + box.width - half_width);
  draw_text(canvas, {x, lowest.y() + 24.0}, "papillary tips", style);
}

/// The annular line on the panel.
struct AnnularLine {
  Vec2 saddle_peak, mid_posterior;
  Vec2 along() const { return (mid_posterior - saddle_peak).normalized(); }
  Vec2 foot(const Vec2& point) const {
    return saddle_peak + (point - saddle_peak).dot(along()) * along();
  }
  /// > 0 on the atrial side.
  double above(const Vec2& point) const {
    const Vec2 offset = point - saddle_peak;
    return along().y() * offset.x() - along().x() * offset.y();
  }
};

void draw_height(const Canvas& canvas, const AnnularLine& annulus, const Vec2& point) {
  cairo_t* cairo = canvas.context.get();
  const double dashes[] = {5.0, 5.0};
  cairo_set_dash(cairo, dashes, 2, 0.0);
  cairo_set_line_width(cairo, 1.8);
  set_colour(canvas, palette::kInk);
  line(canvas, annulus.foot(point), point);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
  fill_circle(canvas, point, 4.0, palette::kInk);
}

/// The height of the coaptation point, named above the leaflets, and that of the highest point of
/// the leaflets if it counts as a billow, named under the annular line.
void draw_heights(const Canvas& canvas, const Tenting& tenting,
                  const std::vector<SectionLine>& lines, const AnnularLine& annulus,
                  const SectionMap& map) {
  const TextStyle style{13.0, palette::kInk, Align::Centre, false, 3.0};
  const Vec2 coaptation = map(tenting.coaptation_point_mm);
  const std::string text = tenting.height_mm < -0.05
                               ? (tenting.contact ? "coaptation " : "free edge ") +
                                     fixed(-tenting.height_mm, 1) + " mm above the annulus"
                               : "tenting " + fixed(std::max(0.0, tenting.height_mm), 1) + " mm";
  const double half_width = 0.5 * text_width(canvas, text, style) + 8.0;
  Vec2 highest = annulus.saddle_peak;
  double top = annulus.foot(coaptation).y();
  for (const SectionLine& section : lines)
    for (const Vec3& point_mm : section.points_mm) {
      const Vec2 point = map(point_mm);
      if (annulus.above(point) > annulus.above(highest)) highest = point;
      if (std::abs(point.x() - coaptation.x()) < half_width) top = std::min(top, point.y());
    }
  draw_height(canvas, annulus, coaptation);
  draw_text(canvas, {coaptation.x(), top - 14.0}, text, style);
  const double billow_mm = annulus.above(highest) / map.pixels_per_mm;
  if (billow_mm < kBillow_mm) return;
  draw_height(canvas, annulus, highest);
  draw_text(canvas, annulus.foot(highest) + Vec2(0.0, 20.0),
            "billow " + fixed(billow_mm, 1) + " mm", style);
}

/// What differs between the sections of a closed and an open valve.
using DrawMarks =
    std::function<void(const std::vector<SectionLine>&, const AnnularLine&, const SectionMap&)>;

void draw_section(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
                  const ClosedValve* before, const DrawMarks& draw_marks) {
  if (!closed.closure.closed_mm.allFinite()) return draw_unknown(canvas, frame);
  const Valve& valve = closed.valve;
  const Box& box = frame.box;
  const Vec3 saddle_peak_mm = annulus_position_mm(valve, valve.landmarks.saddle_peak);
  const Vec3 mid_posterior_mm = annulus_position_mm(valve, valve.landmarks.mid_posterior);
  const SectionMap map = section_map(frame, closed);
  const AnnularLine annulus{map(saddle_peak_mm), map(mid_posterior_mm)};
  const SectionPlane plane = mid_valve_plane(valve);
  const std::vector<SectionLine> lines = cut(valve.faces, closed.closure.closed_mm, plane);

  cairo_t* cairo = canvas.context.get();
  cairo_save(cairo);
  cairo_rectangle(cairo, box.x, box.y, box.width, box.height);
  cairo_clip(cairo);
  if (before != nullptr) draw_before(canvas, *before, plane, map);
  draw_chordae(canvas, closed, map);
  draw_tips(canvas, valve, map, box);
  draw_leaflets(canvas, closed, lines, map);
  set_colour(canvas, palette::kAnnulus);
  cairo_set_line_width(cairo, 1.8);
  line(canvas, annulus.saddle_peak, annulus.mid_posterior);
  cairo_stroke(cairo);
  for (const Vec2& end : {annulus.saddle_peak, annulus.mid_posterior})
    fill_circle(canvas, end, 5.0, palette::kAnnulus);
  const RepairSheet repair{canvas, map, map.pixels_per_mm};
  draw_sutures(repair, closed);
  draw_ring_cut(repair, closed, {saddle_peak_mm, mid_posterior_mm});
  draw_opening_cuts(canvas, closed.measure.leak, plane, map);
  draw_marks(lines, annulus, map);
  double left = annulus.saddle_peak.x(), right = annulus.mid_posterior.x();
  for (const SectionLine& section : lines)
    for (const Vec3& point : section.points_mm) {
      left = std::min(left, map(point).x());
      right = std::max(right, map(point).x());
    }
  draw_text(canvas, {left - 14.0, annulus.saddle_peak.y() + 5.0}, "anterior",
            {13.0, palette::kMuted, Align::Right, false, 3.0});
  draw_text(canvas, {right + 14.0, annulus.mid_posterior.y() + 5.0}, "posterior",
            {13.0, palette::kMuted, Align::Left, false, 3.0});
  draw_text(canvas, Vec2(box.x + 0.5 * box.width, box.y + 22.0), "left atrium",
            {14.0, palette::kMuted, Align::Centre});
  draw_text(canvas, Vec2(box.x + box.width - 16.0, box.y + box.height - 18.0), "left ventricle",
            {14.0, palette::kMuted, Align::Right});
  cairo_restore(cairo);
  draw_scale_bar(canvas, frame);
}

}  // namespace

void draw_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& closed,
                       const ClosedValve* before) {
  draw_section(canvas, frame, closed, before,
               [&](const std::vector<SectionLine>& lines, const AnnularLine& annulus,
                   const SectionMap& map) {
                 draw_heights(canvas, measure_tenting(closed.valve, closed.closure.closed_mm),
                              lines, annulus, map);
               });
}

void draw_open_section_view(const Canvas& canvas, const ViewFrame& frame, const ClosedValve& open) {
  draw_section(canvas, frame, open, nullptr,
               [](const std::vector<SectionLine>&, const AnnularLine&, const SectionMap&) {});
}

}  // namespace coapt
