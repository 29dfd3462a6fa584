// How well the search does on lattices that are solved exhaustively: valves with a few thousand plans, each
// closed at the 17 nodes of the region by which a search chooses. By the rule that ranks (guide.h) each is opened and closed under
// further disease, too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lab/lattices/flat_space.h"
#include "search/plans/plan_search.h"

namespace coapt {

struct LatticeCase {
  std::string name;
  Valve valve;
  SearchRules rules;
  bool by_rule = false;  ///< score by the rule that ranks; else by price over the 17 nodes
};

/// An opening takes about as long as so many closures of a search.
inline constexpr int kOpeningClosures = 5;

/// The same with a third to a quarter of the plans, scored by the rule: sutures in steps of 2 mm, neochordae in steps of 8.
LatticeCase by_rule(LatticeCase lattice);

/// Six diseased valves: functional (both muscles), porcine-both, human-pm (one muscle, free anchors), ischaemic,
/// real (`real`: a measured one that leaks), flail-p2 (neochordae). 3,000 to 4,400 plans each.
std::vector<LatticeCase> lattice_cases(const Valve& real);

/// The plans of a lattice behind the combinations of its flat variables, the first fastest.
struct LatticePlans {
  std::vector<PlanRecord*> plans;  ///< each once, in the order met
  std::vector<int>
      numbers;  ///< of each combination; -1 where no plan is, or a rule of practice rejects it
};
LatticePlans plans_of(const PlanSpace& space, const FlatSpace& flat, PlanEvaluations& evaluations);

/// A lattice with the cost of every plan.
struct SolvedLattice {
  LatticeCase of;
  std::shared_ptr<const PlanSpace> space;
  std::shared_ptr<const FlatSpace> flat{};
  KnownPlans closures{};
  KnownOpenings openings{};      ///< where the rule scores
  double closures_a_plan = 0.0;  ///< mean, an opening as kOpeningClosures
  Evaluation before{};
  /// Of each combination of the flat space's variables, the first fastest; infinite where no plan is, or a
  /// rule of practice rejects it.
  std::vector<double> costs{};
  std::vector<int> plans{};            ///< number of each combination's plan
  std::vector<double> sorted_costs{};  ///< of all plans, each once, cheapest first
  double seconds = 0.0;
};

/// @param context its `known` are taken, its `keep` is told of every closure, `open` opens (open_plan() unless given). Nothing if cancelled.
std::optional<SolvedLattice> solve_lattice(const LatticeCase& lattice, int threads,
                                           const SearchContext& context);

/// One search of a solved lattice.
struct LatticeRun {
  std::vector<Progress> improvements;  ///< best cost at 17 nodes, by closures spent
  double winner =
      0.0;  ///< cost of the plan that came first in the end, by the rule of the best finalist
  int closures = 0;
};

/// Without a new closure. Threads: 1.
LatticeRun search_lattice(const SolvedLattice& lattice, const SearchOptions& options);

}  // namespace coapt
