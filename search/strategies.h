// What kinds of plans are worth trying on this valve: the discrete part of the search, by rules.
//
//   ring              none; the own shape; each catalogue shape; 0 to 4 sizes below
//                     (in practice 2 to 4)
//   papillary suture  to the trigone or the saddle peak, for a displaced muscle: its tip further
//                     from its trigone than mean + sd of normal hearts (23.5, sd 3.8 mm; n = 57)
//   neochordae        none, 2 or 4, where marginal chordae are ruptured (3.6 per patient)
// A functional valve starts with a ring two sizes below, one with ruptured chordae with a true-sized
// one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/repair/plan.h"

namespace coapt {

/// The discrete decisions of a plan.
struct Choice {
  std::optional<Annuloplasty> ring;
  std::optional<Anchor> anterolateral, posteromedial;  ///< sutures
  int neochordae = 0;                                  ///< 0, 2 or 4
};

/// A length that is still free. It lies on a lattice of what can be tied or bought: lower + k x
/// lattice.
struct Parameter {
  std::vector<std::size_t> steps;  ///< of the plan: a suture, or neochordae that share the length
  double lower_mm = 0.0, upper_mm = 0.0, start_mm = 0.0, lattice_mm = 0.5;
};

struct Strategy {
  Choice choice;
  RepairPlan plan;  ///< with every parameter at its start
  std::vector<Parameter> parameters;
};

/// Every choice that makes sense, fewest steps first, then in a fixed order; never empty.
std::vector<Choice> sensible_choices(const Valve& valve, const std::vector<RingShape>& catalogue);

/// The same choice with the ring one size larger and one smaller, where there is such a ring.
std::vector<Choice> ring_neighbours(const Valve& valve, const std::vector<RingShape>& catalogue,
                                    const Choice& choice);

/// The choice with its lengths, all of which are possible; nothing if the ring does not fit, a suture
/// has no room to pull or the valve takes no more chordae.
std::optional<Strategy> make_strategy(const Valve& valve, const std::vector<RingShape>& catalogue,
                                      const Choice& choice);

/// The plan at a lattice point: parameter k has the length lower + at[k] x lattice.
RepairPlan plan_at(const Strategy& strategy, const std::vector<int>& at);

/// Lattice points of a parameter.
int lattice_size(const Parameter& parameter);

/// Nearest lattice point to a length.
int lattice_index(const Parameter& parameter, double length_mm);

}  // namespace coapt
