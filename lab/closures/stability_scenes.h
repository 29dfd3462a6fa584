// Scenes that get harder along one axis at a time, for the map of stability.
#pragma once

#include <string>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

enum class Difficulty {
  Step,              ///< factor on a method's own step
  ContactStiffness,  ///< factor
  ChordaeModulus,    ///< factor
  Pressure,          ///< kPa
  Slivers,           ///< shortest edge as a share of what it was
  Resolution,        ///< triangles
  Dilation,          ///< anteroposterior, %
  Tips,              ///< displacement of both, outwards, backwards and apically alike, mm
};

struct DifficultyAxis {
  Difficulty of = Difficulty::Step;
  std::vector<double> levels;  ///< from easy to hard where there is such an order
  double nominal = 1.0;        ///< one of the levels
};

/// The axes of the map.
std::vector<DifficultyAxis> difficulty_axes();

struct StabilityScene {
  Valve valve;
  double step = 1.0;               ///< factor, of methods that have one
  double contact_stiffness = 1.0;  ///< factor
};

/// `name`: a preset, or kCommissures: human-normal with its annulus drawn in anteroposteriorly by a
/// fifth, as by a ring much too small, which leaves surplus tissue at both commissures. All axes but `axis` are nominal.
/// @pre the name is one of these, the level within the axis's range.
StabilityScene make_stability_scene(const std::string& name, Difficulty axis, double level);

inline constexpr const char* kCommissures = "commissures";

/// The valve with a vertex each of A2, P2 and both commissures moved towards a neighbour until the edge
/// between them is `ratio` of what it was. No boundary vertex and none that carries a chorda moves.
Valve with_slivers(Valve valve, double ratio);

const char* to_string(Difficulty axis);

}  // namespace coapt
