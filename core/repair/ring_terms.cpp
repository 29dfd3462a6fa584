#include "core/repair/ring_terms.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/valve/contour.h"

namespace coapt {
namespace {

double at_p3(double t) {
  constexpr double kThere = 1.0 + 1.0 / std::numbers::sqrt2;
  return -std::sin(2.0 * t) * (1.0 - std::sin(t)) * (1.0 + std::cos(t)) / (kThere * kThere);
}

double at_back(double t) { return -0.5 * std::sin(t) * (1.0 - std::sin(t)); }

/// Twice the area of the triangle in the plane; positive if it turns to the left.
double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Counter-clockwise, seen from above (Andrew 1979).
std::vector<Vec3> convex_hull(const Points& contour_mm) {
  std::vector<Vec3> points;
  for (Index i = 0; i < contour_mm.rows(); ++i) points.emplace_back(contour_mm.row(i));
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vec3> hull;
  const auto add_side = [&hull](auto first, auto last) {
    const std::size_t before = hull.size();
    for (auto point = first; point != last; ++point) {
      while (hull.size() >= before + 2 && turn(hull[hull.size() - 2], hull.back(), *point) <= 0.0)
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();  // begins the other side
  };
  add_side(points.begin(), points.end());
  add_side(points.rbegin(), points.rend());
  return hull;
}

bool goes_steadily_round(const Points& contour_mm) {
  for (Index i = 0; i < contour_mm.rows(); ++i) {
    const Vec3 a = contour_mm.row(i), b = contour_mm.row((i + 1) % contour_mm.rows());
    if (turn(Vec3::Zero(), a, b) <= 0.0) return false;
  }
  return true;
}

}  // namespace

Points ring_contour_mm(const RingTerms& terms, double width_mm) {
  Points contour = generic_annulus_contour(terms.ap_over_transverse * width_mm, width_mm, 0.0);
  const Index count = contour.rows();
  for (Index i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double saddle = -std::cos(2.0 * t);  // -1 at the ends, 1 in the middles
    contour(i, 1) += width_mm * (-terms.flattening * saddle + terms.p3_inset * at_p3(t));
    contour(i, 2) = width_mm * (0.5 * terms.saddle * saddle + terms.elevation * at_back(t) +
                                terms.p3_elevation * at_p3(t));
  }
  Vec3 centre = arc_centroid(contour);
  centre.x() = 0.0;  // front's and back's middle stay at x = 0
  return contour.rowwise() - centre.transpose();
}

double deepest_dent_mm(const Points& contour_mm) {
  const std::vector<Vec3> hull = convex_hull(contour_mm);
  double deepest = 0.0;
  for (Index i = 0; i < contour_mm.rows(); ++i) {
    const Vec3 point = contour_mm.row(i);
    double depth = INFINITY;  // to the nearest side of the hull
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Vec3 &a = hull[k], &b = hull[(k + 1) % hull.size()];
      depth = std::min(depth, turn(a, b, point) / (b - a).head<2>().norm());
    }
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

double unsewable(const RingTerms& terms) {
  const Points contour = ring_contour_mm(terms, 1.0);
  if (!goes_steadily_round(contour)) return 1.0;
  return std::max(0.0, deepest_dent_mm(contour) - kMostDent);
}

bool check_ring_terms(const RingTerms& terms, const std::string& path, ProblemList& problems) {
  bool possible = true;
  for (const RingTermRow& row : kRingTerms)
    possible =
        check_range(problems, path + "/" + row.name, terms.*row.member, row.range) && possible;
  if (!possible || unsewable(terms) == 0.0) return possible;
  problems.add(ErrorCode::BadGeometry, path,
               "is a ring with a dent deeper than " + shown(kMostDent) +
                   " of its width, or one that crosses itself; reduce p3_inset or flattening, "
                   "or increase ap_over_transverse");
  return false;
}

}  // namespace coapt
