// Leaflets so simple that every measure is known by hand: discs, grids with holes, extruded
// profiles.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "core/closure/closure.h"
#include "core/valve/valve.h"

namespace coapt {

namespace sheets {

inline void set_rows(Points& points, const std::vector<Vec3>& rows) {
  points.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
}

inline void set_faces(Valve& valve, const std::vector<std::array<int, 3>>& faces) {
  valve.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  valve.fibre.resize(valve.faces.rows(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto row = static_cast<Eigen::Index>(f);
    valve.faces.row(row) << faces[f][0], faces[f][1], faces[f][2];
    valve.fibre.row(row) << 1.0, 0.0, 0.0;
  }
}

inline void set_annulus(Valve& valve, const std::vector<int>& loop) {
  valve.annulus = loop;
  valve.annulus_mm = valve.rest_mm(loop, Eigen::all);
  const auto most = [&](const Vec3& direction) {
    Eigen::Index best = 0;
    (valve.annulus_mm * direction).maxCoeff(&best);
    return loop[static_cast<std::size_t>(best)];
  };
  Landmarks& marks = valve.landmarks;
  marks.posteromedial_commissure = most({1.0, -1e-3, 0.0});
  marks.anterolateral_commissure = most({-1.0, -1e-3, 0.0});
  marks.saddle_peak = most({0.0, 1.0, 0.0});
  marks.mid_posterior = most({0.0, -1.0, 0.0});
  marks.posteromedial_trigone = most({1.0, 2.0, 0.0});
  marks.anterolateral_trigone = most({-1.0, 2.0, 0.0});
}

/// Thirds of each leaflet by x, leaflets by the sign of y.
inline void set_segments(Valve& valve, double half_width_mm) {
  for (Eigen::Index f = 0; f < valve.faces.rows(); ++f) {
    Vec3 centre = Vec3::Zero();
    for (int k = 0; k < 3; ++k) centre += valve.rest_mm.row(valve.faces(f, k)).transpose() / 3.0;
    const int third = centre.x() < -half_width_mm / 3.0  ? 0
                      : centre.x() < half_width_mm / 3.0 ? 1
                                                         : 2;
    const int first = static_cast<int>(centre.y() > 0.0 ? Segment::A1 : Segment::P1);
    valve.segments.push_back(static_cast<Segment>(first + third));
  }
}

}  // namespace sheets

/// A flat disc with a round hole in the middle: polygons of `n` corners.
inline Valve disc_with_hole(double radius_mm, double hole_radius_mm, int n = 128, int rings = 6) {
  Valve valve;
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> faces;
  std::vector<int> loop;
  for (int ring = 0; ring <= rings; ++ring)
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n;
      const double r = std::lerp(radius_mm, hole_radius_mm, static_cast<double>(ring) / rings);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
      if (ring == 0) loop.push_back(i);
      if (ring == rings) continue;
      const int next = (i + 1) % n;
      faces.push_back({ring * n + i, ring * n + next, (ring + 1) * n + next});
      faces.push_back({ring * n + i, (ring + 1) * n + next, (ring + 1) * n + i});
    }
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  sheets::set_annulus(valve, loop);
  sheets::set_segments(valve, radius_mm);
  return valve;
}

/// A flat sheet on the grid lines xs, ys (ascending), without the cells (i, j) that `is_hole`.
inline Valve grid_sheet(const std::vector<double>& xs, const std::vector<double>& ys,
                        const std::function<bool(int, int)>& is_hole) {
  Valve valve;
  const int nx = static_cast<int>(xs.size()), ny = static_cast<int>(ys.size());
  std::vector<Vec3> points;
  for (const double y : ys)
    for (const double x : xs) points.emplace_back(x, y, 0.0);
  std::vector<std::array<int, 3>> faces;
  for (int j = 0; j + 1 < ny; ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      if (is_hole(i, j)) continue;
      const int corner = j * nx + i;
      faces.push_back({corner, corner + 1, corner + nx + 1});
      faces.push_back({corner, corner + nx + 1, corner + nx});
    }
  std::vector<int> loop;
  for (int i = 0; i + 1 < nx; ++i) loop.push_back(i);
  for (int j = 0; j + 1 < ny; ++j) loop.push_back(j * nx + nx - 1);
  for (int i = nx - 1; i > 0; --i) loop.push_back((ny - 1) * nx + i);
  for (int j = ny - 1; j > 0; --j) loop.push_back(j * nx);
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  sheets::set_annulus(valve, loop);
  sheets::set_segments(valve, xs.back());
  return valve;
}

/// Two leaflets that are the same in every section: profiles in (y, z) from the annulus to the free
/// edge, drawn out from x = -15 to 15 mm. The commissures are two more annulus vertices at (-15, 0,
/// 0), (15, 0, 0).
inline Valve extruded_leaflets(const std::vector<Eigen::Vector2d>& anterior,
                               const std::vector<Eigen::Vector2d>& posterior) {
  constexpr int kColumns = 11;
  Valve valve;
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> faces;
  const auto extrude = [&](const std::vector<Eigen::Vector2d>& profile, bool flip,
                           Segment segment) {
    const int first = static_cast<int>(points.size());
    const int rows = static_cast<int>(profile.size());
    for (int i = 0; i < kColumns; ++i)
      for (const Eigen::Vector2d& point : profile)
        points.emplace_back(-15.0 + 3.0 * i, point.x(), point.y());
    for (int i = 0; i + 1 < kColumns; ++i)
      for (int j = 0; j + 1 < rows; ++j) {
        const int a = first + i * rows + j, b = a + 1, c = a + rows, d = c + 1;
        if (flip) {
          faces.push_back({a, b, c});
          faces.push_back({b, d, c});
        } else {
          faces.push_back({a, c, b});
          faces.push_back({b, c, d});
        }
        valve.segments.insert(valve.segments.end(), 2, segment);
      }
    return first;
  };
  const int anterior_first = extrude(anterior, true, Segment::A2);
  const int posterior_first = extrude(posterior, false, Segment::P2);
  std::vector<int> loop{static_cast<int>(points.size())};
  points.emplace_back(15.0, 0.0, 0.0);
  for (int i = kColumns - 1; i >= 0; --i)
    loop.push_back(anterior_first + i * static_cast<int>(anterior.size()));
  loop.push_back(static_cast<int>(points.size()));
  points.emplace_back(-15.0, 0.0, 0.0);
  for (int i = 0; i < kColumns; ++i)
    loop.push_back(posterior_first + i * static_cast<int>(posterior.size()));
  sheets::set_rows(valve.rest_mm, points);
  sheets::set_faces(valve, faces);
  sheets::set_annulus(valve, loop);
  valve.landmarks.posteromedial_commissure = loop.front();
  valve.landmarks.anterolateral_commissure = loop[kColumns + 1];
  valve.landmarks.saddle_peak = loop[1 + kColumns / 2];
  valve.landmarks.mid_posterior = loop[kColumns + 2 + kColumns / 2];
  return valve;
}

/// Anterior: a wall 20 mm deep at y = d. Posterior: a shelf at z = -12 that ends in a wall at y = 0
/// from there to z = -20, so that the walls face each other over 8 mm at distance d.
inline Valve facing_walls(double d) {
  return extruded_leaflets({{d, 0.0}, {d, -7.0}, {d, -20.0}},
                           {{-9.0, 0.0}, {-9.0, -12.0}, {0.0, -12.0}, {0.0, -20.0}});
}

/// The same valve elsewhere.
inline Valve moved(Valve valve, const Eigen::Isometry3d& motion) {
  const auto move = [&](Points& points) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) = (motion * Vec3(points.row(i).transpose())).transpose();
  };
  move(valve.rest_mm);
  move(valve.annulus_mm);
  for (Eigen::Index f = 0; f < valve.fibre.rows(); ++f)
    valve.fibre.row(f) = (motion.linear() * valve.fibre.row(f).transpose()).transpose();
  return valve;
}

