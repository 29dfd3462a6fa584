#include "core/valve/validate_parts.h"

#include <cmath>

namespace coapt {
namespace {

constexpr double kWeightTolerance = 1e-6;

}  // namespace

bool check_points(const Points& points, const std::string& path, ProblemList& problems) {
  bool good = true;
  for (int row = 0; row < points.rows(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      const double number = points(row, axis);
      if (number >= kCoordinateMm.min && number <= kCoordinateMm.max) continue;
      check_range(problems, at(at(path, row), axis), number, kCoordinateMm, " mm");
      good = false;
    }
  }
  return good;
}

void check_insertion(const Insertion& insertion, int faces, const std::string& path,
                     ProblemList& problems) {
  if (faces > 0 && (insertion.face < 0 || insertion.face >= faces)) {
    problems.add(ErrorCode::BadReference, path + "/face",
                 "is " + std::to_string(insertion.face) + ", must be the index of a face, 0 to " +
                     std::to_string(faces - 1));
  }
  bool inside = true;
  double sum = 0.0;
  for (int corner = 0; corner < 3; ++corner) {
    const double weight = insertion.weights[corner];
    inside &= check_range(problems, at(path + "/weights", corner), weight, {0.0, 1.0});
    sum += weight;
  }
  if (inside && !(std::abs(sum - 1.0) <= kWeightTolerance)) {
    problems.add(ErrorCode::OutOfRange, path + "/weights",
                 "add up to " + shown(sum) + ", must add up to 1 within 1e-6");
  }
}

}  // namespace coapt
