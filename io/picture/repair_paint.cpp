// Told apart without colour, too: the ring is a stitched band, the annulus before thin dashes, sutures
// long dashes, neochordae dots, ties bars with two ends, seams short dashes.
#include "io/picture/repair_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {
namespace {

constexpr double kRingThickness_mm = 2.2;  // about that of a cloth-covered ring
constexpr double kTipRadius = 6.0;

struct Stroke {
  Colour colour;
  double width = 1.0, dash = 0.0, gap = 0.0;  // no dash: solid
};

void stroke(const Canvas& canvas, const Stroke& style) {
  cairo_t* cairo = canvas.context.get();
  const std::array dashes = {style.dash, style.gap};
  if (style.dash > 0.0) cairo_set_dash(cairo, dashes.data(), 2, 0.0);
  set_colour(canvas, style.colour);
  cairo_set_line_width(cairo, style.width);
  cairo_stroke(cairo);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
}

void draw_line(const Canvas& canvas, const Vec2& from, const Vec2& to, const Stroke& style) {
  cairo_move_to(canvas.context.get(), from.x(), from.y());
  cairo_line_to(canvas.context.get(), to.x(), to.y());
  stroke(canvas, style);
}

/// On a rim of paper, that it is seen on tissue.
void draw_thread(const Canvas& canvas, const Vec2& from, const Vec2& to, const Stroke& style) {
  Colour rim = palette::kPaper;
  rim.alpha = 0.75;
  draw_line(canvas, from, to, {rim, style.width + 3.0});
  draw_line(canvas, from, to, style);
}

constexpr Stroke kBeforeStroke = {palette::kMuted, 1.8, 6.0, 5.0};
constexpr Stroke kSutureStroke = {palette::kAdded, 3.0, 10.0, 6.0};
constexpr Stroke kTieStroke = {palette::kAdded, 4.5};
constexpr Stroke kSeamStroke = {palette::kAdded, 2.2, 4.0, 4.0};
constexpr Stroke kNeochordaStroke = {palette::kAdded, 3.2, 0.1, 6.0};  // round ends: dots

/// `trace` adds the path, as often as it is called.
template <class Trace>
void draw_band(const Canvas& canvas, double thickness, const Trace& trace) {
  trace();
  stroke(canvas, {palette::kAnnulus, thickness});
  trace();
  stroke(canvas, {palette::kRing, std::max(1.0, thickness - 3.0)});
  trace();
  stroke(canvas, {palette::kMuted, 1.2, 3.0, 5.0});
}

void draw_cut_ring(const Canvas& canvas, const Vec2& at, double radius) {
  fill_circle(canvas, at, radius, palette::kAnnulus);
  fill_circle(canvas, at, radius - 1.8, palette::kRing);
}

void draw_tip(const Canvas& canvas, const Vec2& at, bool before) {
  fill_circle(canvas, at, kTipRadius + 1.5, palette::kPaper);
  fill_circle(canvas, at, kTipRadius, palette::kPapillary);
  if (before) fill_circle(canvas, at, kTipRadius - 2.0, palette::kPaper);
}

/// From the hollow circle of before to the full one of after.
void draw_way(const Canvas& canvas, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  if (way.norm() > 2.5 * kTipRadius) {
    const Vec2 along = way.normalized(), aside(-along.y(), along.x());
    const Vec2 head = to - (kTipRadius + 2.0) * along;
    draw_thread(canvas, from, head, {palette::kPapillary, 1.8});
    for (const double side : {-1.0, 1.0})
      draw_line(canvas, head, head - 7.0 * along + side * 4.5 * aside, {palette::kPapillary, 1.8});
  }
  draw_tip(canvas, from, true);
  draw_tip(canvas, to, false);
}

void draw_tie(const Canvas& canvas, const Vec2& from, const Vec2& to) {
  draw_thread(canvas, from, to, kTieStroke);
  for (const Vec2& end : {from, to}) {
    fill_circle(canvas, end, 5.0, palette::kPaper);
    fill_circle(canvas, end, 3.8, palette::kAdded);
  }
}

struct Thread {
  Vec3 head_mm, leaflet_mm;
};

/// Intact neochordae, from head to leaflet.
std::vector<Thread> neochordae(const ClosedValve& closed) {
  std::vector<Thread> threads;
  const Valve& valve = closed.valve;
  for (const Chorda& chorda : valve.chordae) {
    if (chorda.kind != ChordaKind::Neochorda || chorda.ruptured) continue;
    const Vec3 head_mm = valve.heads[static_cast<std::size_t>(chorda.head)].tip_mm;
    for (const ChordaSegment& segment : chorda.segments)
      if (segment.inserts)
        threads.push_back(
            {head_mm, position(segment.insertion, valve.faces, closed.closure.closed_mm)});
  }
  return threads;
}

/// Of the ties in closed leaflets; leaflets that they hold lie a leaflet's thickness apart.
std::vector<std::array<Vec3, 2>> ties_mm(const ClosedValve& closed) {
  const auto at = [&](const Insertion& end) {
    return position(end, closed.valve.faces, closed.closure.closed_mm);
  };
  std::vector<std::array<Vec3, 2>> ties;
  for (const Tie& tie : closed.valve.ties) ties.push_back({at(tie.anterior), at(tie.posterior)});
  return ties;
}

bool has_ring(const ClosedValve& closed) { return closed.repair.annulus_before_mm.rows() > 0; }

struct Sign {
  const char* words;
  void (*draw)(const Canvas& canvas,
               const Vec2& left);  // 28 px wide, about its middle line; or null
};

const Sign kLeakSign = {"Blue: leak", nullptr}, kOpeningSign = {"Blue: opening", nullptr};
const Sign kRingSign = {"annuloplasty ring", [](const Canvas& canvas, const Vec2& left) {
                          draw_band(canvas, 10.0, [&] {
                            cairo_move_to(canvas.context.get(), left.x() + 5.0, left.y());
                            cairo_line_to(canvas.context.get(), left.x() + 23.0, left.y());
                          });
                        }};
const Sign kBeforeSign = {"annulus before", [](const Canvas& canvas, const Vec2& left) {
                            draw_line(canvas, left, left + Vec2(28.0, 0.0), kBeforeStroke);
                          }};
const Sign kSutureSign = {"papillary suture", [](const Canvas& canvas, const Vec2& left) {
                            draw_line(canvas, left, left + Vec2(28.0, 0.0), kSutureStroke);
                          }};
const Sign kTipSign = {"papillary tip, moved", [](const Canvas& canvas, const Vec2& left) {
                         draw_way(canvas, left + Vec2(4.0, 0.0), left + Vec2(24.0, 0.0));
                       }};
const Sign kNeochordaSign = {"neochorda", [](const Canvas& canvas, const Vec2& left) {
                               draw_line(canvas, left, left + Vec2(28.0, 0.0), kNeochordaStroke);
                             }};

const Sign kTieSign = {"edge-to-edge ties", [](const Canvas& canvas, const Vec2& left) {
                         draw_tie(canvas, left + Vec2(9.0, 0.0), left + Vec2(19.0, 0.0));
                       }};
const Sign kSeamSign = {"seam of a resection", [](const Canvas& canvas, const Vec2& left) {
                          draw_line(canvas, left, left + Vec2(28.0, 0.0), kSeamStroke);
                        }};

std::vector<Sign> signs_of(const std::vector<const ClosedValve*>& valves) {
  const auto any = [&](const auto& test) {
    return std::any_of(valves.begin(), valves.end(),
                       [&](const ClosedValve* closed) { return test(*closed); });
  };
  std::vector<Sign> signs;
  if (any([](const ClosedValve& c) { return !c.measure.leak.openings.empty(); }))
    signs.push_back(valves.front()->valve.pressure_kpa < 0.0 ? kOpeningSign : kLeakSign);
  if (any(has_ring)) signs.insert(signs.end(), {kRingSign, kBeforeSign});
  if (any([](const ClosedValve& c) { return !c.repair.sutures.empty(); }))
    signs.insert(signs.end(), {kSutureSign, kTipSign});
  if (any([](const ClosedValve& c) {
        return c.closure.closed_mm.allFinite() && !neochordae(c).empty();
      }))
    signs.push_back(kNeochordaSign);
  if (any([](const ClosedValve& c) { return !c.valve.ties.empty(); })) signs.push_back(kTieSign);
  if (any([](const ClosedValve& c) { return !c.repair.seams.empty(); })) signs.push_back(kSeamSign);
  return signs;
}

}  // namespace

