#include "core/valve/parametric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/valve/dimension_table.h"
#include "core/valve/measured_skeleton.h"
#include "core/valve/parametric_chordae.h"
#include "core/valve/pressure_unit.h"
#include "core/valve/problem_list.h"

namespace coapt {
namespace {

constexpr double kHumanAp_mm = 29.0, kHumanAlPm_mm = 39.0;  // controls, PMC7368231
constexpr double kPlanar_mm = 0.5;         // a contour less high than this is a projection
constexpr double kCommissureAlong = 0.07;  // share of a leaflet's arc that counts as commissure

struct Grid {
  int stations = 0, anterior_stations = 0, rows = 0;
};

/// The structured mesh nearest to the aimed number of triangles, stations about nine times the rows
/// (the shape of the thesis's valves: edges of 2 to 4 mm at 650 triangles), all counts symmetric.
Grid choose_grid(const ParametricValve& d) {
  Grid best;
  double best_cost = 1e300;
  for (int rows = 3; rows <= 80; ++rows)
    for (int stations = 24; stations <= 800; stations += 2) {
      const double ratio = static_cast<double>(stations) / rows;
      if (ratio < 6.0 || ratio > 12.0) continue;
      const double off = std::abs(2.0 * rows * stations / d.triangles - 1.0);
      const double cost = off + 0.2 * std::abs(std::log(ratio / 9.0));
      if (cost < best_cost) {
        best_cost = cost;
        best = {stations,
                2 * std::max(1, static_cast<int>(std::lround(0.5 * stations * d.anterior_arc))),
                rows};
      }
    }
  return best;
}

/// Cosine interpolation through (position, value) knots.
template <std::size_t N>
double interpolate(const std::array<std::pair<double, double>, N>& knots, double at) {
  for (std::size_t i = 0; i + 1 < N; ++i) {
    if (at > knots[i + 1].first) continue;
    const double t = (at - knots[i].first) / (knots[i + 1].first - knots[i].first);
    const double blend = 0.5 - 0.5 * std::cos(std::numbers::pi * t);
    return knots[i].second + blend * (knots[i + 1].second - knots[i].second);
  }
  return knots[N - 1].second;
}

double symmetric_height_mm(const Proportions& d, double cleft_depth_mm, double around) {
  if (around <= 0.5) {
    const double lobe = std::sin(2.0 * std::numbers::pi * around);
    return d.commissure_height_mm + (d.anterior_height_mm - d.commissure_height_mm) * lobe;
  }
  const double cleft = std::min(d.posterior_height_mm, d.lateral_height_mm) - cleft_depth_mm;
  const std::array<std::pair<double, double>, 7> knots = {{{0.0, d.commissure_height_mm},
                                                           {0.17, d.lateral_height_mm},
                                                           {0.33, cleft},
                                                           {0.5, d.posterior_height_mm},
                                                           {0.67, cleft},
                                                           {0.83, d.lateral_height_mm},
                                                           {1.0, d.commissure_height_mm}}};
  return interpolate(knots, 2.0 * (around - 0.5));
}

double leaflet_height_mm(const ParametricValve& d, const Proportions& heights, double around) {
  const double medial =
      std::cos(2.0 * std::numbers::pi * around);  // 1 at the posteromedial commissure
  return (1.0 + d.asymmetry.leaflet_height * medial) *
         symmetric_height_mm(heights, d.cleft_depth_mm, around);
}

/// Inwards from the vertical; over the quarter of the annulus about each commissure one leaflet's becomes the other's.
double inclination_rad(const ParametricValve& d, double around) {
  const double front = std::clamp(2.0 * std::sin(2.0 * std::numbers::pi * around), -1.0, 1.0);
  const double deg =
      d.posterior_inclination_deg +
      (0.5 + 0.5 * front) * (d.anterior_inclination_deg - d.posterior_inclination_deg);
  return deg * std::numbers::pi / 180.0;
}

Segment segment_at(double around) {
  const bool anterior = around < 0.5;
  const double along = anterior ? 1.0 - 2.0 * around : 2.0 * (around - 0.5);  // from anterolateral
  if (along < kCommissureAlong) return Segment::AC;
  if (along > 1.0 - kCommissureAlong) return Segment::PC;
  const int third = std::min(2, static_cast<int>(3.0 * along));
  constexpr std::array<Segment, 3> front = {Segment::A1, Segment::A2, Segment::A3};
  constexpr std::array<Segment, 3> back = {Segment::P1, Segment::P2, Segment::P3};
  return anterior ? front[third] : back[third];
}

/// Stations: arc position and `around` of each, counter-clockwise from the posteromedial
/// commissure.
struct Station {
  double arc_mm = 0.0, around = 0.0;
};

std::vector<Station> place_stations(const ArcLength& arc, const ParametricValve& d,
                                    const Grid& grid) {
  const double total = arc.total_mm(), peak = arc.crossing_mm(true);
  const double half_front = 0.5 * d.anterior_arc * total;
  double back = arc.crossing_mm(false);
  while (back < peak) back += total;
  const std::array<double, 5> knots = {peak - half_front, peak, peak + half_front, back,
                                       peak - half_front + total};
  const int front = grid.anterior_stations / 2, rear = (grid.stations - grid.anterior_stations) / 2;
  const std::array<int, 4> counts = {front, front, rear, rear};
  std::vector<Station> stations;
  for (std::size_t q = 0; q < 4; ++q)
    for (int i = 0; i < counts[q]; ++i) {
      const double t = static_cast<double>(i) / counts[q];
      stations.push_back(
          {knots[q] + t * (knots[q + 1] - knots[q]), 0.25 * (static_cast<double>(q) + t)});
    }
  return stations;
}

constexpr double kFoldHalf_mm = 1.9, kFoldDepth = 0.67;  // to either side; share of the height

/// How high the folds stand at the free edge by each station, inwards: a triangle along the annulus about the borders of scallops,
/// two stations wide at least.
std::vector<double> folds_mm(const ParametricValve& d, const std::vector<Station>& stations,
                             double total_mm) {
  const double half = std::max(kFoldHalf_mm, total_mm / static_cast<double>(stations.size()));
  std::vector<double> folds(stations.size(), 0.0);
  for (const auto& [around, height] :
       {std::pair{1.0 / 6.0, d.anterior_fold_mm}, std::pair{1.0 / 3.0, d.anterior_fold_mm},
        std::pair{2.0 / 3.0, -d.posterior_fold_mm}, std::pair{5.0 / 6.0, -d.posterior_fold_mm}}) {
    std::size_t after = 1;
    while (after + 1 < stations.size() && stations[after].around < around) ++after;
    const Station &a = stations[after - 1], &b = stations[after];
    const double border =
        a.arc_mm + (around - a.around) / (b.around - a.around) * (b.arc_mm - a.arc_mm);
    for (std::size_t i = 0; i < stations.size(); ++i)
      folds[i] += height * std::max(0.0, 1.0 - std::abs(stations[i].arc_mm - border) / half);
  }
  return folds;
}

/// "440 measured points of annulus.csv"
std::string measured(const Points& points_mm, const std::string& source) {
  return std::to_string(points_mm.rows()) + " measured points" +
         (source.empty() ? "" : " of " + source);
}

std::string rounded(double mm) { return shown(std::round(100.0 * mm) / 100.0); }

std::vector<std::string> provenance(const ParametricValve& d, const Proportions& heights,
                                    bool saddle_added) {
  if (!d.annulus_mm) return {"parametric valve made by coapt from anatomical dimensions"};
  std::string annulus = "annulus: " + measured(*d.annulus_mm, d.annulus_source);
  if (saddle_added)
    annulus += ", planar; saddle of " + rounded(heights.saddle_height_mm) + " mm added by coapt";
  return {"parametric valve made by coapt on a measured annulus", annulus,
          "papillary tips: " + measured(*d.tips_mm, d.tips_source),
          "leaflets: not measured; heights " + rounded(heights.anterior_height_mm) + " (A2), " +
              rounded(heights.posterior_height_mm) + " (P2), " +
              rounded(heights.lateral_height_mm) + " (P1, P3), " +
              rounded(heights.commissure_height_mm) + " mm (commissures)"};
}

}  // namespace

Proportions proportions(const ParametricValve& d, double ap_mm, double al_pm_mm) {
  const Proportions human;
  const double ap = ap_mm / kHumanAp_mm, across = al_pm_mm / kHumanAlPm_mm;
  return {d.saddle_height_mm.value_or(across * human.saddle_height_mm),
          d.anterior_height_mm.value_or(ap * human.anterior_height_mm),
          d.posterior_height_mm.value_or(ap * human.posterior_height_mm),
          d.lateral_height_mm.value_or(across * human.lateral_height_mm),
          d.commissure_height_mm.value_or(across * human.commissure_height_mm)};
}

Errors check_dimensions(const ParametricValve& d) {
  ProblemList problems;
  for (const Dimension& dimension : dimension_table())
    if (const std::optional<double> value = dimension.get(d))
      check_range(problems, '/' + std::string(dimension.name), *value, dimension.accepted,
                  dimension.unit);
  check_range(problems, "/triangles", d.triangles, {100, 50000});
  if (d.annulus_mm.has_value() != d.tips_mm.has_value())
    problems.add(ErrorCode::MissingField, d.annulus_mm ? "/tips_mm" : "/annulus_mm",
                 "a measured annulus and measured tips come together");
  if (d.annulus_mm && (d.annulus_mm->rows() < 12 || !d.annulus_mm->allFinite()))
    problems.add(ErrorCode::OutOfRange, "/annulus_mm", "accepted: 12 or more finite points");
  if (d.tips_mm && (d.tips_mm->rows() < 2 || !d.tips_mm->allFinite()))
    problems.add(ErrorCode::OutOfRange, "/tips_mm", "accepted: 2 or more finite points");
  return std::move(problems).take();
}

Expected<Valve> make_parametric_valve(const ParametricValve& d) {
  if (Errors errors = check_dimensions(d); !errors.empty()) return errors;
  const Grid grid = choose_grid(d);
  Proportions heights = proportions(d, d.ap_mm, d.al_pm_mm);
  Points contour = generic_annulus_contour(d.ap_mm, d.al_pm_mm, heights.saddle_height_mm);
  Points tips(2, 3);
  const Vec3& more = d.asymmetry.tip_mm;
  tips << -0.5 * d.tip_spread_mm + more.x(), more.y() - d.tip_posterior_mm,
      more.z() - d.tip_depth_mm, 0.5 * d.tip_spread_mm + more.x(), -more.y() - d.tip_posterior_mm,
      -more.z() - d.tip_depth_mm;
  bool saddle_added = false;
  if (d.annulus_mm) {
    const Expected<MeasuredSkeleton> skeleton = measured_skeleton(*d.annulus_mm, *d.tips_mm);
    if (!skeleton) return skeleton.errors();
    contour = skeleton->annulus_mm;
    const ArcLength flat(contour);
    const double ap = (flat.at(flat.crossing_mm(true)) - flat.at(flat.crossing_mm(false))).norm();
    heights = proportions(d, ap, contour.col(0).maxCoeff() - contour.col(0).minCoeff());
    const bool planar = contour.col(2).maxCoeff() - contour.col(2).minCoeff() < kPlanar_mm;
    if (!planar && d.saddle_height_mm)
      return Error{ErrorCode::OutOfRange, "/saddle_height_mm",
                   "the measured annulus has its own height; accepted with a planar one only"};
    saddle_added = planar && heights.saddle_height_mm > 0.0;
    if (saddle_added) contour = with_saddle(contour, heights.saddle_height_mm);
    tips = skeleton->tips_mm;
  }
  const ArcLength arc(contour);
  const std::vector<Station> stations = place_stations(arc, d, grid);

  Valve valve;
  valve.name = d.name;
  valve.tissue = d.tissue;
  valve.systole = d.systole;
  if (d.pressure_mmhg) valve.pressure_kpa = *d.pressure_mmhg / kMmhgPerKpa;
  valve.provenance = provenance(d, heights, saddle_added);
  const int n = grid.stations;
  const std::vector<double> folds = folds_mm(d, stations, arc.total_mm());
  valve.rest_mm.resize(n * (grid.rows + 1), 3);
  for (int row = 0; row <= grid.rows; ++row)
    for (int i = 0; i < n; ++i) {
      const Station& s = stations[i];
      const Vec3 tangent = arc.tangent(s.arc_mm);
      const Vec3 inwards = Vec3(-tangent.y(), tangent.x(), 0.0).normalized();
      const double share = static_cast<double>(row) / grid.rows;
      const double tilt = inclination_rad(d, s.around);
      const Vec3 down = std::sin(tilt) * inwards - std::cos(tilt) * Vec3::UnitZ();
      const Vec3 across = std::cos(tilt) * inwards + std::sin(tilt) * Vec3::UnitZ();
      const double fold = folds[static_cast<std::size_t>(i)] *
                          std::max(0.0, (share - 1.0 + kFoldDepth) / kFoldDepth);
      valve.rest_mm.row(row * n + i) =
          arc.at(s.arc_mm) + share * leaflet_height_mm(d, heights, s.around) * down + fold * across;
    }
  valve.faces.resize(2 * n * grid.rows, 3);
  valve.fibre.resize(valve.faces.rows(), 3);
  for (int row = 0, f = 0; row < grid.rows; ++row)
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      const int a = row * n + i, b = row * n + next, c = a + n, e = b + n;
      const bool falling = (i + row) % 2 == 0;  // alternating diagonals: nearly isotropic springs
      valve.faces.row(f) << a, b, falling ? c : e;
      valve.faces.row(f + 1) << (falling ? b : a), e, c;
      valve.fibre.row(f) = (valve.rest_mm.row(b) - valve.rest_mm.row(a)).normalized();
      valve.fibre.row(f + 1) = (valve.rest_mm.row(e) - valve.rest_mm.row(c)).normalized();
      const double around = stations[i].around;
      const double beyond = next == 0 ? 1.0 : stations[next].around;
      valve.segments.insert(valve.segments.end(), 2, segment_at(0.5 * (around + beyond)));
      f += 2;
    }
  valve.annulus_mm.resize(n, 3);
  for (int i = 0; i < n; ++i) {
    valve.annulus.push_back(i);
    valve.annulus_mm.row(i) = valve.rest_mm.row(i);
  }
  const int front = grid.anterior_stations / 2;
  const int trigone = static_cast<int>(std::lround(d.trigone_share * front));
  valve.landmarks = {
      front + trigone, front - trigone, front, 2 * front + (n - 2 * front) / 2, 2 * front, 0};
  std::vector<double> around(stations.size());
  std::transform(stations.begin(), stations.end(), around.begin(),
                 [](const Station& s) { return s.around; });
  add_parametric_chordae({n, grid.rows, around}, tips, valve);
  return valve;
}

}  // namespace coapt
