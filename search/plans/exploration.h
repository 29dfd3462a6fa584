// Looks for good plans, from few closures a plan to many.
//
// 1. Starts: what practice would try first in every branch, and every size where that is all there
//    is to decide, cheapest operation first, one closure each; after every eight the best is
//    promoted to 17 nodes at once.
// 2. Brackets of successive halving (Jamieson and Talwalkar 2016): the best eight branches refine
//    their lattices with equal quotas, the better half goes on with twice as much, and so to two.
//    One of four is there for its bound, not for what it has shown.
// 3. After each round promotion: a plan goes from 1 to 5 to 17 nodes of the region as long as what
//    it is expected to cost there (climb_model.h), less the scatter of such expectations, is below
//    what is to be beaten. From bracket to bracket more scatter is granted.
// 4. Sharing: the sizes and movements of the best plans are tried in the branches that differ in
//    one decision.
// 5. Once: plans at random, for random search's line, and twelve of their better half on all rungs:
//    how far the few nodes, with the expectation, rank plans as the many do. Below 0.8 plans are
//    promoted more freely. (To start all plans at five nodes then was slower: 1,808 closures
//    instead of 1,417 to the best of a lattice within 0.1 mm2.)
// What the operation alone costs bounds a plan from below: a point whose bound is not below what is
// to be beaten is left out unclosed. Plans on different rungs are compared by what they are
// expected to cost; finalists over equal nodes.
//
// Every quota is fixed before it is spent, and batches have sizes of their own: no decision depends
// on the number of threads.
#pragma once

#include <vector>

#include "search/plans/exploration_state.h"

namespace coapt {

ExplorationState explore(const ExplorationInput& input);

/// Plans with the most nodes closed first, then the cheapest; the best of each branch before the
/// second of any. At most `count`.
std::vector<PlanRecord*> best_plans(const ExplorationState& state, int count);

/// All plans closed at kChosenBy nodes, in the order of trying.
std::vector<const PlanRecord*> scored_plans(const ExplorationState& state);

/// Uniform over the points of all branches, by the search's seed.
std::vector<BranchPoint> random_points(const ExplorationState& state, int count);

/// What trying plans at random is expected to reach after 1, 2, ... closures.
std::vector<Progress> random_progress(const ExplorationState& state);

/// From geometry alone to one node and from each rung to the next.
std::vector<LadderStep> ladder_of(const ExplorationState& state);

}  // namespace coapt
