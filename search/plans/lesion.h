// Where the free edge is not held, and what could be done to chordae there.
#pragma once

#include <optional>
#include <vector>

#include "core/closed/diagnosis.h"
#include "core/repair/plan.h"

namespace coapt {

/// A part of one free edge.
struct Lesion {
  Leaflet leaflet = Leaflet::Posterior;
  double middle = 0.5;  ///< LeafletPoint::along
  double reach =
      0.0;  ///< either side of the middle, as far as the middles of segments or chordae go
  /// Mean of the intact marginal chordae of that leaflet, from head to leaflet (of all, if it has
  /// none; 20, if there are none at all).
  double length_mm = 0.0;
  /// Whose two scallops prolapse, and neither one's neighbour: half of a commissural lesion.
  std::optional<Side> commissure = {};
};

/// That ruptured marginal chordae held, on the leaflet with more of them (the posterior one of as many). None is ruptured: nothing.
std::optional<Lesion> find_lesion(const Valve& valve, const LeafletCoordinates& coordinates);

/// One for each run of adjacent segments of a leaflet that prolapse by the diagnosis, that of the highest first; without a diagnosis
/// find_lesion()'s.
std::vector<Lesion> find_lesions(const Valve& valve, const LeafletCoordinates& coordinates,
                                 const std::optional<Diagnosis>& diagnosis);

/// The first of the posterior leaflet; null if there is none.
const Lesion* posterior_lesion(const std::vector<Lesion>& lesions);

/// Commissures of which both scallops prolapse.
std::vector<Side> commissures_of(const std::vector<Lesion>& lesions);

/// From the free edge at `along` (clamped to the leaflet) to the nearest head of the same half of
/// the valve. Its head is empty if that half has none.
Neochorda neochorda_at(const Valve& valve, const LeafletCoordinates& coordinates,
                       const Lesion& lesion, double along);

/// Intact marginal chordae of the lesion's leaflet, nearest first, at most `most`.  Indices
std::vector<int> chordae_beside(const Valve& valve, const LeafletCoordinates& coordinates,
                                const Lesion& lesion, int most);

/// The intact marginal chorda of the other leaflet that lies opposite; -1 if there is none.
int chorda_opposite(const Valve& valve, const LeafletCoordinates& coordinates,
                    const Lesion& lesion);

/// Intact strut chordae of the anterior leaflet.  Indices
std::vector<int> anterior_struts(const Valve& valve, const LeafletCoordinates& coordinates);

}  // namespace coapt