void draw_ring(const RepairSheet& sheet, const ClosedValve& closed) {
  if (!has_ring(closed)) return;
  const auto trace = [&sheet](const Points& loop_mm) {
    for (Eigen::Index i = 0; i < loop_mm.rows(); ++i) {
      const Vec2 at = sheet.place(loop_mm.row(i).transpose());
      cairo_line_to(sheet.canvas.context.get(), at.x(), at.y());
    }
    cairo_close_path(sheet.canvas.context.get());
  };
  trace(closed.repair.annulus_before_mm);
  stroke(sheet.canvas, kBeforeStroke);
  draw_band(sheet.canvas, kRingThickness_mm * sheet.pixels_per_mm,
            [&] { trace(closed.valve.annulus_mm); });
}

void draw_ring_cut(const RepairSheet& sheet, const ClosedValve& closed,
                   const std::array<Vec3, 2>& at_mm) {
  if (!has_ring(closed)) return;
  for (const Vec3& point : at_mm)
    draw_cut_ring(sheet.canvas, sheet.place(point),
                  std::max(5.0, 0.5 * kRingThickness_mm * sheet.pixels_per_mm));
}

void draw_sutures(const RepairSheet& sheet, const ClosedValve& closed) {
  for (const Thread& thread : neochordae(closed)) {
    const Vec2 head = sheet.place(thread.head_mm), leaflet = sheet.place(thread.leaflet_mm);
    draw_thread(sheet.canvas, head, leaflet, kNeochordaStroke);
    draw_tip(sheet.canvas, head, false);
    fill_circle(sheet.canvas, leaflet, 5.0, palette::kPaper);
    fill_circle(sheet.canvas, leaflet, 3.8, palette::kAdded);
  }
  for (const auto& [from_mm, to_mm] : ties_mm(closed))
    draw_tie(sheet.canvas, sheet.place(from_mm), sheet.place(to_mm));
  for (const SutureMark& suture : closed.repair.sutures) {
    const Vec2 tip = sheet.place(suture.tip_mm), anchor = sheet.place(suture.anchor_mm);
    draw_thread(sheet.canvas, tip, anchor, kSutureStroke);
    fill_box(sheet.canvas, {anchor.x() - 6.5, anchor.y() - 6.5, 13.0, 13.0}, palette::kPaper);
    fill_box(sheet.canvas, {anchor.x() - 5.0, anchor.y() - 5.0, 10.0, 10.0}, palette::kAdded);
    draw_way(sheet.canvas, sheet.place(suture.tip_before_mm), tip);
    const bool al = suture.side == Side::Anterolateral;  // outwards, so that the two stay apart
    draw_text(sheet.canvas, tip + Vec2(al ? -kTipRadius - 6.0 : kTipRadius + 6.0, 5.0),
              al ? "AL tip" : "PM tip",
              {13.0, palette::kPapillary, al ? Align::Right : Align::Left, true, 3.0});
  }
}

