#include "lab/closures/gap_study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/closure/closure.h"
#include "core/metrics/gap.h"
#include "core/metrics/measure.h"
#include "core/presets/presets.h"
#include "core/valve/remodel.h"

namespace coapt {
namespace {

constexpr double kThickness_mm = 1.0;
constexpr double kHalfLength_mm = 15.0, kDepth_mm = 20.0;  // of a sheet
constexpr double kWidest_mm = 3.0;                         // of the gap, in the middle
constexpr double kHalfSlit_mm = 11.0;                      // beyond, the sheets touch
constexpr double kPressed_mm = 0.2;                        // by which they are nearer there
constexpr double kCurvature_per_mm = 0.03;                 // across the slit
constexpr double kSlope = 0.3;                             // of the oblique slit: 17 degrees
constexpr double kRadius_mm = 18.0;                        // of the crescent

double width_mm(double along_mm) {
  const double share = along_mm / kHalfSlit_mm;
  return std::max(-kPressed_mm, kWidest_mm * (1.0 - share * share));
}

/// Where a point of the unit square, (-1 to 1) x (0 to 1), of a side lies.
using Shape = std::function<Vec3(double, double)>;

struct KnownGap {
  std::string name;
  Shape anterior, posterior;
  double area_mm2 = 0.0;
};

/// Integral over the slit, by Simpson's rule; densities are the width times the mean length of both borders.
double over_slit(const std::function<double(double)>& density) {
  constexpr int kPieces = 2000;
  const double step = 2.0 * kHalfSlit_mm / kPieces;
  double sum = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const double x = -kHalfSlit_mm + step * i;
    sum += step / 6.0 * (density(x) + 4.0 * density(x + 0.5 * step) + density(x + step));
  }
  return sum;
}

double slope_of_width(double along_mm) {
  return -2.0 * kWidest_mm * along_mm / (kHalfSlit_mm * kHalfSlit_mm);
}

KnownGap oblique_slit() {
  // The slit's own axes: `along` and `across` it, turned in the plane y = 0.
  const double cosine = 1.0 / std::hypot(1.0, kSlope), sine = kSlope * cosine;
  const Shape plane = [](double u, double v) {
    return Vec3(kHalfLength_mm * u, 0.0, -kDepth_mm * v);
  };
  const Shape sheet = [=](double u, double v) {
    Vec3 point = plane(u, v);
    const double x = point.x(), z = point.z() + 0.5 * kDepth_mm;
    const double along = cosine * x + sine * z, across = cosine * z - sine * x;
    point.y() = kThickness_mm + width_mm(along) + kCurvature_per_mm * across * across;
    return point;
  };
  return {"oblique slit", sheet, plane, over_slit([](double along) {
            return width_mm(along) * 0.5 * (1.0 + std::hypot(1.0, slope_of_width(along)));
          })};
}

KnownGap crescent() {
  const auto on_cylinder = [](double u, double v, double inwards_mm) {
    const double angle = kHalfLength_mm * u / kRadius_mm, r = kRadius_mm - inwards_mm;
    return Vec3(r * std::sin(angle), -r * std::cos(angle), -kDepth_mm * v);
  };
  const Shape sheet = [=](double u, double v) {
    const double across = kDepth_mm * (v - 0.55);
    return on_cylinder(
        u, v, kThickness_mm + width_mm(kHalfLength_mm * u) + kCurvature_per_mm * across * across);
  };
  const Shape cylinder = [=](double u, double v) { return on_cylinder(u, v, 0.0); };
  return {"crescent", sheet, cylinder, over_slit([](double along) {
            const double r = kRadius_mm - kThickness_mm - width_mm(along);
            return width_mm(along) * 0.5 *
                   (1.0 + std::hypot(r / kRadius_mm, slope_of_width(along)));
          })};
}

/// Two sheets, each of `columns` x `rows` quads cut by diagonals in turn.
Valve two_sheets(const KnownGap& known, int triangles) {
  const int rows = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / 6.0))));
  const int columns = static_cast<int>(std::lround(triangles / (4.0 * rows)));
  Valve valve;
  const int vertices = (columns + 1) * (rows + 1);
  valve.rest_mm.resize(2 * vertices, 3);
  valve.faces.resize(4 * columns * rows, 3);
  valve.tissue.thickness_mm = kThickness_mm;
  Index face = 0;
  for (const bool anterior : {true, false}) {
    const int first = anterior ? 0 : vertices;
    const auto vertex = [&](int i, int j) { return first + i * (rows + 1) + j; };
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; j <= rows; ++j)
        valve.rest_mm.row(vertex(i, j)) = (anterior ? known.anterior : known.posterior)(
            2.0 * i / columns - 1.0, static_cast<double>(j) / rows);
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1);
        const int d = vertex(i, j + 1);
        const bool turned = (i + j) % 2 == 1;
        valve.faces.row(face++) << a, b, turned ? d : c;
        valve.faces.row(face++) << (turned ? b : a), c, d;
      }
  }
  const auto half = static_cast<std::size_t>(valve.faces.rows() / 2);
  valve.segments.assign(half, Segment::A2);
  valve.segments.insert(valve.segments.end(), half, Segment::P2);
  // The upper edges are the annulus; its landmarks are the ends and middles of these.
  for (int i = columns; i >= 0; --i) valve.annulus.push_back(i * (rows + 1));
  for (int i = 0; i <= columns; ++i) valve.annulus.push_back(vertices + i * (rows + 1));
  valve.annulus_mm = valve.rest_mm(valve.annulus, Eigen::all);
  valve.landmarks.anterolateral_commissure = vertices;
  valve.landmarks.posteromedial_commissure = vertices + columns * (rows + 1);
  valve.landmarks.saddle_peak = columns / 2 * (rows + 1);
  valve.landmarks.mid_posterior = vertices + columns / 2 * (rows + 1);
  return valve;
}

