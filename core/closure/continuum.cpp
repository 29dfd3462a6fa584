#include "core/closure/continuum.h"

#include <algorithm>
#include <cmath>

namespace coapt {
namespace {

const double kSqrt2 = std::sqrt(2.0);

/// What a face looks like now.
struct Stretch {
  Vec3 f1, f2;       // images of the unit vectors along and across the fibre
  Vec3 plus, minus;  // of those along the diagonals
  double area;       // per unstressed area
};

Stretch stretch(const Sheet& sheet, const Points& x) {
  const Vec3 a = x.row(sheet.node[0]);
  const Vec3 ab = x.row(sheet.node[1]).transpose() - a, ac = x.row(sheet.node[2]).transpose() - a;
  const Vec3 f1 = sheet.per_mm(0, 0) * ab + sheet.per_mm(1, 0) * ac;
  const Vec3 f2 = sheet.per_mm(0, 1) * ab + sheet.per_mm(1, 1) * ac;
  return {f1, f2, (f1 + f2) / kSqrt2, (f1 - f2) / kSqrt2,
          std::max(kLeastAreaStretch, f1.cross(f2).norm())};
}

/// Of fibres at stretch `length`.
double energy(const Fibres& fibres, double length) {
  const double over = std::max(0.0, length - fibres.straight);
  return 0.5 * fibres.mpa * over * over;
}
double stress(const Fibres& fibres, double length) {
  return fibres.mpa * std::max(0.0, length - fibres.straight);
}
double stiffness(const Fibres& fibres, double length) {
  return length > fibres.straight ? std::max(0.0, fibres.mpa) : 0.0;
}

/// What opens a squeezed face: minus the energy's slope by its area.
double squeezed(const SheetLaw& law, double area) {
  return law.squeezed_mpa * std::max(0.0, law.squeezed_area - area);
}

/// Engineering stress along f1 and f2, shear apart.
std::array<double, 2> axial_stress(const SheetLaw& law, double l1, double l2) {
  const double e1 = l1 - 1.0, e2 = l2 - 1.0;
  return {law.along_mpa * e1 + law.coupling_mpa * e2 + stress(law.along, l1),
          law.coupling_mpa * e1 + law.across_mpa * e2 + stress(law.across, l2)};
}

/// The energy's second derivative is at most along |df1|^2 + across |df2|^2.
struct StiffnessBound {
  double along = 0.0, across = 0.0;
};

/// Of stiffness `axial` along a unit vector, `tension` across it, and shear stiffness along another
/// one whose cosine to it is `cosine`: two rank-one terms add up to max + min |cosine|.
double block_bound(double axial, double tension, double shear, double cosine) {
  const double across = std::max(0.0, tension), more = std::max(0.0, axial - across);
  return across + std::max(more, shear) + std::min(more, shear) * cosine;
}

StiffnessBound stiffness_bound(const SheetLaw& law, const Stretch& now) {
  const double l1 = now.f1.norm(), l2 = now.f2.norm(), shear = now.f1.dot(now.f2);
  const double cosine = std::abs(shear) / (l1 * l2);
  const auto axial = axial_stress(law, l1, l2);
  // The area's slopes by f1 and f2 are at most |f2| and |f1|, its second derivative |df1| |df2|.
  const double opening = squeezed(law, now.area);
  const double barrier = opening > 0.0 ? law.squeezed_mpa : 0.0;
  const double mixed = std::max(law.coupling_mpa, law.shear_mpa * l1 * l2) * (1.0 + cosine) +
                       law.shear_mpa * std::abs(shear) + barrier * l1 * l2 + opening;
  double diagonal = 0.0;
  for (const double length : {now.plus.norm(), now.minus.norm()})
    diagonal = std::max(
        {diagonal, stiffness(law.diagonal, length), stress(law.diagonal, length) / length});
  return {block_bound(law.along_mpa + stiffness(law.along, l1) + barrier * l2 * l2, axial[0] / l1,
                      law.shear_mpa * l2 * l2, cosine) +
              mixed + diagonal,
          block_bound(law.across_mpa + stiffness(law.across, l2) + barrier * l1 * l1, axial[1] / l2,
                      law.shear_mpa * l1 * l1, cosine) +
              mixed + diagonal};
}

std::array<double, 3> row_sums(const Sheet& sheet, const StiffnessBound& bound) {
  Eigen::Matrix<double, 3, 2> gradient;  // of the corners' shape functions
  gradient.bottomRows<2>() = sheet.per_mm;
  gradient.row(0) = -sheet.per_mm.colwise().sum();
  const Eigen::DiagonalMatrix<double, 2> moduli(bound.along, bound.across);
  const Eigen::Vector3d sums =
      sheet.volume_mm3 * (gradient * moduli * gradient.transpose()).cwiseAbs().rowwise().sum();
  return {sums[0], sums[1], sums[2]};
}

}  // namespace

SheetLaw sheet_law(const Tissue& tissue) {
  const double pre1 = kMpaPerKpa * tissue.circumferential_pre_kpa;
  const double pre2 = kMpaPerKpa * tissue.radial_pre_kpa;
  const double post1 = kMpaPerKpa * tissue.circumferential_post_kpa;
  const double post2 = kMpaPerKpa * tissue.radial_post_kpa;
  constexpr double kPlane = 1.0 / (1.0 - kMatrixPoisson * kMatrixPoisson);
  const auto at_45_degrees = [](double a, double b) { return Vec2(a, b).norm() / kSqrt2; };
  SheetLaw law;
  law.along_mpa = kPlane * pre1;
  law.across_mpa = kPlane * pre2;
  law.coupling_mpa = kPlane * kMatrixPoisson * std::sqrt(pre1 * pre2);
  law.shear_mpa = std::sqrt(pre1 * pre2) / (2.0 * (1.0 + kMatrixPoisson));
  law.along = {1.0 + tissue.circumferential_transition, post1 - pre1};
  law.across = {1.0 + tissue.radial_transition, post2 - pre2};
  law.diagonal = {1.0 + at_45_degrees(tissue.circumferential_transition, tissue.radial_transition),
                  0.5 * (at_45_degrees(post1, post2) - at_45_degrees(pre1, pre2))};
  return law;
}

std::vector<Sheet> make_sheets(const Valve& valve) {
  const auto [stretch1, stretch2] = prestretch(valve.tissue);
  std::vector<Sheet> sheets(valve.faces.rows());
  for (Index f = 0; f < valve.faces.rows(); ++f) {
    Sheet& sheet = sheets[f];
    sheet.node = {valve.faces(f, 0), valve.faces(f, 1), valve.faces(f, 2)};
    const Vec3 a = valve.rest_mm.row(sheet.node[0]);
    const Vec3 ab = valve.rest_mm.row(sheet.node[1]).transpose() - a;
    const Vec3 ac = valve.rest_mm.row(sheet.node[2]).transpose() - a;
    const Vec3 normal = ab.cross(ac);
    const Vec3 across = normal.cross(Vec3(valve.fibre.row(f))).normalized();
    const Vec3 along = across.cross(normal).normalized();
    Eigen::Matrix2d edges;  // of the face free of stress
    edges << along.dot(ab) / stretch1, along.dot(ac) / stretch1, across.dot(ab) / stretch2,
        across.dot(ac) / stretch2;
    sheet.per_mm = edges.inverse();
    sheet.volume_mm3 = 0.5 * normal.norm() * thickness_mm(valve, static_cast<int>(f));
  }
  return sheets;
}

double sheet_energy(const SheetLaw& law, const Sheet& sheet, const Points& x) {
  const Stretch now = stretch(sheet, x);
  const double l1 = now.f1.norm(), l2 = now.f2.norm(), shear = now.f1.dot(now.f2);
  const double e1 = l1 - 1.0, e2 = l2 - 1.0;
  const double matrix =
      0.5 * (law.along_mpa * e1 * e1 + law.across_mpa * e2 * e2 + law.shear_mpa * shear * shear) +
      law.coupling_mpa * e1 * e2;
  const double missing = std::max(0.0, law.squeezed_area - now.area);
  return sheet.volume_mm3 *
         (matrix + 0.5 * law.squeezed_mpa * missing * missing + energy(law.along, l1) +
          energy(law.across, l2) + energy(law.diagonal, now.plus.norm()) +
          energy(law.diagonal, now.minus.norm()));
}

void add_sheet_forces(const SheetLaw& law, const Sheet& sheet, const Points& x, Points& force) {
  const Stretch now = stretch(sheet, x);
  const double l1 = now.f1.norm(), l2 = now.f2.norm();
  const double mixed = now.f1.dot(now.f2), opening = squeezed(law, now.area) / now.area;
  const double shear = law.shear_mpa * mixed + opening * mixed;
  const auto axial = axial_stress(law, l1, l2);
  const Vec3 plus = (stress(law.diagonal, now.plus.norm()) / kSqrt2) * now.plus.normalized();
  const Vec3 minus = (stress(law.diagonal, now.minus.norm()) / kSqrt2) * now.minus.normalized();
  // Gradients of the energy by f1 and f2.
  const Vec3 p1 = (axial[0] / l1 - opening * l2 * l2) * now.f1 + shear * now.f2 + plus + minus;
  const Vec3 p2 = (axial[1] / l2 - opening * l1 * l1) * now.f2 + shear * now.f1 + plus - minus;
  const Vec3 b = sheet.volume_mm3 * (sheet.per_mm(0, 0) * p1 + sheet.per_mm(0, 1) * p2);
  const Vec3 c = sheet.volume_mm3 * (sheet.per_mm(1, 0) * p1 + sheet.per_mm(1, 1) * p2);
  force.row(sheet.node[0]) += b + c;
  force.row(sheet.node[1]) -= b;
  force.row(sheet.node[2]) -= c;
}

std::array<double, 3> row_sums(const SheetLaw& law, const Sheet& sheet, const Points& x) {
  return row_sums(sheet, stiffness_bound(law, stretch(sheet, x)));
}

std::array<double, 3> stiffest_row_sums(const SheetLaw& law, const Sheet& sheet) {
  const auto fibres = [](const Fibres& f) { return std::max(0.0, f.mpa); };
  const double rest = std::max(law.coupling_mpa, law.shear_mpa) + fibres(law.diagonal);
  return row_sums(sheet, {std::max(law.along_mpa + fibres(law.along), law.shear_mpa) + rest,
                          std::max(law.across_mpa + fibres(law.across), law.shear_mpa) + rest});
}

}  // namespace coapt
