// Which leaflets may touch themselves.
#pragma once

#include <array>
#include <vector>

namespace coapt {

/// Leaflets that contact tells apart: anterior (segments A1 to A3), posterior (P1 to P3),
/// commissural.
inline constexpr int kLeaflets = 3;

/// All; all but the anterior, which hardly folds; none, so that only different leaflets touch.
/// Concerns vertices against faces; edges, a net under these, take all or none (ContactLaw).
enum class SelfContact { All, NotAnterior, None };

/// Vertices of some leaflets against faces of some.
struct ContactSides {
  std::array<bool, kLeaflets> vertices = {true, true, true}, faces = {true, true, true};
};

/// Which pairs there are, each once.
std::vector<ContactSides> contact_sides(SelfContact self);

}  // namespace coapt
