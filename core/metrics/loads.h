// What the tissue bears: leaflet strains and chordae tensions.
#pragma once

#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Green-Lagrange strain of one face from the unstressed to the closed shape.
struct FaceStrain {
  double circumferential = 0.0;  ///< along the fibres
  double radial = 0.0;           ///< across them, in the face's plane
};

/// Order of Valve::faces.
std::vector<FaceStrain> face_strains(const Valve& valve, const Points& closed_mm);

struct ChordaeTension {
  double max_n = 0.0;
  double sum_n = 0.0;  ///< over the segments that leave a papillary head
};

/// @param tension_n [chorda][segment], as ClosureResult::tension_n; may be empty.
ChordaeTension chordae_tension(const Valve& valve,
                               const std::vector<std::vector<double>>& tension_n);

}  // namespace coapt
