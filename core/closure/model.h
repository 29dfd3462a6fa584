// A valve as masses, membrane and cables: everything that does not change while it closes.
//
// Membrane: one spring per edge, stiffness after van Gelder (thesis equation 2.2), bilinear and
// orthotropic (2.3, 2.4); or constant-strain triangles (continuum.h). Bending: hinges (hinges.h).
// Chordae: tension-only cables with free branch points, which pull at zones of the leaflet. Units inside the closure: mm, g, ms, hence N and MPa.
#pragma once

#include <array>
#include <vector>

#include "core/closure/continuum.h"
#include "core/closure/exponential.h"
#include "core/closure/hinges.h"
#include "core/closure/insertion_zone.h"
#include "core/closure/membrane.h"
#include "core/valve/valve.h"

namespace coapt {

/// Bilinear spring of one leaflet edge (thesis equation 2.4).
struct Spring {
  int a = 0, b = 0;
  double rest_mm = 0.0;
  double transition = 0.0;     ///< strain where the stiffness changes
  double pre_n_per_mm = 0.0;   ///< stiffness below it
  double post_n_per_mm = 0.0;  ///< and above
};

/// One chorda segment, or a half of a tie from its knot: pulls its two ends together when longer
/// than its rest length.
struct Cable {
  int start = 0;               ///< node: papillary head, branch point or knot
  std::vector<NodeShare> end;  ///< one branch point, or the zone of the leaflet where it inserts
  double rest_mm = 0.0;
  double stiffness_n_per_mm = 0.0;
  int chorda = 0, segment = 0;  ///< chorda -1: of tie `segment`
};

/// Nodes: the leaflet vertices, then one per chorda segment that ends in a branch point, then the
/// knots of ties, then the heads.
struct ClosureModel {
  int vertices = 0;
  Faces faces;
  std::vector<int> leaflet;  ///< |F|, one of kLeaflets (self_contact.h)
  Points rest_mm;            ///< |N| x 3, where nodes start
  Points target_mm;          ///< |N| x 3, where fixed nodes end (annulus and heads under pressure)
  std::vector<bool> fixed;   ///< |N|
  std::vector<double> mass_g;    ///< |N|
  std::vector<double> area_mm2;  ///< |V|, a third of the rest area of the faces around a vertex
  std::vector<std::array<int, 2>> edges;  ///< of the faces, each once, in ascending order
  std::vector<Spring> springs;            ///< one per edge, or none
  SheetLaw law;
  std::vector<Sheet> sheets;  ///< one per face, or none
  std::vector<Hinge> hinges;
  std::vector<ExponentialSheet> exponential_sheets;  ///< one per face, or none
  std::vector<Cable> cables;  ///< of chordae that are not ruptured, then of ties
  double pressure_mpa = 0.0;
  std::vector<double>
      load_share;               ///< |F|, of the pressure, that acts on each face; none: all of it
  double stable_step_ms = 0.0;  ///< Gershgorin bound of the symplectic Euler step without contact
};

/// @pre validate(valve) is empty.
ClosureModel make_closure_model(const Valve& valve, Membrane membrane = Membrane::Continuum);

/// Moves its targets to where annulus and papillary tips of that valve are under pressure; of a valve
/// that differs in nothing else from the model's own.
void set_targets(const Valve& valve, ClosureModel& model);

/// Edges of the chosen faces, each once, in ascending order.
std::vector<std::array<int, 2>> edges_of(const Faces& faces, const std::vector<int>& chosen);

/// Far end of a cable.
inline Vec3 end_position(const Cable& cable, const Points& x) {
  return mean_position(cable.end, x);
}

/// Tension of a cable, N, never negative.
double tension_n(const Cable& cable, const Points& x);

/// Adds the forces of springs, sheets, hinges and cables, N.
void add_elastic_forces(const ClosureModel& model, const Points& x, Points& force);

/// On a face, along its normal.
inline double load_mpa(const ClosureModel& model, Index face) {
  return model.load_share.empty()
             ? model.pressure_mpa
             : model.load_share[static_cast<std::size_t>(face)] * model.pressure_mpa;
}

/// Adds the pressure on each face, a third to each of its vertices, along the present face normal,
/// N.
void add_pressure_forces(const ClosureModel& model, const Points& x, Points& force);

}  // namespace coapt
