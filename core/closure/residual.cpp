#include "core/closure/residual.h"

#include <algorithm>
#include <cmath>

namespace coapt {

double rms_free(const ClosureModel& model, const Points& force, int nodes) {
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < nodes; ++i) {
    if (model.fixed[i]) continue;
    sum += force.row(i).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / std::max(1, count));
}

double residual(const ClosureModel& model, const Points& x, const Points& force) {
  Points pressure = Points::Zero(x.rows(), 3);
  add_pressure_forces(model, x, pressure);
  const double load = rms_free(model, pressure, model.vertices);
  const double free = rms_free(model, force, static_cast<int>(x.rows()));
  return load > 0.0 ? free / load : free;
}

}  // namespace coapt
