// What may be done to a valve: the techniques that rules allow and its diagnosis indicates, and why others are left out.
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
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "search/plans/branch.h"
#include "search/plans/lesion.h"
#include "search/plans/rules.h"

namespace coapt {

/// Branches of a kind that were not made, and why.
struct CutBranches {
  std::string what, why;
};

/// A valve with the fixed steps and a ring.
struct RingedValve {
  RepairPlan plan;
  Valve valve;
  double sizes_below = 0.0;
};

/// The choices of each decision. "", none, 0 and None stand for leaving it out.
struct OfferedTechniques {
  std::vector<std::string> rings;                                   ///< their shapes
  std::vector<std::optional<Anchor>> anterolateral, posteromedial;  ///< of papillary sutures
  std::vector<int> neochordae;
  std::vector<ChordalChoice> chordal;
  std::vector<LeafletChoice> leaflet;
  bool clefts = false;  ///< they are sutured
  std::map<std::pair<std::string, int>, RingedValve>
      ringed;  ///< by shape and size in half millimetres
  std::vector<CutBranches> cut;
};

/// @param lesions find_lesions() of all these
OfferedTechniques offer_techniques(const Valve& valve, const SearchRules& rules,
                                   const LeafletCoordinates& coordinates,
                                   const std::optional<Diagnosis>& diagnosis,
                                   const std::vector<Lesion>& lesions);

}  // namespace coapt
