// Many different closures of one valve, for studies of how well and how fast it closes: dilated,
// displaced, with and without a ring and papillary sutures.
#pragma once

#include <cstdint>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

enum class SceneRings { None, Catalogue };

/// Scene `index` of a valve: AP dilation 0 to 30 %, annular height 80 to 120 %, each tip displaced by up
/// to 6 mm outwards, backwards and apically; with probability 0.4 (0 without rings) a
/// catalogue ring 0 to 4 sizes below the valve's own width, with 0.4 a suture on either side, 0 to 8 mm
/// shorter than the present distance. Steps that the valve does not allow are left out. The same
/// arguments give the same valve.
Valve varied_scene(const Valve& valve, std::uint64_t seed, int index,
                   SceneRings rings = SceneRings::Catalogue);

/// A neighbour of that scene: its tips moved once more, by up to 1 mm each, in any direction.
Valve neighbour_of(const Valve& scene, std::uint64_t seed, int index);

/// Neighbours of a scene that it can be predicted from (core/closure/predicted_start.h).
struct SceneFrame {
  /// The middle, up to 1 mm from the scene, then three pairs of opposite ones, 1 mm from the middle.
  std::vector<Valve> valves;
  /// |valves|: how far both tips are from the middle's: outwards, backwards, apically, mm.
  std::vector<Eigen::VectorXd> moved_mm;
  Eigen::VectorXd scene_mm;  ///< likewise, of the scene itself
};

/// Both tips move alike, as in the region of interest.
SceneFrame frame_of(const Valve& scene, std::uint64_t seed, int index);

}  // namespace coapt
