// All plans that a search may try: branches (discrete decisions, made by rules) and within each a
// lattice of sizes, lengths and places.
//
//   ring              none; the own shape 1 to 4 sizes below; each catalogue shape and each of
//                     SearchRules::shapes, its sizes 0 to 4 below
//   papillary suture  to trigone, saddle peak or a free point of the annulus, for a displaced
//                     muscle: its tip further from its trigone than mean + sd of normal hearts
//                     (23.5, 3.8 mm; n = 57); first moved to where that mean is
//   neochordae        0 to 4 where marginal chordae are ruptured (3.6 per patient), each with its
//                     place and length
//   chordal steps     on request: strut chordae cut; chordae beside a lesion shortened; one
//                     transferred
//   leaflet           on request, at a lesion: a triangular resection; of the posterior leaflet also a
//                     quadrangular one with sliding; a clip from edge to edge; each with its width
// Sizes and movements, not lengths, are the axes: a suture's length follows from how far the muscle
// is to move under that ring, on the lattice of what can be tied.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "search/plans/branch.h"
#include "search/plans/lesion.h"
#include "search/plans/rules.h"

namespace coapt {

/// Branches of a kind that were not made, and why.
struct CutBranches {
  std::string what, why;
};

class PlanSpace {
 public:
  /// @pre check_rules() is empty.
  PlanSpace(const Valve& valve, const SearchRules& rules);

  /// Fewest steps first, then in a fixed order; empty if nothing is left to decide. Doing nothing
  /// at all is no branch.
  const std::vector<Branch>& branches() const { return branches_; }
  const std::vector<CutBranches>& cut() const { return cut_; }

  /// The plan at a point, its suture lengths within what the valve allows: neighbouring points at a
  /// border may be the same plan.
  RepairPlan plan(const Branch& branch, const LatticePoint& at) const;

 private:
  struct Ringed {
    RepairPlan plan;  // fixed steps and the ring
    Valve valve;
  };
  const Ringed* ringed(const std::string& shape, double size) const;
  std::vector<std::string> offer_rings();
  std::vector<std::optional<Anchor>> offer_anchors(Side side);
  std::vector<int> offer_neochordae();
  std::vector<ChordalChoice> offer_chordal();
  std::vector<LeafletChoice> offer_leaflet();
  void add_leaflet_step(RepairPlan& plan, LeafletChoice leaflet, double width_mm) const;
  Parameter ring_sizes(const std::string& shape) const;
  std::optional<Branch> make_branch(const Choice& choice) const;
  void add_suture(RepairPlan& plan, const Ringed& ringed, Side side, Anchor anchor,
                  double movement_mm, double place) const;

  Valve valve_;
  SearchRules rules_;
  LeafletCoordinates coordinates_;
  std::optional<Lesion> lesion_;
  std::map<std::pair<std::string, int>, Ringed> ringed_;  // by shape and size in half millimetres
  std::vector<Branch> branches_;
  std::vector<CutBranches> cut_;
};

/// Errors are those of check_rules(), or that the rules leave no plan to try, and why.
Expected<PlanSpace> make_plan_space(const Valve& valve, const SearchRules& rules);

}  // namespace coapt
