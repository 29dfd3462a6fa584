// One word for what a user trades: time for certainty of the leak.
#pragma once

namespace coapt {

/// How much time the leak is worth; how meshes are refined: core/closed/mesh_convergence.h.
enum class Certainty {
  Quick,  ///< the mesh as given
  Sure,   ///< and one of four times the triangles, and at half the speed
  Proof   ///< and finer and finer ones until the leak settles
};

inline const char* to_string(Certainty certainty) {
  switch (certainty) {
    case Certainty::Quick:
      return "quick";
    case Certainty::Sure:
      return "sure";
    case Certainty::Proof:
      return "proof";
  }
  return "";
}

}  // namespace coapt
