#include "core/metrics/rigid_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/valve/principal_axes.h"

namespace coapt {
namespace {

// Of the surface's size: a round that moves no point further. Where the shapes agree, rounds converge quadratically, and
// the next one would move 1e-14.
constexpr double kSettled = 1e-7;
// The same for rounds between which other points pull: they go to and fro without end.
constexpr double kUnsettled = 1e-4;
constexpr double kFree =
    1e-9;  // of the stiffest motion: what no face resists, as sliding along a plane
constexpr double kBetter = 2.0 / 3.0;
constexpr int kMostRises = 10;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Points, the nearest ones to them, and the normals there.
struct Pairs {
  Points from_mm, to_mm, normals;
  double mean_square_mm2 = 0.0;
  double all_mean_square_mm2 = 0.0;  ///< also of the points that do not pull
};

class Rounds {
 public:
  Rounds(const Points& points_mm, const SurfaceTree& surface,
         const std::function<bool()>& cancelled = {})
      : points_mm_(points_mm), surface_(surface), edge_(surface.faces()), cancelled_(cancelled) {
    const Points& all = surface.vertices_mm();
    size_mm_ = std::max(1e-300, (all.colwise().maxCoeff() - all.colwise().minCoeff()).norm());
  }

  SurfaceFit run(const RigidMotion& start, int max_rounds) const {
    SurfaceFit fit{start, std::numeric_limits<double>::infinity(), 0, false};
    std::optional<Pairs> pairs = pairs_at(start);
    if (!pairs) return fit;
    int rises = 0;
    while (fit.rounds < max_rounds && !fit.settled && rises < kMostRises) {
      RigidMotion step = towards_planes(*pairs);
      std::optional<Pairs> next = pairs_at(composed(fit.motion, step));
      if (next && !(next->mean_square_mm2 <= pairs->mean_square_mm2)) {
        step = fit_to_points(pairs->from_mm, pairs->to_mm);
        next = pairs_at(composed(fit.motion, step));
      }
      if (!next) break;
      ++fit.rounds;
      const double way = (moved(pairs->from_mm, step) - pairs->from_mm).rowwise().norm().maxCoeff();
      // Then other points pull than before.
      if (next->mean_square_mm2 > pairs->mean_square_mm2) ++rises;
      fit.settled = way <= (rises < kMostRises ? kSettled : kUnsettled) * size_mm_;
      fit.motion = composed(fit.motion, step);
      pairs = std::move(next);
    }
    fit.rms_mm = std::sqrt(pairs->all_mean_square_mm2);
    return fit;
  }

 private:
  Vec3 normal_of(int face) const {
    const Points& x = surface_.vertices_mm();
    const auto corners = surface_.faces().row(face);
    const Vec3 a = x.row(corners[0]).transpose(), b = x.row(corners[1]).transpose(),
               c = x.row(corners[2]).transpose();
    return (b - a).cross(c - a).normalized();
  }

  /// None once cancelled.
  std::optional<Pairs> pairs_at(const RigidMotion& motion) const {
    const Points at_mm = moved(points_mm_, motion);
    const std::vector<TreePoint> nearest = nearest_to_each(surface_, at_mm, cancelled_);
    if (std::ssize(nearest) < at_mm.rows()) return std::nullopt;
    std::vector<Eigen::Index> inside;
    double sum = 0.0;
    for (Eigen::Index i = 0; i < at_mm.rows(); ++i) {
      const TreePoint& at = nearest[static_cast<std::size_t>(i)];
      sum += at.distance_mm * at.distance_mm;
      if (!edge_.holds(at)) inside.push_back(i);
    }
    // With too few left to hold the shape, all pull.
    if (std::ssize(inside) < std::max<Eigen::Index>(6, at_mm.rows() / 4)) {
      inside.resize(static_cast<std::size_t>(at_mm.rows()));
      for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = static_cast<Eigen::Index>(i);
    }
    Pairs pairs{at_mm(inside, Eigen::all), Points(std::ssize(inside), 3),
                Points(std::ssize(inside), 3), 0.0, sum / static_cast<double>(at_mm.rows())};
    for (std::size_t i = 0; i < inside.size(); ++i) {
      const TreePoint& at = nearest[static_cast<std::size_t>(inside[i])];
      pairs.to_mm.row(static_cast<Eigen::Index>(i)) = at.point_mm.transpose();
      pairs.normals.row(static_cast<Eigen::Index>(i)) = normal_of(at.face).transpose();
    }
    pairs.mean_square_mm2 = (pairs.to_mm - pairs.from_mm).rowwise().squaredNorm().mean();
    return pairs;
  }

