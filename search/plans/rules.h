// What a search may decide, and what is decided already.
#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

inline constexpr std::size_t kMostShapes = 10;

/// Lattices are what can be tied or bought; rings come in their 2 mm sizes. Accepted ranges:
/// search_option_table.h.
struct SearchRules {
  RepairPlan fixed;  ///< steps that every plan has, as they are: "a ring of size 30 is decided"
  /// Techniques that no plan has, each by its name ("papillary_approximation"), or that
  /// with a colon and what of it ("papillary_approximation:saddle_peak", "annuloplasty:own").
  std::vector<std::string> forbidden;
  /// Offered beside those of the catalogue, in all sizes; at most kMostShapes.
  std::vector<DesignedShape> shapes{};
  /// The valve's own shape, smaller, which no maker has.
  bool own_ring = false;
  int most_neochordae = 4;
  /// Of the marginal chordae beside a lesion.
  bool chordal_length_change = false;
  /// Of the anterior leaflet's strut chordae, where leaflets are tethered.
  bool chordal_excision = false;
  /// To a lesion.
  bool chordal_transfer = false;
  /// Of the posterior leaflet where it prolapses. Sewing takes 0.2 to 0.5 s of a core a plan, a closure 0.01 s.
  bool leaflet_resection = false;
  /// A clip at a lesion.
  bool edge_to_edge = false;
  double suture_lattice_mm = 0.5;
  double neochorda_lattice_mm = 2.0;  ///< loops are made so
  /// Of a papillary muscle: more than 10 is unusual.
  double most_movement_mm = 10.0;
};

/// Whether a technique, or one kind of it (may be empty), is forbidden.
bool is_forbidden(const SearchRules& rules, const std::string& technique, const std::string& kind);

/// Numbers out of range, words that say nothing, fixed steps that are impossible on this valve or
/// are of a forbidden kind. Paths point into the rules ("/forbidden/1", "/fixed/steps/0/size_mm").
Errors check_rules(const Valve& valve, const SearchRules& rules);

}  // namespace coapt
