// What a search may decide, and what is decided already.
#pragma once

#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "core/valve/problem_list.h"

namespace coapt {

/// Lattices are what can be tied or bought; rings come in their 2 mm sizes.
struct SearchRules {
  RepairPlan fixed;  ///< steps that every plan has, as they are: "a ring of size 30 is decided"
  /// Techniques that no plan has, each a word of forbidden_words() ("papillary_approximation"), or such a
  /// word with a colon and what of it ("papillary_approximation:saddle_peak", "annuloplasty:own").
  std::vector<std::string> forbidden;
  int most_neochordae = 4;             ///< [0, 4]
  bool chordal_length_change = false;  ///< of the marginal chordae beside a lesion
  bool chordal_excision = false;       ///< of the anterior leaflet's strut chordae
  bool chordal_transfer = false;       ///< to a lesion
  double suture_lattice_mm = 0.5;      ///< [0.1, 5]
  double neochorda_lattice_mm = 1.0;   ///< [0.5, 5]
  double most_movement_mm = 10.0;      ///< [2, 15] of a papillary muscle: more than 10 is unusual
};

/// Whether a technique, or one kind of it (may be empty), is forbidden.
bool is_forbidden(const SearchRules& rules, const std::string& technique, const std::string& kind);

/// Numbers out of range, words that say nothing, fixed steps that are impossible on this valve or are of a
/// forbidden kind. Paths point into the rules ("/forbidden/1", "/fixed/steps/0/size_mm").
Errors check_rules(const Valve& valve, const std::vector<RingShape>& catalogue,
                   const SearchRules& rules);

}  // namespace coapt