  /// The small motion that brings the points nearest to the planes, rotation about their centroid.
  RigidMotion towards_planes(const Pairs& pairs) const {
    const Vec3 centre = pairs.from_mm.colwise().mean().transpose();
    Matrix6 stiffness = Matrix6::Zero();
    Vector6 pull = Vector6::Zero();
    for (Eigen::Index i = 0; i < pairs.from_mm.rows(); ++i) {
      const Vec3 x = pairs.from_mm.row(i).transpose(), n = pairs.normals.row(i).transpose();
      Vector6 row;
      row << (x - centre).cross(n) / size_mm_, n;
      stiffness += row * row.transpose();
      pull += row * n.dot(Vec3(pairs.to_mm.row(i).transpose()) - x);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6> modes(stiffness);
    Vector6 way = modes.eigenvectors().transpose() * pull;
    for (int k = 0; k < 6; ++k) {
      const double resists = modes.eigenvalues()[k];
      way[k] = resists > kFree * modes.eigenvalues()[5] ? way[k] / resists : 0.0;
    }
    way = modes.eigenvectors() * way;
    const Vec3 turn = way.head<3>() / size_mm_;
    RigidMotion step;
    if (turn.norm() > 0.0)
      step.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    step.shift_mm = centre + way.tail<3>() - step.rotation * centre;
    return step;
  }

  const Points& points_mm_;
  const SurfaceTree& surface_;
  SurfaceEdge edge_;
  const std::function<bool()> cancelled_;
  double size_mm_ = 1.0;
};

/// Centroid of a surface, and its principal axes as columns of a rotation, the longest last.
struct Axes {
  Vec3 centre_mm = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

Axes principal_axes(const Points& vertices_mm, const Faces& faces) {
  double area = 0.0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index f = 0; f < faces.rows(); ++f) {
    const Vec3 a = vertices_mm.row(faces(f, 0)).transpose();
    const Vec3 b = vertices_mm.row(faces(f, 1)).transpose();
    const Vec3 c = vertices_mm.row(faces(f, 2)).transpose();
    const double part = 0.5 * (b - a).cross(c - a).norm();
    const Vec3 centre = (a + b + c) / 3.0;
    area += part;
    first += part * centre;
    second += part * centre * centre.transpose();
  }
  Axes axes;
  if (area <= 0.0) return axes;
  axes.centre_mm = first / area;
  axes.rotation = eigensystem(second / area - axes.centre_mm * axes.centre_mm.transpose()).vectors;
  if (axes.rotation.determinant() < 0.0) axes.rotation.col(0) *= -1.0;
  return axes;
}

/// Proper rotations that take axes to axes: the least one up or down, the other two exchanged or not.
std::vector<Eigen::Matrix3d> axis_turns() {
  std::vector<Eigen::Matrix3d> turns;
  for (const double up : {1.0, -1.0})
    for (int quarter = 0; quarter < 4; ++quarter) {
      Eigen::Matrix3d turn =
          Eigen::AngleAxisd(0.5 * std::numbers::pi * quarter, Vec3::UnitX()).toRotationMatrix();
      turn *= Vec3(up, 1.0, up).asDiagonal();
      turns.push_back(turn);
    }
  return turns;
}

/// Every so many rows, so that about `count` are left.
Points thinned(const Points& points, Eigen::Index count) {
  const Eigen::Index step = std::max<Eigen::Index>(1, points.rows() / count);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < points.rows(); i += step) rows.push_back(i);
  return points(rows, Eigen::all);
}

}  // namespace

Points moved(const Points& points_mm, const RigidMotion& motion) {
  return (points_mm * motion.rotation.transpose()).rowwise() + motion.shift_mm.transpose();
}

RigidMotion composed(const RigidMotion& first, const RigidMotion& second) {
  return {second.rotation * first.rotation, second.rotation * first.shift_mm + second.shift_mm};
}

double rotation_deg(const RigidMotion& motion) {
  return Eigen::AngleAxisd(motion.rotation).angle() * 180.0 / std::numbers::pi;
}

RigidMotion fit_to_points(const Points& from_mm, const Points& to_mm) {
  const Vec3 from = from_mm.colwise().mean().transpose(), to = to_mm.colwise().mean().transpose();
  const Eigen::Matrix3d both =
      (from_mm.rowwise() - from.transpose()).transpose() * (to_mm.rowwise() - to.transpose());
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double hand = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  RigidMotion motion;
  motion.rotation = svd.matrixV() * Vec3(1.0, 1.0, hand).asDiagonal() * svd.matrixU().transpose();
  motion.shift_mm = to - motion.rotation * from;
  return motion;
}

SurfaceFit fit_to_surface(const Points& points_mm, const SurfaceTree& surface,
                          const RigidMotion& start, int max_rounds) {
  return Rounds(points_mm, surface).run(start, max_rounds);
}

SurfaceFit fit_mesh_to_surface(const Points& vertices_mm, const Faces& faces,
                               const SurfaceTree& surface, const std::function<bool()>& cancelled) {
  constexpr Eigen::Index kTrialPoints = 300;
  constexpr int kTrialRounds = 30;
  const Points few = thinned(vertices_mm, kTrialPoints);
  const Rounds trial(few, surface, cancelled);
  SurfaceFit best = trial.run({}, kTrialRounds);
  double bar = kBetter * best.rms_mm;
  const Axes ours = principal_axes(vertices_mm, faces);
  const Axes theirs = principal_axes(surface.vertices_mm(), surface.faces());
  for (const Eigen::Matrix3d& turn : axis_turns()) {
    RigidMotion start{theirs.rotation * turn * ours.rotation.transpose(), Vec3::Zero()};
    start.shift_mm = theirs.centre_mm - start.rotation * ours.centre_mm;
    const SurfaceFit other = trial.run(start, kTrialRounds);
    if (!(other.rms_mm < bar)) continue;
    best = other;
    bar = other.rms_mm;
  }
  return Rounds(vertices_mm, surface, cancelled).run(best.motion, kMostRounds);
}

}  // namespace coapt
