#include "tests/search/studies/thesis_example.h"

#include <cmath>

#include "search/studies/thesis_figures.h"
#include "tests/search/studies/study_scene.h"

namespace coapt {
namespace {

/// What the orifice gains by axes together beyond what they gain in smaller sets (Moebius inversion of
/// a row of table 4.1).
std::array<double, 7> own_part(const std::array<double, 7>& largest) {
  std::array<double, 7> own{};
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    own[k] = largest[k];
    for (std::size_t smaller = 0; smaller < k; ++smaller) {
      bool within = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        within &= kAxes[k][axis] || !kAxes[smaller][axis];
      if (within) own[k] -= own[smaller];
    }
  }
  return own;
}

OrificeOf orifice_of_the_thesis(std::size_t row) {
  return [own = own_part(thesis::kDisplaced_mm2[row])](const Vec3& displacement_mm) {
    double sum = 0.0;
    for (std::size_t k = 0; k < kAxes.size(); ++k) {
      double part = own[k];
      for (int axis = 0; axis < 3; ++axis)
        if (kAxes[k][static_cast<std::size_t>(axis)])
          part *= std::pow(displacement_mm(axis) / 6.0, 1.5);
      sum += part;
    }
    return sum;
  };
}

}  // namespace

AnnulusStudy annulus_of_the_thesis() {
  AnnulusStudy study;
  study.height_percent = {100.0, 75.0, 50.0, 25.0, 0.0};
  for (int d = 0; d <= 30; ++d) study.dilation_percent.push_back(d);
  for (const double height : study.height_percent) {
    study.area_mm2.emplace_back();
    for (const double d : study.dilation_percent) {
      const double area = d <= 10.0   ? 0.067 * d * d
                          : d <= 20.0 ? 6.7 + 2.53 * (d - 10.0)
                                      : 32.0 + 5.49 * (d - 20.0);
      study.area_mm2.back().push_back(area * (height == 100.0 ? 1.0 : 0.93));
    }
  }
  return study;
}

PapillaryStudy papillary_of_the_thesis() {
  PapillaryStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    study.grids[k] = grid_of(kDisplaced[k], 7, 1.0, orifice_of_the_thesis(k));
  return study;
}

RingStudy ring_of_the_thesis() {
  RingStudy study;
  for (std::size_t k = 0; k < kDisplaced.size(); ++k)
    for (std::size_t sizes = 0; sizes < 4; ++sizes)
      study.grids[k][sizes] = grid_of(
          kDisplaced[k], 4, 2.0,
          [&](const Vec3& d) {
            const Vec3 far = d / 6.0;
            const double proper = 10.0 * far.x() + 5.0 * far.y() + 85.0 * far.z() * (2.0 - far.z());
            if (sizes == 0) return proper;
            const double ratio = 0.01 * thesis::kRingRatio_percent[k][sizes - 1];
            return ratio * proper * (far.x() + far.y() + 4.0 * far.z()) / 6.0;
          },
          static_cast<int>(sizes));
  return study;
}

ApproximationStudy anchors_of_the_thesis(Protocol protocol) {
  ApproximationStudy study;
  study.protocol = protocol;
  study.anchors = {{"trigone", 0.1, {}}, {"saddle peak", 0.25, {}}};
  for (const Displaced displaced : kDisplaced)
    for (const double mean : {2.0, 3.0})
      for (const std::size_t anchor : {0u, 1u}) {
        const double worse = anchor == 0 ? 1.0 : 2.0;
        Approximation found;
        found.displaced = displaced;
        found.anchor = anchor;
        found.repaired = true;
        found.region.mean_mm2 = worse * mean;
        found.region.sd_mm2 = worse * 1.0;
        found.region.length_sd_mm2 = worse * 0.8;
        found.region.angle_sd_mm2 = worse * 0.6;
        found.region.length_slope_mm2_per_mm = worse * 1.5;
        found.region.swing_slope_mm2_per_mm = worse * 0.5;
        study.approximations.push_back(found);
      }
  return study;
}

ThesisStudy study_of_the_thesis() {
  ThesisStudy study;
  study.annulus = annulus_of_the_thesis();
  study.papillary = papillary_of_the_thesis();
  study.ring = ring_of_the_thesis();
  study.anchors.approximation = {anchors_of_the_thesis()};
  study.belly_shift_mm = {Vec3(-1.1, 0.0, -0.2), Vec3(-0.9, 0.1, -0.1), Vec3(-0.6, 0.0, 0.0)};
  return study;
}

}  // namespace coapt
