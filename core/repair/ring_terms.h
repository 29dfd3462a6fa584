// Rings that are designed: the generic contour, changed by six terms of finite Fourier series.
//
// t is the contour's parameter: 0 at its posteromedial end, pi/2 the middle of its front, pi its anterolateral end, 3 pi/2 the middle
// of its back. Of a ring of width w with the generic contour (X(t), Y(t)) of depth ap w (contour.h):
//   x = X
//   y = Y + w (flattening cos 2t + p3_inset q(t))
//   z = w (-saddle/2 cos 2t + elevation r(t) + p3_elevation q(t))
//   q(t) = -sin 2t (1 - sin t) (1 + cos t) / (1 + 1/sqrt 2)^2: 1 in the middle of the posteromedial posterior quarter (t = -pi/4),
//          where P3 is sewn, 0 at both ends and both middles
//   r(t) = -sin t (1 - sin t) / 2: 1 in the middle of the back, 0 at both ends and in front
// So width, depth from middle to middle, and the saddle (front's middle above the ends) are exact whatever the other terms are. With all
// terms but the first zero this is a generic flat ring.
#pragma once

#include <array>
#include <string>

#include "core/valve/problem_list.h"
#include "core/valve/types.h"

namespace coapt {

/// Shares of the ring's width.
struct RingTerms {
  double ap_over_transverse = 0.75;  ///< front's middle to back's middle
  double flattening = 0.0;           ///< of the front, by which the back gets rounder: a D
  double p3_inset = 0.0;             ///< P3 drawn in, forwards; negative: let out
  double saddle = 0.0;               ///< front's middle above the ends
  double elevation = 0.0;            ///< of the back's middle, beyond the saddle
  double p3_elevation = 0.0;         ///< negative: P3 lies lower

  bool operator==(const RingTerms&) const = default;
};

/// One term with its accepted range.
struct RingTermRow {
  const char* name;
  double RingTerms::*member;
  Range range;
};

/// Ranges hold the rings on sale: depth 0.51 to 0.75 of the width; saddles to 0.2; P3 of asymmetric rings drawn in and lowered or raised
/// by a few mm. Beyond them by about a third.
inline constexpr std::array<RingTermRow, 6> kRingTerms = {{
    {"ap_over_transverse", &RingTerms::ap_over_transverse, {0.45, 0.9}},
    {"flattening", &RingTerms::flattening, {-0.05, 0.06}},
    {"p3_inset", &RingTerms::p3_inset, {-0.05, 0.12}},
    {"saddle", &RingTerms::saddle, {0.0, 0.3}},
    {"elevation", &RingTerms::elevation, {0.0, 0.2}},
    {"p3_elevation", &RingTerms::p3_elevation, {-0.12, 0.12}},
}};

/// A dent of more than this share of the width would be bridged by the annulus, not followed (assumed).
inline constexpr double kMostDent = 0.01;

/// 720 points as of ring_contour_mm() of the catalogue: counter-clockwise from the posteromedial end, its width from -w/2 to w/2,
/// y and z about its centroid.
Points ring_contour_mm(const RingTerms& terms, double width_mm);

/// How deep the deepest dent of a contour is, seen from above: of its points to their convex hull. 0: convex.
double deepest_dent_mm(const Points& contour_mm);

/// How far a shape is from one that can be sewn, 0 for one that can: by what share of the width its deepest dent exceeds kMostDent, or 1
/// where the contour does not go steadily round its centroid, as one that crosses itself never does.
double unsewable(const RingTerms& terms);

/// Ranges, each term by its name below `path`, and that the shape can be sewn.
bool check_ring_terms(const RingTerms& terms, const std::string& path, ProblemList& problems);

}  // namespace coapt
