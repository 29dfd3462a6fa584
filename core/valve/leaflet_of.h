#pragma once

#include <optional>

#include "core/valve/valve.h"

namespace coapt {

/// The leaflet of a segment; none of the commissures.
inline std::optional<Leaflet> leaflet_of(Segment segment) {
  switch (segment) {
    case Segment::A1:
    case Segment::A2:
    case Segment::A3:
      return Leaflet::Anterior;
    case Segment::P1:
    case Segment::P2:
    case Segment::P3:
      return Leaflet::Posterior;
    case Segment::AC:
    case Segment::PC:
      break;
  }
  return std::nullopt;
}

}  // namespace coapt
