// All plans that a search may try: branches (discrete decisions, made by rules) and within each a
// lattice of sizes, lengths and places.
//
//   no operation      if the valve is competent, or may be
//   ring              with every repair (none where rules leave none); of the catalogue 3 : 4 for every valve, shorter ones for tethered leaflets, and each of
//                     SearchRules::shapes; up to 4 sizes below the true one (ring_sizing.h), none more than half a size wider than the annulus; the own shape on request
//   papillary suture  where leaflets are tethered, to trigone, saddle peak or a free point of the anterior annulus, for a displaced
//                     muscle: its tip further from its trigone than mean + sd of normal hearts
//                     (23.5, 3.8 mm; n = 57); first moved to where that mean is
//   neochordae        0 to 4 where segments prolapse (3.6 per patient), as many at each lesion (a run of adjacent segments of a
//                     leaflet), each with its place and length; or
//   resection         on request, where the posterior leaflet prolapses: triangular or quadrangular with sliding, with its width; other
//                     lesions then have neochordae
//   closure           of a commissure whose both scallops prolapse: a stitch over 4 to 12 mm (assumed); what 65 of 128 such
//                     operations were ("Mitral valve repair for commissural prolapse", 1992 to 2004); other lesions then have neochordae
//   cleft sutures     with every repair, where clefts leak: over 4 to 14 mm (assumed) of both edges from the root on
//   chordal steps     on request: strut chordae cut where leaflets are tethered; chordae beside a lesion shortened; one transferred
//   clip              on request, from edge to edge at the highest lesion, with its width
// Without a diagnosis every ring and suture is offered, and neochordae where marginal chordae are ruptured.
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
  struct Ringed {
    RepairPlan plan;  // fixed steps and the ring
    Valve valve;
    double sizes_below = 0.0;
  };
  const Ringed* ringed(const std::string& shape, double size) const;
  bool is_indicated(CarpentierType type) const;
  bool is_competent() const;
  std::vector<std::string> offer_rings();
  std::vector<std::optional<Anchor>> offer_anchors(Side side);
  std::vector<int> offer_neochordae();
  std::vector<ChordalChoice> offer_chordal();
  std::vector<LeafletChoice> offer_leaflet();
  bool sutures_clefts();
  std::string why_no_lesion() const;
  const Lesion* posterior_lesion() const;
  std::vector<const Lesion*> held_by_neochordae(LeafletChoice leaflet) const;
  bool mends_rightly(const Choice& choice, bool all) const;
  void add_leaflet_step(RepairPlan& plan, LeafletChoice leaflet, double width_mm) const;
  Parameter ring_sizes(const std::string& shape) const;
  std::optional<Branch> make_branch(const Choice& choice) const;
  void add_suture(RepairPlan& plan, const Ringed& ringed, Side side, Anchor anchor,
                  double movement_mm, double place) const;

  Valve valve_;
  SearchRules rules_;
  LeafletCoordinates coordinates_;
  std::optional<Diagnosis> diagnosis_;
  std::vector<Lesion> lesions_;
  std::map<std::pair<std::string, int>, Ringed> ringed_;  // by shape and size in half millimetres
  std::vector<Branch> branches_;
  std::vector<CutBranches> cut_;
};

/// Those of check_rules(), or that what a fit left uncertain cannot be drawn. Rules that leave no plan are none: the space is empty then.
Errors check_plan_space(const Valve& valve, const SearchRules& rules);

}  // namespace coapt
