#include "core/metrics/orifice.h"

#include <algorithm>

#include "core/metrics/annulus.h"
#include "core/metrics/raster.h"

namespace coapt {
namespace {

constexpr double kMargin =
    0.025;  // of the width: room for the leaflets' thickness and for billowing

}  // namespace

double orifice_mm2(const Valve& valve, const Points& points_mm, double half_thickness_mm,
                   const ImageSize& size) {
  const AnnulusFrame plane = annulus_frame(valve, AnnulusAxis::Commissures);
  std::vector<Vec2> annulus = annulus_polygon(valve, plane);
  const double area_mm2 = polygon_area(annulus);
  Vec2 low = annulus.front(), high = annulus.front();
  for (const Vec2& point : annulus) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec2 centre_mm = 0.5 * (low + high);
  const double margin_px = kMargin * size.width;
  const double mm_per_pixel = std::max((high - low).x() / (size.width - 2.0 * margin_px),
                                       (high - low).y() / (size.height - 2.0 * margin_px));
  // Row 0 is the top: anterior.
  const auto to_pixels = [&](const Vec2& coordinates_mm) {
    const Vec2 offset = (coordinates_mm - centre_mm) / mm_per_pixel;
    return Vec2(0.5 * size.width + offset.x(), 0.5 * size.height - offset.y());
  };
  for (Vec2& point : annulus) point = to_pixels(point);
  std::vector<Vec2> vertices;
  for (Index v = 0; v < points_mm.rows(); ++v)
    vertices.push_back(to_pixels(project(plane, points_mm.row(v).transpose())));
  std::vector<Triangle> faces;
  for (const auto& face : valve.faces.rowwise())
    faces.push_back({vertices[static_cast<std::size_t>(face[0])],
                     vertices[static_cast<std::size_t>(face[1])],
                     vertices[static_cast<std::size_t>(face[2])]});

  Mask mask{size.width, size.height, std::vector<std::uint8_t>(size.width * size.height, 0)};
  const int all = mark_polygon(mask, annulus);
  cover_triangles(mask, faces, half_thickness_mm / mm_per_pixel);
  return area_mm2 / all *
         static_cast<double>(std::count(mask.pixels.begin(), mask.pixels.end(), 1));
}

double orifice_mm2(const Valve& valve, const Points& points_mm) {
  return orifice_mm2(valve, points_mm, 0.5 * valve.tissue.thickness_mm);
}

}  // namespace coapt
