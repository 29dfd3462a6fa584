#include "io/picture/leaflet_paint.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/metrics/leaflet_sides.h"

namespace coapt {
namespace {

constexpr double kDarkest_mm =
    16.0;  // depth below the annular plane from where on it gets no darker

/// Light that reaches each vertex: of a lamp above the anterolateral side, less of it the deeper.
std::vector<double> light_of(const Valve& valve, const Points& closed_mm,
                             const AnnulusFrame& plane) {
  Points normals = Points::Zero(closed_mm.rows(), 3);
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    const Vec3 a = closed_mm.row(valve.faces(f, 0)).transpose();
    const Vec3 b = closed_mm.row(valve.faces(f, 1)).transpose();
    const Vec3 c = closed_mm.row(valve.faces(f, 2)).transpose();
    const Vec3 normal = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k) normals.row(valve.faces(f, k)) += normal.transpose();
  }
  const Vec3 lamp = (-0.45 * plane.x + 0.55 * plane.y + 0.70 * plane.normal).normalized();
  std::vector<double> light;
  for (Eigen::Index v = 0; v < closed_mm.rows(); ++v) {
    const double depth_mm = (plane.origin_mm - closed_mm.row(v).transpose()).dot(plane.normal);
    const double open_sky = 1.0 - 0.48 * std::clamp(depth_mm / kDarkest_mm, 0.0, 1.0);
    const double facing = Vec3(normals.row(v).transpose()).normalized().dot(lamp);
    light.push_back((0.42 + 0.62 * std::max(0.0, facing)) * open_sky);
  }
  return light;
}

Colour lit(const Colour& tint, double light) {
  return {std::min(1.0, tint.red * light), std::min(1.0, tint.green * light),
          std::min(1.0, tint.blue * light)};
}

}  // namespace

std::vector<PaintedFace> painted_faces(const Valve& valve, const Points& closed_mm,
                                       const AnnulusFrame& plane, const Mapping& map) {
  const std::vector<Leaflet> sides = leaflet_sides(valve);
  const std::vector<double> light = light_of(valve, closed_mm, plane);
  std::vector<PaintedFace> faces(sides.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Colour& tint = sides[f] == Leaflet::Anterior ? palette::kAnterior : palette::kPosterior;
    for (std::size_t k = 0; k < 3; ++k) {
      const int vertex = valve.faces(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k));
      const Vec3 point = closed_mm.row(vertex).transpose();
      faces[f].depth_mm -= (point - plane.origin_mm).dot(plane.normal) / 3.0;
      faces[f].corners[k] = map(project(plane, point));
      faces[f].colours[k] = lit(tint, light[static_cast<std::size_t>(vertex)]);
    }
  }
  std::stable_sort(faces.begin(), faces.end(), [](const PaintedFace& a, const PaintedFace& b) {
    return a.depth_mm > b.depth_mm;
  });
  return faces;
}

void paint_rims(const Canvas& canvas, const std::vector<PaintedFace>& faces, double thickness_px) {
  constexpr double kShadow = 0.8;
  cairo_t* cairo = canvas.context.get();
  cairo_set_line_width(cairo, thickness_px);
  for (const PaintedFace& face : faces) {
    for (const Vec2& corner : face.corners) cairo_line_to(cairo, corner.x(), corner.y());
    cairo_close_path(cairo);
    set_colour(canvas, lit(face.colours[0], kShadow));
    cairo_stroke(cairo);
  }
}

void paint_leaflets(const Canvas& canvas, const std::vector<PaintedFace>& faces) {
  cairo_pattern_t* mesh = cairo_pattern_create_mesh();
  for (const PaintedFace& face : faces) {
    cairo_mesh_pattern_begin_patch(mesh);
    cairo_mesh_pattern_move_to(mesh, face.corners[0].x(), face.corners[0].y());
    cairo_mesh_pattern_line_to(mesh, face.corners[1].x(), face.corners[1].y());
    cairo_mesh_pattern_line_to(mesh, face.corners[2].x(), face.corners[2].y());
    for (unsigned k = 0; k < 4; ++k) {  // a patch has four corners, here the last is the first
      const Colour& colour = face.colours[k % 3];
      cairo_mesh_pattern_set_corner_color_rgb(mesh, k, colour.red, colour.green, colour.blue);
    }
    cairo_mesh_pattern_end_patch(mesh);
  }
  cairo_set_source(canvas.context.get(), mesh);
  cairo_paint(canvas.context.get());
  cairo_pattern_destroy(mesh);
}

}  // namespace coapt
