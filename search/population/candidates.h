// The repairs that each valve of a population is offered: the same list for all, of which each aetiology is offered its own part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/repair/plan.h"
#include "search/population/population.h"

namespace coapt {

enum class RepairFamily {
  OwnRing,
  CatalogueRing,
  Papillary,
  PapillaryAndRing,
  Neochordae,  ///< with a ring, as those that follow but the clip
  EdgeToEdge,
  Clip,  ///< alone
  Resection
};
inline constexpr int kRepairFamilies = 8;
const char* to_string(RepairFamily family);  ///< in words

/// Fields that a family does not use keep their defaults.
struct CandidateRepair {
  std::string name;  ///< in words
  RepairFamily family = RepairFamily::OwnRing;
  int sizes_below = 0;
  std::string shape{};  ///< of the catalogue
  Anchor anchor = Anchor::IpsilateralTrigone;
  bool both_muscles = false;  ///< else the posteromedial one
  double movement_mm = 0.0;
  int neochordae = 0;
  double length_share = 1.0;  ///< of neochordae, over intact marginal chordae of the leaflet
  double width_mm = 0.0;      ///< of a resection
};

inline constexpr int kCandidates = 42;
/// Sizes below the own annulus of the ring that stands beside papillary sutures: what practice uses least.
inline constexpr int kRingBesideSutures = 2;

/// Own rings 0 to 4 sizes below first, in this order.
const std::vector<CandidateRepair>& candidate_repairs();

/// Rings, edge-to-edge and clip are for all; papillary sutures for tethered leaflets, neochordae and resection for prolapsing
/// ones.
bool is_offered(const CandidateRepair& candidate, Aetiology aetiology);

/// What makes plans of the candidates on one valve.
struct CandidateSite {
  const Valve& valve;
  double transverse_mm = 0.0;
  /// Of the posterior leaflet where P2 is held by nothing or by too much: places neochordae, edge-to-edge and resection.
  double lesion_along = 0.5;
  std::vector<Neochorda> neochordae{};  ///< four about the lesion, the two nearest first
};
CandidateSite candidate_site(const Valve& valve);

/// A ring that practice rejects gives way to the next larger one that it accepts. None where the valve does not allow the plan to
/// be put down.
std::optional<RepairPlan> candidate_plan(const CandidateRepair& candidate,
                                         const CandidateSite& site);

}  // namespace coapt
