#include "core/closure/exponential.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

/// I1 and what it depends on; q1 and q2 are half its gradient by f1 and f2.
struct Invariant {
  Vec3 q1, q2;
  double length1 = 0.0, length2 = 0.0;
  double area = 1.0;  // present over unstressed
  double over = 0.0;  // I1 - 3
};

Invariant invariant(const Sheet& sheet, const Points& x) {
  const Vec3 a = x.row(sheet.node[0]);
  const Vec3 ab = x.row(sheet.node[1]).transpose() - a, ac = x.row(sheet.node[2]).transpose() - a;
  const Vec3 f1 = sheet.per_mm(0, 0) * ab + sheet.per_mm(1, 0) * ac;
  const Vec3 f2 = sheet.per_mm(0, 1) * ab + sheet.per_mm(1, 1) * ac;
  const double c11 = f1.squaredNorm(), c22 = f2.squaredNorm(), c12 = f1.dot(f2);
  const double area2 = std::max(kLeastAreaStretch2, c11 * c22 - c12 * c12);
  const double per_area4 = 1.0 / (area2 * area2);
  return {f1 - per_area4 * (c22 * f1 - c12 * f2),
          f2 - per_area4 * (c11 * f2 - c12 * f1),
          std::sqrt(c11),
          std::sqrt(c22),
          std::sqrt(area2),
          c11 + c22 + 1.0 / area2 - 3.0};
}

/// The second derivative of W is at most along |df1|^2 + across |df2|^2: W'' times the square of the
/// gradient, and W' times that of I1, of which 1 / area^2 has 6 d(area)^2 / area^4 and, through the
/// second derivative of the area, 2 / area^3.
std::array<double, 2> stiffness_bound(const ExponentialSlope& slope, const Invariant& now) {
  const double q1 = now.q1.norm(), q2 = now.q2.norm(), lengths = now.length1 + now.length2;
  const double per_area = 1.0 / now.area, per_area3 = per_area * per_area * per_area;
  const double both = slope.first * 2.0 * (1.0 + per_area3);
  const double steep = slope.first * 6.0 * per_area3 * per_area * lengths;
  return {4.0 * slope.second * q1 * (q1 + q2) + both + steep * now.length2,
          4.0 * slope.second * q2 * (q1 + q2) + both + steep * now.length1};
}

std::array<double, 3> row_sums_of(const Sheet& sheet, const std::array<double, 2>& bound) {
  Eigen::Matrix<double, 3, 2> gradient;  // of the corners' shape functions
  gradient.bottomRows<2>() = sheet.per_mm;
  gradient.row(0) = -sheet.per_mm.colwise().sum();
  const Eigen::DiagonalMatrix<double, 2> moduli(bound[0], bound[1]);
  const Eigen::Vector3d sums =
      sheet.volume_mm3 * (gradient * moduli * gradient.transpose()).cwiseAbs().rowwise().sum();
  return {sums[0], sums[1], sums[2]};
}

}  // namespace

ExponentialLaw exponential_law(const ExponentialTissue& tissue) {
  return {kMpaPerKpa * tissue.c0_kpa, kMpaPerKpa * tissue.c1_kpa, tissue.c2};
}

ExponentialSlope slope(const ExponentialLaw& law, double over) {
  const double steepest = std::sqrt(kSteepest / law.c2);
  const double at = std::min(over, steepest);
  const double power = law.c2 * at * at;
  const double grown = law.c1_mpa * law.c2 * std::exp(power);
  const double second = grown * (1.0 + 2.0 * power);
  return {0.5 * law.c0_mpa + grown * at + second * (over - at), second};
}

double sheet_energy(const ExponentialSheet& sheet, const Points& x) {
  const ExponentialLaw& law = sheet.law;
  const double over = invariant(sheet.sheet, x).over;
  const double at = std::min(over, std::sqrt(kSteepest / law.c2));
  const ExponentialSlope knee = slope(law, at);
  const double beyond = over - at;
  return sheet.sheet.volume_mm3 *
         (0.5 * law.c0_mpa * at + 0.5 * law.c1_mpa * (std::exp(law.c2 * at * at) - 1.0) +
          knee.first * beyond + 0.5 * knee.second * beyond * beyond);
}

void add_sheet_forces(const ExponentialSheet& sheet, const Points& x, Points& force) {
  const Sheet& face = sheet.sheet;
  const Invariant now = invariant(face, x);
  const double pull = 2.0 * face.volume_mm3 * slope(sheet.law, now.over).first;
  const Vec3 b = pull * (face.per_mm(0, 0) * now.q1 + face.per_mm(0, 1) * now.q2);
  const Vec3 c = pull * (face.per_mm(1, 0) * now.q1 + face.per_mm(1, 1) * now.q2);
  force.row(face.node[0]) += b + c;
  force.row(face.node[1]) -= b;
  force.row(face.node[2]) -= c;
}

std::array<double, 3> row_sums(const ExponentialSheet& sheet, const Points& x) {
  const Invariant now = invariant(sheet.sheet, x);
  return row_sums_of(sheet.sheet, stiffness_bound(slope(sheet.law, now.over), now));
}

std::array<double, 3> stiffest_row_sums(const ExponentialSheet& sheet) {
  const double over = std::sqrt(kSteepest / sheet.law.c2);
  const double bound = 8.0 * slope(sheet.law, over).second;
  return row_sums_of(sheet.sheet, {bound, bound});
}

}  // namespace coapt
