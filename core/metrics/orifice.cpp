#include "core/metrics/orifice.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "core/metrics/projection.h"

namespace coapt {
namespace {

constexpr double kMargin =
    0.025;  // of the width: room for the leaflets' thickness and for billowing

/// Maximal runs of set pixels, in reading order; `orifice` is their own index.
std::vector<PixelRun> runs_of(const Mask& mask) {
  std::vector<PixelRun> runs;
  for (int row = 0; row < mask.height; ++row) {
    const std::uint8_t* begin = mask.pixels.data() + row * mask.width;
    const std::uint8_t* end = begin + mask.width;
    const auto find = [end](const std::uint8_t* from, int value) {
      const void* found = std::memchr(from, value, end - from);
      return found ? static_cast<const std::uint8_t*>(found) : end;
    };
    for (const std::uint8_t* first = find(begin, 1); first != end;) {
      const std::uint8_t* after = find(first, 0);
      runs.push_back({row, static_cast<int>(first - begin), static_cast<int>(after - begin) - 1,
                      static_cast<int>(runs.size())});
      first = find(after, 1);
    }
  }
  return runs;
}

/// Replaces `orifice` by the index of the first run of the same connected region.
void connect(std::vector<PixelRun>& runs) {
  const auto root = [&runs](int run) {
    while (runs[run].orifice != run) run = runs[run].orifice;
    return run;
  };
  std::size_t above = 0;
  for (std::size_t here = 0; here < runs.size(); ++here) {
    const auto precedes = [&](const PixelRun& run) {
      return run.row < runs[here].row - 1 ||
             (run.row == runs[here].row - 1 && run.last < runs[here].first);
    };
    while (precedes(runs[above])) ++above;
    for (std::size_t i = above; runs[i].row < runs[here].row && runs[i].first <= runs[here].last;
         ++i) {
      const int a = root(static_cast<int>(i)), b = root(static_cast<int>(here));
      runs[std::max(a, b)].orifice = std::min(a, b);
    }
  }
  for (PixelRun& run : runs) run.orifice = root(run.orifice);
}

/// The annulus drawn white, before any leaflet.
struct Bitmap {
  OrificeView view;
  Mask mask;
};

Bitmap draw_annulus(const Projection& projection, const ImageSize& size) {
  Bitmap sheet;
  OrificeView& view = sheet.view;
  view.width = size.width;
  view.height = size.height;
  view.plane = projection.plane;
  std::vector<Vec2> annulus = projection.annulus;
  const double area_mm2 = polygon_area(annulus);
  Vec2 low = annulus.front(), high = annulus.front();
  for (const Vec2& point : annulus) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  view.centre_mm = 0.5 * (low + high);
  const double margin_px = kMargin * view.width;
  view.mm_per_pixel = std::max((high - low).x() / (view.width - 2.0 * margin_px),
                               (high - low).y() / (view.height - 2.0 * margin_px));
  sheet.mask = {view.width, view.height, std::vector<std::uint8_t>(view.width * view.height, 0)};
  for (Vec2& point : annulus) point = to_pixels(view, point);
  view.pixel_area_mm2 = area_mm2 / mark_polygon(sheet.mask, annulus);
  return sheet;
}

/// What the leaflets leave open of the sheet, without its orifices.
OrificeView draw_leaflets(Bitmap&& sheet, const Projection& projection, double half_thickness_mm) {
  OrificeView& view = sheet.view;
  std::vector<Triangle> faces_px = projection.faces;
  for (Triangle& face : faces_px)
    for (Vec2& corner : face) corner = to_pixels(view, corner);
  cover_triangles(sheet.mask, faces_px, half_thickness_mm / view.mm_per_pixel);
  view.runs = runs_of(sheet.mask);
  return std::move(view);
}

/// Turns the runs of `view` into orifices, largest first.
void collect_orifices(const Valve& valve, const Projection& projection, OrificeView& view) {
  connect(view.runs);
  struct Region {
    int first_run = 0;
    double pixels = 0.0;
    Vec2 sum_px = Vec2::Zero();
  };
  std::vector<Region> regions;
  std::vector<std::size_t> region_of_run(view.runs.size());
  for (std::size_t i = 0; i < view.runs.size(); ++i) {
    const PixelRun& run = view.runs[i];
    if (run.orifice == static_cast<int>(i)) {
      region_of_run[i] = regions.size();
      regions.push_back({run.orifice});
    }
    region_of_run[i] = region_of_run[run.orifice];
    Region& region = regions[region_of_run[i]];
    const double pixels = run.last - run.first + 1;
    region.pixels += pixels;
    region.sum_px += pixels * Vec2(0.5 * (run.first + run.last + 1), run.row + 0.5);
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Region& a, const Region& b) { return a.pixels > b.pixels; });
  std::vector<int> orifice_of_first_run(view.runs.size(), 0);
  for (const Region& region : regions) {
    orifice_of_first_run[region.first_run] = static_cast<int>(view.orifices.size());
    const Vec2 centroid_mm = from_pixels(view, region.sum_px / region.pixels);
    view.orifices.push_back({region.pixels * view.pixel_area_mm2,
                             unproject(view.plane, centroid_mm),
                             nearest_segment(valve, projection, centroid_mm)});
  }
  for (PixelRun& run : view.runs) run.orifice = orifice_of_first_run[run.orifice];
}

}  // namespace

Vec2 to_pixels(const OrificeView& view, const Vec2& coordinates_mm) {
  const Vec2 offset = (coordinates_mm - view.centre_mm) / view.mm_per_pixel;
  return {0.5 * view.width + offset.x(), 0.5 * view.height - offset.y()};
}

Vec2 from_pixels(const OrificeView& view, const Vec2& pixels) {
  return view.centre_mm +
         view.mm_per_pixel * Vec2(pixels.x() - 0.5 * view.width, 0.5 * view.height - pixels.y());
}

OrificeView view_orifices(const Valve& valve, const Points& closed_mm, double half_thickness_mm,
                          const ImageSize& size) {
  const Projection projection =
      project_valve(valve, closed_mm, annulus_frame(valve, AnnulusAxis::Commissures));
  OrificeView view = draw_leaflets(draw_annulus(projection, size), projection, half_thickness_mm);
  collect_orifices(valve, projection, view);
  return view;
}

}  // namespace coapt
