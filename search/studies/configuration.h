// One configuration of the thesis's studies (4.2.2, 4.2.3): a ring of the valve's own shape,
// annular remodelling, and papillary muscles displaced.
#pragma once

#include <array>

#include "core/valve/remodel.h"

namespace coapt {

/// Which papillary muscles are displaced: one (asymmetric) or both (symmetric, mirrored).
enum class Displaced { Anterolateral, Posteromedial, Both };
inline constexpr std::array<Displaced, 3> kDisplaced = {Displaced::Anterolateral,
                                                        Displaced::Posteromedial, Displaced::Both};
const char* to_string(Displaced displaced);  ///< "AL", "PM", "both"

/// Of the thesis's displacements along each axis (4.2.2).
inline constexpr double kMostDisplacement_mm = 6.0;

/// The ring is in place before the muscles move.
struct Configuration {
  Remodelling change;
  int ring_sizes_below = 0;  ///< U1 to U3 of the thesis; 0: the annulus as it is
};

/// `by_mm`: transverse (outwards), posterior, apical, as in Remodelling.
Configuration displacement(Displaced displaced, const Vec3& by_mm, int ring_sizes_below = 0);

/// Errors as of apply_plan() and remodel().
Expected<Valve> configure(const Valve& valve, const Configuration& configuration);

}  // namespace coapt
