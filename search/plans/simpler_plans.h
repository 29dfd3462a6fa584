// Simpler and safer versions of a plan. A branch is climbed to one plan only, by what lasts longest; of plans that cannot be told apart the
// simplest comes first (plan_order.h), so it has to be asked, too, and so has the trigone, which the thesis found to be the better anchor; of plans
// that are acceptable those without a warning come first, and a larger ring is what most warnings ask for.
#pragma once

#include <vector>

#include "search/plans/rules.h"

namespace coapt {

/// Those that are others than the plan, and possible, the simplest first: without one of two sutures, there also with the next
/// shorter ring and the other suture to its trigone; without any suture, there also with the next two
/// smaller catalogue rings as far as practice undersizes; with sutures to the trigone in place of
/// other anchors, which move the muscle as far, at most kUsualMovement_mm; with a catalogue ring of the true size in place of a smaller one; with both.
/// What rules fix or forbid is left as it is.
std::vector<RepairPlan> simpler_plans(const Valve& valve, const RepairPlan& plan,
                                      const SearchRules& rules);

/// With the next larger catalogue rings, two at most, that the annulus takes: they open wider, and leave less of a posterior leaflet to push
/// forwards. What rules fix is left as it is.
std::vector<RepairPlan> safer_plans(const Valve& valve, const RepairPlan& plan,
                                    const SearchRules& rules);

/// The plan with the suture of that muscle to another anchor, moving the muscle as far, at most kUsualMovement_mm, its length on the lattice.
RepairPlan with_anchor(const Valve& valve, RepairPlan plan, Side side, Anchor anchor,
                       double lattice_mm);

}  // namespace coapt
