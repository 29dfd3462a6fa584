#include "search/plans/branch.h"

#include <algorithm>
#include <cmath>

namespace coapt {

Parameter make_parameter(ParameterOf of, int index, Range range, double step, double start) {
  Parameter p{of, index, range.min, step, 1, 0};
  p.count = 1 + std::max(0, static_cast<int>(std::floor((range.max - range.min) / step + 1e-9)));
  p.start = std::clamp(static_cast<int>(std::lround((start - range.min) / step)), 0, p.count - 1);
  return p;
}

LatticePoint start_of(const Branch& branch) {
  LatticePoint at;
  for (const Parameter& p : branch.parameters) at.push_back(p.start);
  return at;
}

std::int64_t point_count(const Branch& branch) {
  std::int64_t count = 1;
  for (const Parameter& p : branch.parameters) count *= p.count;
  return count;
}

LatticePoint point_at(const Branch& branch, std::int64_t number) {
  LatticePoint at;
  for (const Parameter& p : branch.parameters) {
    at.push_back(static_cast<int>(number % p.count));
    number /= p.count;
  }
  return at;
}

LatticePoint mildest_of(const Branch& branch) {
  LatticePoint at = start_of(branch);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Parameter& p = branch.parameters[k];
    if (p.of == ParameterOf::Movement) at[k] = 0;
    if (p.of == ParameterOf::RingSize) at[k] = branch.choice.ring == kOwnShape ? 0 : p.count - 1;
  }
  return at;
}

LatticePoint nearest_point(const Branch& from, const LatticePoint& at, const Branch& to) {
  LatticePoint point = start_of(to);
  for (std::size_t k = 0; k < point.size(); ++k) {
    const Parameter& p = to.parameters[k];
    for (std::size_t j = 0; j < at.size(); ++j) {
      const Parameter& q = from.parameters[j];
      if (q.of != p.of || q.index != p.index) continue;
      if (p.of == ParameterOf::RingSize && from.choice.ring != to.choice.ring)
        continue;  // sizes of other shapes mean something else
      if (p.of == ParameterOf::LeafletWidth && from.choice.leaflet != to.choice.leaflet) continue;
      const double value = q.lower + q.step * at[j];
      point[k] =
          std::clamp(static_cast<int>(std::lround((value - p.lower) / p.step)), 0, p.count - 1);
    }
  }
  return point;
}

int differences(const Choice& a, const Choice& b) {
  return (a.ring != b.ring) + (a.anterolateral != b.anterolateral) +
         (a.posteromedial != b.posteromedial) + (a.neochordae != b.neochordae) +
         (a.chordal != b.chordal) + (a.leaflet != b.leaflet) + (a.clefts != b.clefts);
}

}  // namespace coapt
