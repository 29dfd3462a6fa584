#include "core/valve/mean_point.h"

namespace coapt {

// The order is that of Eigen's packets under g++: x and y by fours, z one by one.
Vec3 mean_point(const Points& points) {
  const Index rows = points.rows();
  Vec3 sum = points.row(0);
  Index i = 1;
  for (; i < ((rows - 1) & ~Index{3}); i += 4)
    for (int axis = 0; axis < 2; ++axis)
      sum(axis) +=
          (points(i, axis) + points(i + 1, axis)) + (points(i + 2, axis) + points(i + 3, axis));
  for (; i < rows; ++i)
    for (int axis = 0; axis < 2; ++axis) sum(axis) += points(i, axis);
  for (i = 1; i < rows; ++i) sum(2) += points(i, 2);
  return sum / static_cast<double>(rows);
}

}  // namespace coapt