double of_sections_mm2(const Valve& valve, const Coaptation& coaptation) {
  const double spacing_mm =
      (coaptation_plane(valve, 0.2).point_mm - coaptation_plane(valve, 0.1).point_mm).norm();
  double area_mm2 = 0.0;
  for (const CoaptationSection& section : coaptation.sections)
    if (!section.contact)
      area_mm2 += spacing_mm * std::max(0.0, section.distance_mm - valve.tissue.thickness_mm);
  return area_mm2;
}

GapPoint measured(const std::string& scene, const Valve& valve, const Points& closed_mm) {
  GapPoint point;
  point.scene = scene;
  point.triangles = static_cast<int>(valve.faces.rows());
  point.sections_mm2 = of_sections_mm2(valve, measure_coaptation(valve, closed_mm));
  point.orifice_mm2 = std::numeric_limits<double>::quiet_NaN();
  point.microseconds = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    point.gap_mm2 = measure_gap(valve, closed_mm).area_mm2;
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - start;
    point.microseconds = std::min(point.microseconds, passed.count());
  }
  return point;
}

struct ClosureScene {
  const char* preset;
  double ap_dilation_percent;
};

constexpr ClosureScene kClosures[] = {{"human-p2-prolapse", 0.0},    {"human-functional-mr", 0.0},
                                      {"human-functional-mr", 10.0}, {"human-normal", 0.0},
                                      {"human-normal", 20.0},        {"porcine-thesis", 0.0}};

std::string name_of(const ClosureScene& scene) {
  const int percent = static_cast<int>(scene.ap_dilation_percent);
  return std::string(scene.preset) + (percent ? " +" + std::to_string(percent) + " %" : "");
}

}  // namespace

std::vector<GapPoint> study_gap(const GapStudyOptions& options,
                                const std::function<void(int, int)>& progress) {
  const int planned = static_cast<int>(2 * options.surface_triangles.size() +
                                       std::size(kClosures) * options.closure_triangles.size());
  std::vector<GapPoint> points;
  const auto add = [&](GapPoint point) {
    points.push_back(std::move(point));
    if (progress) progress(static_cast<int>(points.size()), planned);
  };
  for (const KnownGap& known : {oblique_slit(), crescent()})
    for (const int triangles : options.surface_triangles) {
      const Valve valve = two_sheets(known, triangles);
      GapPoint point = measured(known.name, valve, valve.rest_mm);
      point.expected_mm2 = known.area_mm2;
      add(std::move(point));
    }
  for (const ClosureScene& scene : kClosures) {
    const std::size_t first = points.size();
    for (const int triangles : options.closure_triangles) {
      Remodelling change;
      change.ap_dilation_percent = scene.ap_dilation_percent;
      const Valve valve = *remodel(*make_preset(scene.preset, triangles), change);
      const ClosureResult closure = close_valve(valve);
      GapPoint point = measured(name_of(scene), valve, closure.closed_mm);
      point.orifice_mm2 = measure_orifice(valve, closure).area_mm2;
      add(std::move(point));
    }
    for (std::size_t i = first; i < points.size(); ++i)
      points[i].expected_mm2 = points.back().gap_mm2;
  }
  return points;
}

}  // namespace coapt