void draw_seams(const RepairSheet& sheet, const ClosedValve& closed) {
  for (const std::vector<Insertion>& seam : closed.repair.seams)
    for (const bool rim : {true, false}) {
      for (const Insertion& point : seam) {
        const Vec2 at = sheet.place(position(point, closed.valve.faces, closed.closure.closed_mm));
        cairo_line_to(sheet.canvas.context.get(), at.x(), at.y());
      }
      stroke(sheet.canvas, rim ? Stroke{palette::kPaper, kSeamStroke.width + 2.5} : kSeamStroke);
    }
}

void draw_legend(const Canvas& canvas, const Vec2& at, double width,
                 const std::vector<const ClosedValve*>& valves) {
  constexpr double kLine = 22.0, kBetween = 22.0;
  const TextStyle style{13.0};
  double x = 0.0, y = 0.5 * kLine;
  for (const Sign& sign : signs_of(valves)) {
    const double before_words = sign.draw != nullptr ? 36.0 : 0.0;
    const double taken = before_words + text_width(canvas, sign.words, style);
    if (x > 0.0 && x + taken > width) x = 0.0, y += kLine;
    if (sign.draw != nullptr) sign.draw(canvas, at + Vec2(x, y));
    draw_text(canvas, at + Vec2(x + before_words, y + 4.5), sign.words, style);
    x += taken + kBetween;
  }
}

}  // namespace coapt
