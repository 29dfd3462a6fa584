#include "core/valve/contour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/valve/mean_point.h"
#include "core/valve/principal_axes.h"

namespace coapt {
namespace {

constexpr int kContourPoints = 720;
constexpr double kAnteriorExponent = 2.6, kPosteriorExponent = 2.2;
constexpr double kAnteriorShare = 0.42;

double signed_power(double base, double exponent) {
  return std::copysign(std::pow(std::abs(base), exponent), base);
}

double projected_area(const Points& contour) {
  double twice = 0.0;
  for (Index i = 0; i < contour.rows(); ++i) {
    const Index j = (i + 1) % contour.rows();
    twice += contour(i, 0) * contour(j, 1) - contour(j, 0) * contour(i, 1);
  }
  return 0.5 * twice;
}

/// Direction of the largest spread of a point cloud about its mean.
Vec3 main_direction(const Points& points, int rank) {
  const Vec3 mean = mean_point(points);
  return principal_axes(points.rowwise() - mean.transpose()).col(rank);
}

}  // namespace

Points generic_annulus_contour(double ap_mm, double al_pm_mm, double saddle_height_mm) {
  Points contour(kContourPoints, 3);
  for (int i = 0; i < kContourPoints; ++i) {
    const double t = 2.0 * std::numbers::pi * i / kContourPoints;
    const bool anterior = std::sin(t) >= 0.0;
    const double exponent = 2.0 / (anterior ? kAnteriorExponent : kPosteriorExponent);
    const double depth = ap_mm * (anterior ? kAnteriorShare : 1.0 - kAnteriorShare);
    const double x = 0.5 * al_pm_mm * signed_power(std::cos(t), exponent);
    const double y = depth * signed_power(std::sin(t), exponent);
    contour.row(i) << x, y, 0.0;
  }
  return with_saddle(contour, saddle_height_mm);
}

Points with_saddle(const Points& planar_mm, double height_mm) {
  Points contour = planar_mm;
  for (Index i = 0; i < contour.rows(); ++i) {
    const double phi = std::atan2(contour(i, 0), contour(i, 1));
    contour(i, 2) = 0.5 * height_mm * std::cos(2.0 * phi);
  }
  return contour.rowwise() - arc_centroid(contour).transpose();
}

Vec3 arc_centroid(const Points& contour_mm) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (Index i = 0; i < contour_mm.rows(); ++i) {
    const Vec3 a = contour_mm.row(i), b = contour_mm.row((i + 1) % contour_mm.rows());
    sum += (b - a).norm() * 0.5 * (a + b);
    total += (b - a).norm();
  }
  return sum / total;
}

MeasuredSkeleton into_valve_frame(const Points& annulus_mm, const Points& tips_mm) {
  const Vec3 origin = arc_centroid(annulus_mm);
  const Vec3 tips_mean = mean_point(tips_mm);
  Vec3 z = main_direction(annulus_mm, 0);
  if (z.dot(tips_mean - origin) > 0.0) z = -z;
  const Points tips_in_plane = tips_mm - tips_mm * z * z.transpose();
  Vec3 x = main_direction(tips_in_plane, 2);
  x = (x - x.dot(z) * z).normalized();
  Vec3 y = z.cross(x);
  const Points centred = annulus_mm.rowwise() - origin.transpose();
  const Eigen::VectorXd across = centred * y;
  const double bulge = across.maxCoeff() + across.minCoeff();  // > 0 if y is the rounder side
  if (bulge + y.dot(tips_mean - origin) > 0.0) {
    x = -x;
    y = -y;
  }
  Eigen::Matrix3d frame;
  frame << x, y, z;
  MeasuredSkeleton skeleton{centred * frame, (tips_mm.rowwise() - origin.transpose()) * frame};
  if (projected_area(skeleton.annulus_mm) < 0.0)
    skeleton.annulus_mm = skeleton.annulus_mm.colwise().reverse().eval();
  return skeleton;
}

ArcLength::ArcLength(const Points& contour_mm) : contour_mm_(contour_mm) {
  length_mm_.push_back(0.0);
  for (Index i = 0; i < contour_mm.rows(); ++i)
    length_mm_.push_back(length_mm_.back() +
                         (contour_mm.row((i + 1) % contour_mm.rows()) - contour_mm.row(i)).norm());
}

Vec3 ArcLength::at(double arc_mm) const {
  const double wrapped = arc_mm - total_mm() * std::floor(arc_mm / total_mm());
  const auto next = std::upper_bound(length_mm_.begin() + 1, length_mm_.end() - 1, wrapped);
  const Index i = next - length_mm_.begin() - 1, j = (i + 1) % contour_mm_.rows();
  const double span = *next - *(next - 1);
  const double share = span > 0.0 ? (wrapped - *(next - 1)) / span : 0.0;
  return contour_mm_.row(i) + share * (contour_mm_.row(j) - contour_mm_.row(i));
}

Vec3 ArcLength::tangent(double arc_mm) const {
  const double reach = 0.01 * total_mm();
  return (at(arc_mm + reach) - at(arc_mm - reach)).normalized();
}

double ArcLength::crossing_mm(bool anterior) const {
  const Index n = contour_mm_.rows();
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    const double a = contour_mm_(i, 0), b = contour_mm_(j, 0);
    if ((contour_mm_(i, 1) > 0.0) != anterior || (a > 0.0) == (b > 0.0)) continue;
    return length_mm_[i] + (length_mm_[i + 1] - length_mm_[i]) * a / (a - b);
  }
  return 0.0;
}

}  // namespace coapt
