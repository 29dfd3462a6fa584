#include "search/population/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/limits.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/counted.h"
#include "core/valve/leaflet_coordinates.h"
#include "search/plans/gates.h"
#include "search/plans/lesion.h"

namespace coapt {
namespace {

constexpr std::array kMovements_mm = {3.0, 6.0};
constexpr std::array kAnchors = {Anchor::IpsilateralTrigone, Anchor::SaddlePeak,
                                 Anchor::AnnulusPoint};
/// Half way between mid-posterior and the commissure of the muscle.
constexpr double kPosteriorAnchor_pm = 0.875, kPosteriorAnchor_al = 0.625;
constexpr std::array kLengthShares = {1.0, 0.9, 0.8};
/// Places about a lesion, along the free edge; the two nearest first.
constexpr std::array kNeochordaShifts = {-0.05, 0.05, -0.15, 0.15};
constexpr std::array kWedges_mm = {10.0, 15.0};
constexpr double kStitch_mm = 6.0;
const char* const kRingForProlapse = "generic-classic";

std::string anchor_words(Anchor anchor) {
  switch (anchor) {
    case Anchor::IpsilateralTrigone:
      return "trigone";
    case Anchor::SaddlePeak:
      return "saddle peak";
    case Anchor::AnnulusPoint:
      return "posterior annulus";
  }
  return "";
}

std::string ring_words(int sizes_below) {
  return sizes_below == 0 ? "own ring, not undersized"
                          : "own ring, " + counted(sizes_below, "size") + " below";
}

void add_rings(std::vector<CandidateRepair>& all) {
  for (int sizes = 0; sizes <= static_cast<int>(kMostSizesBelow); ++sizes)
    all.push_back(
        {.name = ring_words(sizes), .family = RepairFamily::OwnRing, .sizes_below = sizes});
  for (const RingShape& shape : kRingShapes)
    all.push_back({.name = std::string(shape.name) + " ring by the transverse diameter",
                   .family = RepairFamily::CatalogueRing,
                   .shape = std::string(shape.name)});
}

void add_sutures(std::vector<CandidateRepair>& all) {
  for (const bool ring : {false, true})
    for (const bool both : {false, true})
      for (const Anchor anchor : kAnchors)
        for (const double movement : kMovements_mm)
          all.push_back(
              {.name = std::string(both ? "both papillary muscles" : "posteromedial muscle") + " " +
                       std::to_string(static_cast<int>(movement)) + " mm towards the " +
                       anchor_words(anchor) + (ring ? ", " + ring_words(kRingBesideSutures) : ""),
               .family = ring ? RepairFamily::PapillaryAndRing : RepairFamily::Papillary,
               .sizes_below = ring ? kRingBesideSutures : 0,
               .anchor = anchor,
               .both_muscles = both,
               .movement_mm = movement});
}

void add_leaflet_repairs(std::vector<CandidateRepair>& all) {
  for (const int count : {2, 4})
    for (const double share : kLengthShares)
      all.push_back({.name = std::to_string(count) + " neochordae, " +
                             std::to_string(static_cast<int>(std::lround(100.0 * share))) +
                             " % of intact chordae, ring",
                     .family = RepairFamily::Neochordae,
                     .shape = kRingForProlapse,
                     .neochordae = count,
                     .length_share = share});
  all.push_back({.name = "edge-to-edge stitch, ring",
                 .family = RepairFamily::EdgeToEdge,
                 .shape = kRingForProlapse});
  all.push_back({.name = "clip alone", .family = RepairFamily::Clip});
  for (const double width : kWedges_mm)
    all.push_back(
        {.name = "triangular resection of " + std::to_string(static_cast<int>(width)) + " mm, ring",
         .family = RepairFamily::Resection,
         .shape = kRingForProlapse,
         .width_mm = width});
}

Annuloplasty ring_by_width(const std::string& shape, double transverse_mm) {
  const double sizes = std::floor(transverse_mm / kRingSizeStep_mm);
  return {CatalogueRing{shape,
                        std::clamp(kRingSizeStep_mm * sizes, kRingSizesMm.min, kRingSizesMm.max)}};
}

/// None beyond the own annulus or the largest of the catalogue.
std::optional<Annuloplasty> larger(const Annuloplasty& ring, int sizes) {
  if (const auto* own = std::get_if<OwnRing>(&ring.ring)) {
    if (own->sizes_below < sizes) return std::nullopt;
    return Annuloplasty{OwnRing{own->sizes_below - sizes}};
  }
  CatalogueRing catalogue = std::get<CatalogueRing>(ring.ring);
  catalogue.size_mm += kRingSizeStep_mm * sizes;
  if (catalogue.size_mm > kRingSizesMm.max) return std::nullopt;
  return Annuloplasty{catalogue};
}

/// The smallest ring from the wanted one upwards that practice does not reject; the wanted one if it rejects all.
Annuloplasty accepted_ring(const Annuloplasty& wanted, const Valve& valve) {
  for (int sizes = 0; const std::optional<Annuloplasty> ring = larger(wanted, sizes); ++sizes) {
    const RepairPlan plan{{*ring}};
    const Expected<Valve> ringed = apply_plan(valve, plan);
    if (ringed && !is_rejected(operation_gates({plan, valve, *ringed}))) return *ring;
  }
  return wanted;
}

/// Sutures that move their muscles so far, on the annulus as the plan's ring leaves it.
bool add_papillary(const CandidateRepair& candidate, const Valve& valve, RepairPlan& plan) {
  const Expected<Valve> ringed = apply_plan(valve, plan);
  if (!ringed) return false;
  for (const Side side : {Side::Posteromedial, Side::Anterolateral}) {
    if (side == Side::Anterolateral && !candidate.both_muscles) continue;
    PapillaryApproximation suture;
    suture.side = side;
    suture.anchor = candidate.anchor;
    suture.annulus_around = side == Side::Posteromedial ? kPosteriorAnchor_pm : kPosteriorAnchor_al;
    suture.suture_length_mm =
        (papillary_tip_mm(*ringed, side) - anchor_mm(*ringed, suture)).norm() -
        candidate.movement_mm;
    plan.steps.emplace_back(suture);
  }
  return true;
}

}  // namespace

const char* to_string(RepairFamily family) {
  switch (family) {
    case RepairFamily::OwnRing:
      return "own ring";
    case RepairFamily::CatalogueRing:
      return "catalogue ring";
    case RepairFamily::Papillary:
      return "papillary sutures";
    case RepairFamily::PapillaryAndRing:
      return "papillary sutures and ring";
    case RepairFamily::Neochordae:
      return "neochordae and ring";
    case RepairFamily::EdgeToEdge:
      return "edge-to-edge and ring";
    case RepairFamily::Clip:
      return "clip";
    case RepairFamily::Resection:
      return "resection and ring";
  }
  return "";
}

const std::vector<CandidateRepair>& candidate_repairs() {
  static const std::vector<CandidateRepair> kAll = [] {
    std::vector<CandidateRepair> all;
    add_rings(all);
    add_sutures(all);
    add_leaflet_repairs(all);
    return all;
  }();
  return kAll;
}

bool is_offered(const CandidateRepair& candidate, Aetiology aetiology) {
  const bool tethered = aetiology == Aetiology::Ischaemic || aetiology == Aetiology::Dilated;
  switch (candidate.family) {
    case RepairFamily::OwnRing:
    case RepairFamily::CatalogueRing:
    case RepairFamily::EdgeToEdge:
    case RepairFamily::Clip:
      return true;
    case RepairFamily::Papillary:
    case RepairFamily::PapillaryAndRing:
      return tethered;
    case RepairFamily::Neochordae:
    case RepairFamily::Resection:
      return !tethered;
  }
  return false;
}

CandidateSite candidate_site(const Valve& valve) {
  CandidateSite site{valve, transverse_diameter_mm(valve)};
  // Chordae that are too long are a lesion as well: as if P2's were ruptured.
  Valve unheld = valve;
  for (Chorda& chorda : unheld.chordae)
    if (chorda.kind == ChordaKind::Marginal && chorda.id.find("-P2-") != std::string::npos)
      chorda.ruptured = true;
  const LeafletCoordinates coordinates = leaflet_coordinates(unheld);
  const std::optional<Lesion> lesion = find_lesion(unheld, coordinates);
  if (!lesion) return site;
  site.lesion_along = lesion->middle;
  for (const double shift : kNeochordaShifts)
    site.neochordae.push_back(neochorda_at(unheld, coordinates, *lesion, lesion->middle + shift));
  return site;
}

std::optional<RepairPlan> candidate_plan(const CandidateRepair& candidate,
                                         const CandidateSite& site) {
  RepairPlan plan;
  if (!candidate.shape.empty())
    plan.steps.emplace_back(
        accepted_ring(ring_by_width(candidate.shape, site.transverse_mm), site.valve));
  else if (candidate.family == RepairFamily::OwnRing || candidate.sizes_below > 0)
    plan.steps.emplace_back(
        accepted_ring(Annuloplasty{OwnRing{candidate.sizes_below}}, site.valve));
  if (candidate.movement_mm > 0.0 && !add_papillary(candidate, site.valve, plan))
    return std::nullopt;
  if (candidate.neochordae > static_cast<int>(site.neochordae.size())) return std::nullopt;
  for (int i = 0; i < candidate.neochordae; ++i) {
    Neochorda neochorda = site.neochordae[static_cast<std::size_t>(i)];
    neochorda.length_mm *= candidate.length_share;
    plan.steps.emplace_back(neochorda);
  }
  if (candidate.family == RepairFamily::EdgeToEdge)
    plan.steps.emplace_back(EdgeToEdge{EdgeDevice::Stitch, site.lesion_along, kStitch_mm});
  if (candidate.family == RepairFamily::Clip)
    plan.steps.emplace_back(EdgeToEdge{.device = EdgeDevice::Clip, .along = site.lesion_along});
  if (candidate.family == RepairFamily::Resection)
    plan.steps.emplace_back(
        LeafletResection{.along = site.lesion_along, .width_mm = candidate.width_mm});
  return plan;
}

}  // namespace coapt
