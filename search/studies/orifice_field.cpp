#include "search/studies/orifice_field.h"

#include <cmath>

namespace coapt {
namespace {

Vec3 clamped(const Vec3& position_mm) {
  return position_mm.cwiseMax(0.0).cwiseMin(kMostDisplacement_mm);
}

}  // namespace

const char* to_string(Protocol protocol) {
  switch (protocol) {
    case Protocol::LookupClamped:
      return "lookup-clamped";
    case Protocol::LookupExtended:
      return "lookup-extended";
    case Protocol::Closed:
      return "closed";
    case Protocol::Optimum:
      return "optimum";
  }
  return "";
}

bool OrificeField::outside_grid(const Vec3& position_mm) {
  return clamped(position_mm) != position_mm;
}

std::optional<double> OrificeField::at(Displaced displaced, const Vec3& position_mm) {
  switch (protocol_) {
    case Protocol::LookupClamped:
      return looked_up(displaced, clamped(position_mm));
    case Protocol::LookupExtended:
      return looked_up(displaced, position_mm);
    case Protocol::Closed:
    case Protocol::Optimum:
      return closed(displaced, position_mm);
  }
  return std::nullopt;
}

std::optional<double> OrificeField::closed(Displaced displaced, const Vec3& position_mm) {
  const Configuration configuration = displacement(displaced, position_mm);
  if (const OrificeSample* sample = table_.find(configuration)) return sample->area_mm2;
  if (wanted_keys_.insert(key_of(configuration)).second) wanted_.push_back(configuration);
  return std::nullopt;
}

std::optional<double> OrificeField::looked_up(Displaced displaced, const Vec3& position_mm) {
  const Vec3 low = position_mm.array().floor();
  const Vec3 share = position_mm - low;
  double sum = 0.0;
  bool known = true;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    Vec3 node = low;
    for (int axis = 0; axis < 3; ++axis) {
      const bool high = (corner >> axis & 1) != 0;
      weight *= high ? share(axis) : 1.0 - share(axis);
      if (high) node(axis) += 1.0;
    }
    if (weight == 0.0) continue;
    const std::optional<double> area = closed(displaced, node);
    known &= area.has_value();
    sum += weight * area.value_or(0.0);
  }
  if (!known) return std::nullopt;
  return sum;
}

void OrificeField::close_wanted() {
  table_.at(wanted_);
  wanted_.clear();
  wanted_keys_.clear();
}

}  // namespace coapt
