#include "core/repair/annuloplasty.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/contour.h"

namespace coapt {
namespace {

constexpr std::size_t kLongestRingName = 64;

Vec3 row(const Points& points, std::size_t i) { return points.row(i); }

std::string known_shapes() {
  std::string list = kOwnShape;
  for (const RingShape& ring : kRingShapes) list.append(", ").append(ring.name);
  return list;
}

/// The saddle peak's projection on the annulus's mean plane, in coordinates of the frame.
Vec3 fixed_point(const Valve& valve, const AnnulusFrame& frame) {
  Vec3 point = into_frame(frame, annulus_position_mm(valve, valve.landmarks.saddle_peak));
  point.z() = 0.0;
  return point;
}

void shrink(double factor, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const Vec3 centre = out_of_frame(frame, fixed_point(valve, frame));
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    valve.annulus_mm.row(i) = centre + factor * (row(valve.annulus_mm, i) - centre);
}

/// Share of the arc from `first` (an index into the annulus) to `last` at each vertex from the one
/// to, and without, the other.
std::vector<double> arc_shares(const Valve& valve, std::size_t first, std::size_t last) {
  const std::size_t size = valve.annulus.size();
  std::vector<double> share;
  double length = 0.0;
  for (std::size_t i = first; i != last; i = (i + 1) % size) {
    share.push_back(length);
    length += (row(valve.annulus_mm, (i + 1) % size) - row(valve.annulus_mm, i)).norm();
  }
  for (double& s : share) s /= length;
  return share;
}

bool check_size(double size_mm, const std::string& path, ProblemList& problems) {
  const bool possible = check_range(problems, path + "/size_mm", size_mm, kRingSizesMm, " mm");
  if (!possible || std::fmod(size_mm, kRingSizeStep_mm) == 0.0) return possible;
  problems.add(ErrorCode::OutOfRange, path + "/size_mm",
               "is " + shown(size_mm) + ", rings come in steps of " + shown(kRingSizeStep_mm) +
                   " mm from " + shown(kRingSizesMm));
  return false;
}

bool check_ring(const OwnRing& ring, const Valve& valve, const std::string& path,
                ProblemList& problems) {
  const bool possible = check_range(problems, path + "/sizes_below", ring.sizes_below, kSizesBelow);
  const double transverse = transverse_diameter_mm(valve);
  const double most = (1.0 - kLeastOwnRing) * transverse / kRingSizeStep_mm;
  if (!possible || ring.sizes_below <= most) return possible;
  problems.add(ErrorCode::ImpossibleStep, path + "/sizes_below",
               "is " + std::to_string(ring.sizes_below) + ", must be from 0 to " +
                   shown(std::floor(most)) + ": half of this annulus's transverse diameter of " +
                   shown(transverse) + " mm must remain");
  return false;
}

bool check_ring(const CatalogueRing& ring, const Valve& /*valve*/, const std::string& path,
                ProblemList& problems) {
  if (find_ring(ring.shape) == nullptr) {
    problems.add(ErrorCode::BadReference, path + "/shape",
                 "is '" + ring.shape + "', known shapes: " + known_shapes());
    return false;
  }
  return check_size(ring.size_mm, path, problems);
}

bool check_ring(const DesignedRing& ring, const Valve& /*valve*/, const std::string& path,
                ProblemList& problems) {
  const bool possible = check_designed_shape(ring.shape, path + "/ring", problems);
  return check_size(ring.size_mm, path, problems) && possible;
}

}  // namespace

bool check_annuloplasty(const Annuloplasty& step, const Valve& valve, const std::string& path,
                        ProblemList& problems) {
  return std::visit([&](const auto& ring) { return check_ring(ring, valve, path, problems); },
                    step.ring);
}

bool check_designed_shape(const DesignedShape& shape, const std::string& path,
                          ProblemList& problems) {
  const std::string& name = shape.name;
  const bool is_taken = name == kOwnShape || name == kDesignedShape || find_ring(name) != nullptr;
  const bool is_possible = !name.empty() && name.size() <= kLongestRingName && !is_taken;
  if (!is_possible)
    problems.add(ErrorCode::OutOfRange, path + "/name",
                 "is '" + name + "', must be a name of 1 to " + std::to_string(kLongestRingName) +
                     " bytes, none of " + known_shapes() + ", " + kDesignedShape);
  return check_ring_terms(shape.terms, path, problems) && is_possible;
}

void suture_ring(const RingShape& shape, double size_mm, Valve& valve) {
  suture_contour(ring_contour_mm(shape, size_mm), valve);
}

void suture_contour(const Points& contour_mm, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve, AnnulusAxis::SaddlePeak);
  const ArcLength ring(contour_mm);
  const double front = ring.crossing_mm(true), back = ring.crossing_mm(false);
  Vec3 shift = fixed_point(valve, frame) - ring.at(front);
  shift.z() = 0.0;
  const auto index_of = [&valve](int vertex) {
    return static_cast<std::size_t>(std::find(valve.annulus.begin(), valve.annulus.end(), vertex) -
                                    valve.annulus.begin());
  };
  const std::size_t size = valve.annulus.size();
  const std::size_t peak = index_of(valve.landmarks.saddle_peak);
  const std::size_t middle = index_of(valve.landmarks.mid_posterior);
  const auto suture_half = [&](std::size_t first, const std::vector<double>& shares, double from,
                               double length, Points& sutured) {
    for (std::size_t k = 0; k < shares.size(); ++k)
      sutured.row((first + k) % size) =
          out_of_frame(frame, ring.at(from + shares[k] * length) + shift);
  };
  Points sutured = valve.annulus_mm;
  suture_half(peak, arc_shares(valve, peak, middle), front, back - front, sutured);
  suture_half(middle, arc_shares(valve, middle, peak), back, ring.total_mm() - back + front,
              sutured);
  valve.annulus_mm = sutured;
}

void apply_annuloplasty(const Annuloplasty& step, Valve& valve) {
  valve.systole.annular_contraction = 0.0;
  if (const auto* own = std::get_if<OwnRing>(&step.ring)) {
    const double transverse = transverse_diameter_mm(valve);
    shrink((transverse - kRingSizeStep_mm * own->sizes_below) / transverse, valve);
  } else if (const auto* made = std::get_if<CatalogueRing>(&step.ring)) {
    suture_ring(*find_ring(made->shape), made->size_mm, valve);
  } else {
    const auto& ring = std::get<DesignedRing>(step.ring);
    suture_contour(ring_contour_mm(ring.shape.terms, ring.size_mm), valve);
  }
}

}  // namespace coapt
