#include "io/picture/distance_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "io/picture/import_paint.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kMapDense = 2.0;  // pixels a unit, for print
constexpr int kMapWidth = 1100, kMapHeight = 640;
constexpr double kMapEdge = 32.0, kMapTop = 96.0, kMapScaleHeight = 78.0;

constexpr Colour kBlue{0.13, 0.35, 0.71}, kWhite{0.95, 0.94, 0.92}, kRed{0.75, 0.15, 0.13};

/// `share`: distance over range; beyond -1 and 1 the colour stays.
Colour colour_of(double share) {
  return share < 0.0 ? mixed(kWhite, kBlue, std::min(1.0, -share))
                     : mixed(kWhite, kRed, std::min(1.0, share));
}

/// `side` 1: from where the normals point; -1: from behind.
Eye eye_of(const DistanceMap& map, double side) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (Eigen::Index f = 0; f < map.faces.rows(); ++f) {
    const Vec3 a = map.vertices_mm.row(map.faces(f, 0)).transpose();
    const Vec3 b = map.vertices_mm.row(map.faces(f, 1)).transpose();
    const Vec3 c = map.vertices_mm.row(map.faces(f, 2)).transpose();
    sum += (b - a).cross(c - a);
    area += (b - a).cross(c - a).norm();
  }
  Eye eye;
  eye.towards = sum.norm() > 0.05 * area ? Vec3(sum.normalized()) : Vec3::UnitZ();
  const Vec3 upwards = std::abs(eye.towards.y()) < 0.9 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
  eye.up = (upwards - upwards.dot(eye.towards) * eye.towards).normalized();
  eye.towards *= side;
  eye.right = eye.up.cross(eye.towards);
  return eye;
}

std::vector<PaintedFace> faces_seen(const DistanceMap& map, const Eye& eye, const Mapping& to_px) {
  std::vector<PaintedFace> painted(static_cast<std::size_t>(map.faces.rows()));
  for (std::size_t f = 0; f < painted.size(); ++f) {
    const auto row = static_cast<Eigen::Index>(f);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = map.vertices_mm.row(map.faces(row, static_cast<Eigen::Index>(k))).transpose();
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Vec3 lamp = (0.5 * eye.up - 0.4 * eye.right + 0.8 * eye.towards).normalized();
    const double light = 0.62 + 0.38 * std::abs(normal.dot(lamp));
    for (std::size_t k = 0; k < 3; ++k) {
      const int vertex = map.faces(row, static_cast<Eigen::Index>(k));
      painted[f].depth_mm -= corners[k].dot(eye.towards) / 3.0;
      painted[f].corners[k] = to_px({corners[k].dot(eye.right), corners[k].dot(eye.up)});
      const Colour bare = colour_of(map.signed_mm[static_cast<std::size_t>(vertex)] / map.range_mm);
      painted[f].colours[k] = {light * bare.red, light * bare.green, light * bare.blue};
    }
  }
  std::stable_sort(painted.begin(), painted.end(), [](const PaintedFace& a, const PaintedFace& b) {
    return a.depth_mm > b.depth_mm;
  });
  return painted;
}

void draw_side(const Canvas& canvas, const DistanceMap& map, const Eye& eye, const Box& box,
               const char* words) {
  Eigen::AlignedBox2d extent;
  for (Eigen::Index i = 0; i < map.vertices_mm.rows(); ++i)
    extent.extend(Vec2(map.vertices_mm.row(i).dot(eye.right), map.vertices_mm.row(i).dot(eye.up)));
  const Vec2 size = extent.sizes().cwiseMax(1e-9);
  const double px = std::min(box.width / size.x(), box.height / size.y());
  const Mapping to_px{extent.center(), {box.x + 0.5 * box.width, box.y + 0.5 * box.height}, px};
  paint_leaflets(canvas, faces_seen(map, eye, to_px));
  draw_text(canvas, {box.x + 0.5 * box.width, box.y - 10.0}, words,
            {14.0, palette::kMuted, Align::Centre});
}

void draw_colours(const Canvas& canvas, const DistanceMap& map) {
  constexpr double kLength = 420.0, kThick = 14.0;
  constexpr int kSteps = 210;
  const double left = 0.5 * (kMapWidth - kLength), top = kMapHeight - kMapScaleHeight + 22.0;
  for (int i = 0; i < kSteps; ++i)
    fill_box(canvas, {left + kLength * i / kSteps, top, kLength / kSteps + 0.5, kThick},
             colour_of(2.0 * (i + 0.5) / kSteps - 1.0));
  const int decimals =
      map.range_mm >= 10.0
          ? 0
          : std::max(0, static_cast<int>(std::ceil(0.99 - std::log10(map.range_mm))));
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
    draw_text(canvas, {left + 0.5 * kLength * (share + 1.0), top + kThick + 18.0},
              (share > 0.0 ? "+" : "") + fixed(share * map.range_mm, decimals),
              {13.0, palette::kMuted, Align::Centre});
  draw_text(canvas, {left + kLength + 40.0, top + kThick}, "mm from the reference",
            {13.0, palette::kMuted});
}

}  // namespace

double round_range_mm(double p95_mm) {
  double range = 1e-3;
  for (const double factor :
       {2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0, 2.0, 2.5, 2.0}) {
    if (range >= p95_mm) break;
    range *= factor;
  }
  return range;
}

std::string distance_map_png(const DistanceMap& map) {
  const Canvas canvas = make_canvas(kMapWidth, kMapHeight, kMapDense);
  fill_box(canvas, {0.0, 0.0, kMapWidth, kMapHeight}, palette::kPaper);
  draw_text(canvas, {kMapEdge, 38.0}, map.title, {19.0, palette::kInk, Align::Left, true},
            kMapWidth - 2.0 * kMapEdge);
  draw_text(canvas, {kMapEdge, 62.0}, map.caption, {14.0, palette::kMuted},
            kMapWidth - 2.0 * kMapEdge);
  draw_text(canvas, {kMapEdge, 16.0}, map.doubt, {13.0, palette::kWarning, Align::Left, true},
            kMapWidth - 2.0 * kMapEdge);
  const double width = 0.5 * (kMapWidth - 3.0 * kMapEdge),
               height = kMapHeight - kMapTop - kMapScaleHeight;
  draw_side(canvas, map, eye_of(map, 1.0), {kMapEdge, kMapTop, width, height},
            "from the side of the normals (coapt: the atrium)");
  draw_side(canvas, map, eye_of(map, -1.0), {2.0 * kMapEdge + width, kMapTop, width, height},
            "from behind (coapt: the ventricle)");
  draw_colours(canvas, map);
  return to_png(canvas);
}

}  // namespace coapt
