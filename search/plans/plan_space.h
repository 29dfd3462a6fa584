// All plans that a search may try: branches (discrete decisions, of the techniques that are offered) and within each a lattice of sizes,
// lengths and places.
// Sizes and movements, not lengths, are the axes: a suture's length follows from how far the muscle
// is to move under that ring, on the lattice of what can be tied.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "search/plans/offered_techniques.h"

namespace coapt {

class PlanSpace {
 public:
  /// @pre check_plan_space() is empty.
  /// @param diagnosis of the valve: what is indicated; none: everything is offered
  PlanSpace(const Valve& valve, const SearchRules& rules,
            const std::optional<Diagnosis>& diagnosis = {});

  /// Fewest steps first, then in a fixed order; empty if rules and diagnosis leave no plan: cut() says why.
  const std::vector<Branch>& branches() const { return branches_; }
  const std::vector<CutBranches>& cut() const { return cut_; }
  /// Of the valve.
  const LeafletCoordinates& coordinates() const { return coordinates_; }

  /// The plan at a point, its suture lengths within what the valve allows: neighbouring points at a
  /// border may be the same plan.
  RepairPlan plan(const Branch& branch, const LatticePoint& at) const;

 private:
  const RingedValve* ringed(const std::string& shape, double size) const;
  bool is_competent() const;
  std::vector<const Lesion*> held_by_neochordae(LeafletChoice leaflet) const;
  bool mends_rightly(const Choice& choice, bool all) const;
  void add_leaflet_step(RepairPlan& plan, LeafletChoice leaflet, double width_mm) const;
  Parameter ring_sizes(const std::string& shape) const;
  std::optional<Branch> make_branch(const Choice& choice) const;
  void add_suture(RepairPlan& plan, const RingedValve& ringed, Side side, Anchor anchor,
                  double movement_mm, double place) const;

  Valve valve_;
  SearchRules rules_;
  LeafletCoordinates coordinates_;
  std::optional<Diagnosis> diagnosis_;
  std::vector<Lesion> lesions_;
  std::map<std::pair<std::string, int>, RingedValve>
      ringed_;  // by shape and size in half millimetres
  std::vector<Branch> branches_;
  std::vector<CutBranches> cut_;
};

/// Those of check_rules(), or that what a fit left uncertain cannot be drawn. Rules that leave no plan are none: the space is empty then.
Errors check_plan_space(const Valve& valve, const SearchRules& rules);

}  // namespace coapt
