#include "io/picture/import_paint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace coapt {
namespace {

constexpr double kOuterThirds = 0.22;  // of the way to white, as on the page

std::vector<PaintedFace> tinted_faces(const Drawing& drawing, const TintedMesh& mesh) {
  const Eye& eye = drawing.eye;
  const Vec3 lamp = (0.5 * eye.up - 0.4 * eye.right + 0.8 * eye.towards).normalized();
  std::vector<PaintedFace> painted(static_cast<std::size_t>(mesh.faces.rows()));
  for (std::size_t f = 0; f < painted.size(); ++f) {
    std::array<Vec3, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] =
          mesh.vertices_mm.row(mesh.faces(static_cast<Eigen::Index>(f), k)).transpose();
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const double light = 0.68 + 0.32 * std::abs(normal.dot(lamp));
    for (std::size_t k = 0; k < 3; ++k) {
      const int vertex = mesh.faces(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k));
      const Colour& bare = mesh.colours[static_cast<std::size_t>(vertex)];
      painted[f].depth_mm -= corners[k].dot(eye.towards) / 3.0;
      painted[f].corners[k] = drawing.place(corners[k]);
      painted[f].colours[k] = {light * bare.red, light * bare.green, light * bare.blue};
    }
  }
  return painted;
}

}  // namespace

Colour mixed(const Colour& a, const Colour& b, double share) {
  return {std::lerp(a.red, b.red, share), std::lerp(a.green, b.green, share),
          std::lerp(a.blue, b.blue, share)};
}

Colour segment_colour(Segment segment) {
  switch (segment) {
    case Segment::A1:
    case Segment::A3:
      return mixed(palette::kAnterior, palette::kPaper, kOuterThirds);
    case Segment::A2:
      return palette::kAnterior;
    case Segment::P1:
    case Segment::P3:
      return mixed(palette::kPosterior, palette::kPaper, kOuterThirds);
    case Segment::P2:
      return palette::kPosterior;
    case Segment::AC:
    case Segment::PC:
      break;
  }
  return palette::kCommissure;
}

void paint_meshes(const Drawing& drawing, const std::vector<TintedMesh>& meshes) {
  std::vector<PaintedFace> all;
  for (const TintedMesh& mesh : meshes) {
    const std::vector<PaintedFace> faces = tinted_faces(drawing, mesh);
    all.insert(all.end(), faces.begin(), faces.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const PaintedFace& a, const PaintedFace& b) {
    return a.depth_mm > b.depth_mm;
  });
  paint_leaflets(drawing.canvas, all);
}

void paint_strokes(const Drawing& drawing, const std::vector<Stroke>& strokes) {
  cairo_t* cairo = drawing.canvas.context.get();
  Colour colour = palette::kChorda;
  colour.alpha = 0.7;
  set_colour(drawing.canvas, colour);
  cairo_set_line_width(cairo, 1.3);
  for (const Stroke& stroke : strokes) {
    const Vec2 from = drawing.place(stroke.from_mm), to = drawing.place(stroke.to_mm);
    cairo_move_to(cairo, from.x(), from.y());
    cairo_line_to(cairo, to.x(), to.y());
  }
  cairo_stroke(cairo);
}

void paint_loop(const Drawing& drawing, const Points& loop_mm) {
  cairo_t* cairo = drawing.canvas.context.get();
  set_colour(drawing.canvas, palette::kAnnulus);
  cairo_set_line_width(cairo, 2.5);
  for (const auto point : loop_mm.rowwise()) {
    const Vec2 at = drawing.place(point.transpose());
    cairo_line_to(cairo, at.x(), at.y());
  }
  cairo_close_path(cairo);
  cairo_stroke(cairo);
}

void paint_marks(const Drawing& drawing, const std::vector<NamedPoint>& marks,
                 const Colour& colour) {
  constexpr double kLine = 15.0;
  std::vector<Box> placed;
  for (const NamedPoint& mark : marks) {
    const Vec2 at = drawing.place(mark.at_mm);
    fill_circle(drawing.canvas, at, 5.0, colour);
    fill_circle(drawing.canvas, at, 3.0, palette::kPaper);
    if (mark.words.empty()) continue;
    const Vec2 outwards = at - drawing.map.centre_px;
    const bool upright = std::abs(outwards.x()) < 0.35 * outwards.norm();
    const Align align = upright ? Align::Centre : outwards.x() > 0.0 ? Align::Left : Align::Right;
    const TextStyle style{13.0, palette::kInk, align, false, 3.0};
    const double width = text_width(drawing.canvas, mark.words, style);
    Vec2 from = at + Vec2(upright              ? 0.0
                          : outwards.x() > 0.0 ? 9.0
                                               : -9.0,
                          upright ? (outwards.y() > 0.0 ? 20.0 : -10.0) : 5.0);
    const auto box_of = [&](const Vec2& base) {
      const double left = base.x() - (align == Align::Right    ? width
                                      : align == Align::Centre ? 0.5 * width
                                                               : 0.0);
      return Box{left, base.y() - kLine, width, kLine};
    };
    const auto is_covered = [&](const Box& box) {
      return std::any_of(placed.begin(), placed.end(), [&](const Box& other) {
        return box.x < other.x + other.width && other.x < box.x + box.width &&
               std::abs(box.y - other.y) < kLine;
      });
    };
    for (int lines = 0; lines < 8 && is_covered(box_of(from)); ++lines) from.y() += kLine;
    placed.push_back(box_of(from));
    draw_text(drawing.canvas, from, mark.words, style);
  }
}

void paint_segment_names(const Drawing& drawing, const Valve& valve) {
  for (const Segment segment :
       {Segment::A1, Segment::A2, Segment::A3, Segment::P1, Segment::P2, Segment::P3}) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
      if (valve.segments[static_cast<std::size_t>(f)] != segment) continue;
      for (int k = 0; k < 3; ++k) sum += valve.rest_mm.row(valve.faces(f, k)).transpose();
      count += 3;
    }
    if (count > 0)
      draw_text(drawing.canvas, drawing.place(sum / count) + Vec2(0.0, 5.0), to_string(segment),
                {14.0, {0.35, 0.16, 0.12}, Align::Centre, true, 1.8});
  }
}

}  // namespace coapt
