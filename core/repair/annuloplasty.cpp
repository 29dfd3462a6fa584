#include "core/repair/annuloplasty.h"

#include <algorithm>
#include <cmath>

#include "core/repair/limits.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/contour.h"

namespace coapt {
namespace {

Vec3 row(const Points& points, std::size_t i) { return points.row(static_cast<Eigen::Index>(i)); }

std::string names(const std::vector<RingShape>& catalogue) {
  std::string list = "own";
  for (const RingShape& ring : catalogue) list += ", " + ring.name;
  return list;
}

/// The saddle peak's projection on the annulus's mean plane, in coordinates of the frame.
Vec3 fixed_point(const Valve& valve, const AnnulusFrame& frame) {
  Vec3 point = into_frame(frame, annulus_position_mm(valve, valve.landmarks.saddle_peak));
  point.z() = 0.0;
  return point;
}

void shrink(double factor, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve);
  const Vec3 centre = out_of_frame(frame, fixed_point(valve, frame));
  for (std::size_t i = 0; i < valve.annulus.size(); ++i)
    valve.annulus_mm.row(static_cast<Eigen::Index>(i)) =
        centre + factor * (row(valve.annulus_mm, i) - centre);
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

void suture_to(const Points& contour_mm, Valve& valve) {
  const AnnulusFrame frame = annulus_frame(valve);
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
      sutured.row(static_cast<Eigen::Index>((first + k) % size)) =
          out_of_frame(frame, ring.at(from + shares[k] * length) + shift);
  };
  Points sutured = valve.annulus_mm;
  suture_half(peak, arc_shares(valve, peak, middle), front, back - front, sutured);
  suture_half(middle, arc_shares(valve, middle, peak), back, ring.total_mm() - back + front,
              sutured);
  valve.annulus_mm = sutured;
}

bool check_own_ring(const Annuloplasty& step, const Valve& valve, const std::string& path,
                    ProblemList& problems) {
  bool possible = check_range(problems, path + "/sizes_below", step.sizes_below, kSizesBelow);
  if (step.size_mm != 0.0) {
    problems.add(ErrorCode::OutOfRange, path + "/size_mm",
                 "is for catalogue shapes; shape \"own\" takes its size from the annulus");
    possible = false;
  }
  const double transverse = transverse_diameter_mm(valve, annulus_frame(valve));
  const double most = (1.0 - kLeastOwnRing) * transverse / kRingSizeStep_mm;
  if (!possible || step.sizes_below <= most) return possible;
  problems.add(ErrorCode::ImpossibleStep, path + "/sizes_below",
               "is " + std::to_string(step.sizes_below) + ", must be from 0 to " +
                   shown(std::floor(most)) + ": half of this annulus's transverse diameter of " +
                   shown(transverse) + " mm must remain");
  return false;
}

}  // namespace

const RingShape* find_ring(const std::vector<RingShape>& catalogue, const std::string& name) {
  const auto found = std::find_if(catalogue.begin(), catalogue.end(),
                                  [&name](const RingShape& ring) { return ring.name == name; });
  return found == catalogue.end() ? nullptr : &*found;
}

double ring_width_mm(const RingShape& ring, double size_mm) {
  return ring.transverse_factor * size_mm;
}

Points ring_contour_mm(const RingShape& ring, double size_mm) {
  const double width = ring_width_mm(ring, size_mm);
  return generic_annulus_contour(ring.ap_over_transverse * width, width,
                                 ring.saddle_over_transverse * width);
}

bool check_annuloplasty(const Annuloplasty& step, const Valve& valve,
                        const std::vector<RingShape>& catalogue, const std::string& path,
                        ProblemList& problems) {
  if (step.shape == "own") return check_own_ring(step, valve, path, problems);
  if (find_ring(catalogue, step.shape) == nullptr) {
    problems.add(ErrorCode::BadReference, path + "/shape",
                 "is '" + step.shape + "', known shapes: " + names(catalogue));
    return false;
  }
  bool possible = check_range(problems, path + "/size_mm", step.size_mm, kRingSizesMm, " mm");
  if (possible && std::fmod(step.size_mm, kRingSizeStep_mm) != 0.0) {
    problems.add(ErrorCode::OutOfRange, path + "/size_mm",
                 "is " + shown(step.size_mm) + ", rings come in steps of 2 mm from 24 to 40");
    possible = false;
  }
  if (step.sizes_below != 0) {
    problems.add(ErrorCode::OutOfRange, path + "/sizes_below",
                 "is for shape \"own\"; catalogue shapes are chosen by size_mm");
    possible = false;
  }
  return possible;
}

void apply_annuloplasty(const Annuloplasty& step, const std::vector<RingShape>& catalogue,
                        Valve& valve) {
  if (step.shape == "own") {
    const double transverse = transverse_diameter_mm(valve, annulus_frame(valve));
    shrink((transverse - kRingSizeStep_mm * step.sizes_below) / transverse, valve);
  } else {
    suture_to(ring_contour_mm(*find_ring(catalogue, step.shape), step.size_mm), valve);
  }
}

}  // namespace coapt