/// Left and right exchanged: x becomes -x, and the loop and the faces run the other way.
inline Valve mirrored(Valve valve) {
  valve.rest_mm.col(0) *= -1.0;
  valve.fibre.col(0) *= -1.0;
  valve.faces.col(1).swap(valve.faces.col(2));
  std::reverse(valve.annulus.begin(), valve.annulus.end());
  valve.annulus_mm = valve.annulus_mm.colwise().reverse().eval();
  valve.annulus_mm.col(0) *= -1.0;
  std::swap(valve.landmarks.anterolateral_commissure, valve.landmarks.posteromedial_commissure);
  std::swap(valve.landmarks.anterolateral_trigone, valve.landmarks.posteromedial_trigone);
  for (Segment& segment : valve.segments) {
    constexpr std::array<Segment, 8> kOther = {Segment::A3, Segment::A2, Segment::A1, Segment::P3,
                                               Segment::P2, Segment::P1, Segment::PC, Segment::AC};
    segment = kOther[static_cast<std::size_t>(segment)];
  }
  return valve;
}

/// The valve closed in its rest shape.
inline ClosureResult closed_at_rest(const Valve& valve) {
  ClosureResult closure;
  closure.status = ClosureStatus::Converged;
  closure.closed_mm = valve.rest_mm;
  closure.samples_mm.assign(2, valve.rest_mm);
  return closure;
}

}  // namespace coapt
