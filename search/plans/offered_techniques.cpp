#include "search/plans/offered_techniques.h"

#include <algorithm>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "core/repair/rings.h"
#include "core/valve/counted.h"
#include "core/valve/number_text.h"

namespace coapt {
namespace {

constexpr double kDegenerativeRing =
    0.75;  // AP over transverse; shorter rings are made for tethered leaflets
constexpr const char* kNotTethered = "the leaflets are not tethered";

std::string ring_called(const std::string& shape) {
  return shape == kOwnShape ? "ring of the annulus's own shape" : shape + " ring";
}

std::string in_mm(double value) { return with_decimals(value, 1) + " mm"; }

class Offering {
 public:
  Offering(const Valve& valve, const SearchRules& rules, const LeafletCoordinates& coordinates,
           const std::optional<Diagnosis>& diagnosis, const std::vector<Lesion>& lesions)
      : valve_(valve),
        rules_(rules),
        coordinates_(coordinates),
        diagnosis_(diagnosis),
        lesions_(lesions) {}
  OfferedTechniques all();

 private:
  bool is_indicated(CarpentierType type) const;
  std::string why_no_short_ring() const;  ///< empty: there may be one
  std::vector<std::string> offer_rings();
  std::vector<std::optional<Anchor>> offer_anchors(Side side);
  std::vector<int> offer_neochordae();
  std::vector<ChordalChoice> offer_chordal();
  std::vector<LeafletChoice> offer_leaflet();
  bool sutures_clefts();
  std::string why_no_lesion() const;

  const Valve& valve_;
  const SearchRules& rules_;
  const LeafletCoordinates& coordinates_;
  const std::optional<Diagnosis>& diagnosis_;
  const std::vector<Lesion>& lesions_;
  OfferedTechniques offers_;
};

OfferedTechniques Offering::all() {
  offers_.rings = offer_rings();
  offers_.anterolateral = offer_anchors(Side::Anterolateral);
  offers_.posteromedial = offer_anchors(Side::Posteromedial);
  offers_.neochordae = offer_neochordae();
  offers_.chordal = offer_chordal();
  offers_.leaflet = offer_leaflet();
  offers_.clefts = sutures_clefts();
  return std::move(offers_);
}

bool Offering::is_indicated(CarpentierType type) const {
  return !diagnosis_ || may_be(*diagnosis_, type);
}

std::string Offering::why_no_short_ring() const {
  if (!is_indicated(CarpentierType::IIIb)) return kNotTethered;
  return diagnosis_ && surely_prolapses(*diagnosis_) ? "a segment prolapses besides" : "";
}

std::vector<std::string> Offering::offer_rings() {
  if (has_step<Annuloplasty>(rules_.fixed)) {
    offers_.cut.push_back({"other rings", "the ring is fixed"});
    return {""};
  }
  std::vector<std::string> offered = {""};
  const auto try_ring = [&](const Annuloplasty& step, double size) {
    RepairPlan plan = rules_.fixed;
    plan.steps.emplace_back(step);
    const Expected<Valve> valve = apply_plan(valve_, plan, coordinates_);
    const double below = valve ? ring_sizes_below(valve_, *valve) : 0.0;
    if (!valve || below > kMostSizesBelow) return false;
    offers_.ringed[{shape_of(step), static_cast<int>(std::lround(2.0 * size))}] = {plan, *valve,
                                                                                   below};
    return true;
  };
  const auto offer = [&](const std::string& shape, const std::vector<double>& sizes) {
    if (is_forbidden(rules_, "annuloplasty", shape)) {
      offers_.cut.push_back({ring_called(shape), "forbidden"});
    } else if (sizes.empty()) {
      offers_.cut.push_back({ring_called(shape),
                             "no size is within " + shown(kMostSizesBelow) +
                                 " sizes of the true size of " + in_mm(true_ring_size_mm(valve_)) +
                                 " and at most half a size wider than the annulus"});
    } else {
      offered.push_back(shape);
    }
  };
  std::vector<double> sizes;
  if (rules_.own_ring || !diagnosis_ || is_forbidden(rules_, "annuloplasty", kOwnShape)) {
    for (int below = 1; below <= static_cast<int>(kMostSizesBelow); ++below)
      if (try_ring({OwnRing{below}}, below)) sizes.push_back(below);
    offer(kOwnShape, sizes);
  } else {
    offers_.cut.push_back(
        {ring_called(kOwnShape), "no manufacturer offers it; it is available on request"});
  }
  for (const RingShape& shape : kRingShapes) {
    const std::string name(shape.name);
    const bool is_short = shape.ap_over_transverse < kDegenerativeRing;
    if (const std::string why = is_short ? why_no_short_ring() : ""; !why.empty()) {
      offers_.cut.push_back({ring_called(name), why});
      continue;
    }
    sizes.clear();
    for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
      if (!is_too_wide(valve_, ring_width_mm(shape, size)) &&
          try_ring({CatalogueRing{name, size}}, size))
        sizes.push_back(size);
    }
    offer(name, sizes);
  }
  for (const DesignedShape& shape : rules_.shapes) {
    sizes.clear();
    for (double size = kRingSizesMm.min; size <= kRingSizesMm.max; size += kRingSizeStep_mm) {
      if (!is_too_wide(valve_, size) && try_ring({DesignedRing{shape, size}}, size))
        sizes.push_back(size);
    }
    offer(shape.name, sizes);
  }
  return offered;
}

std::vector<std::optional<Anchor>> Offering::offer_anchors(Side side) {
  const std::string what = std::string("suture of the ") + to_string(side) + " muscle";
  if (suture_of(rules_.fixed, side) != nullptr) {
    offers_.cut.push_back({what, "its suture is fixed"});
    return {std::nullopt};
  }
  if (is_forbidden(rules_, "papillary_approximation", to_string(side))) {
    offers_.cut.push_back({what, "forbidden"});
    return {std::nullopt};
  }
  if (!is_indicated(CarpentierType::IIIb)) {
    offers_.cut.push_back({what, kNotTethered});
    return {std::nullopt};
  }
  const double distance = anchor_distance_mm(valve_, {.side = side});
  if (distance <= kMostNormalTipToTrigone_mm) {
    offers_.cut.push_back({what, "the papillary muscle is not displaced: " + in_mm(distance) +
                                     " from its trigone, up to " +
                                     in_mm(kMostNormalTipToTrigone_mm) + " is normal"});
    return {std::nullopt};
  }
  std::vector<std::optional<Anchor>> anchors = {std::nullopt};
  for (const Anchor anchor : {Anchor::IpsilateralTrigone, Anchor::SaddlePeak, Anchor::AnnulusPoint})
    if (is_forbidden(rules_, "papillary_approximation", to_string(anchor))) {
      offers_.cut.push_back({what + " to " + to_string(anchor), "forbidden"});
    } else {
      anchors.push_back(anchor);
    }
  return anchors;
}

std::vector<int> Offering::offer_neochordae() {
  std::string why;
  const int each = static_cast<int>(lesions_.size());
  if (lesions_.empty()) why = why_no_lesion();
  if (rules_.most_neochordae < each)
    why = counted(each, "lesion") + " cannot be mended with at most " +
          counted(rules_.most_neochordae, "neochorda", "neochordae");
  for (const Lesion& lesion : lesions_)
    if (is_forbidden(rules_, "neochorda", to_string(lesion.leaflet))) why = "forbidden";
  if (rules_.most_neochordae == 0) why = "not allowed by the rules";
  if (!why.empty()) {
    offers_.cut.push_back({"neochordae", why});
    return {0};
  }
  std::vector<int> counts;
  for (int count = 0; count <= rules_.most_neochordae; count += each) counts.push_back(count);
  return counts;
}

std::vector<ChordalChoice> Offering::offer_chordal() {
  std::vector<ChordalChoice> offered = {ChordalChoice::None};
  const Lesion* const lesion = lesions_.empty() ? nullptr : &lesions_.front();
  const auto offer = [&](ChordalChoice choice, const std::string& what, const std::string& why) {
    if (why.empty())
      offered.push_back(choice);
    else
      offers_.cut.push_back({what, why});
  };
  const auto asked = [&](bool on_request, const char* technique) -> std::string {
    if (is_forbidden(rules_, technique, "")) return "forbidden";
    return on_request ? "" : "available on request";
  };
  const auto at_lesion = [&](std::string why, bool has_chorda, const char* none) {
    if (why.empty() && lesion == nullptr) why = why_no_lesion();
    return why.empty() && !has_chorda ? none : why;
  };
  std::string cutting = asked(rules_.chordal_excision, "chordal_excision");
  if (cutting.empty() && !is_indicated(CarpentierType::IIIb)) cutting = kNotTethered;
  if (cutting.empty() && anterior_struts(valve_, coordinates_).empty())
    cutting = "the anterior leaflet has no strut chordae";
  offer(ChordalChoice::CutStruts, "cutting of strut chordae", cutting);
  offer(ChordalChoice::Shorten, "shortening of chordae",
        at_lesion(asked(rules_.chordal_length_change, "chordal_length_change"),
                  lesion != nullptr && !chordae_beside(valve_, coordinates_, *lesion, 1).empty(),
                  "no intact marginal chorda is beside the lesion"));
  offer(ChordalChoice::Transfer, "transfer of a chorda",
        at_lesion(asked(rules_.chordal_transfer, "chordal_transfer"),
                  lesion != nullptr && chorda_opposite(valve_, coordinates_, *lesion) >= 0,
                  "no intact marginal chorda is opposite the lesion"));
  return offered;
}

std::string Offering::why_no_lesion() const {
  return diagnosis_ ? "no segment prolapses" : "no marginal chorda is ruptured";
}

std::vector<LeafletChoice> Offering::offer_leaflet() {
  std::vector<LeafletChoice> offered = {LeafletChoice::None};
  const Lesion* const posterior = posterior_lesion(lesions_);
  if (has_step<LeafletResection>(rules_.fixed)) {
    offers_.cut.push_back({"another resection", "a resection is fixed"});
  } else if (is_forbidden(rules_, "leaflet_resection", "")) {
    offers_.cut.push_back({"resection", "forbidden"});
  } else if (!rules_.leaflet_resection) {
    offers_.cut.push_back({"resection", "available on request"});
  } else if (posterior == nullptr) {
    offers_.cut.push_back({"resection", lesions_.empty()
                                            ? why_no_lesion()
                                            : "the posterior leaflet does not prolapse"});
  } else {
    for (const auto& [shape, choice] :
         {std::pair(ResectionShape::Triangular, LeafletChoice::Triangular),
          std::pair(ResectionShape::Quadrangular, LeafletChoice::Quadrangular)})
      if (is_forbidden(rules_, "leaflet_resection", to_string(shape)) ||
          is_forbidden(rules_, "leaflet_resection", to_string(Leaflet::Posterior)))
        offers_.cut.push_back({std::string(to_string(shape)) + " resection", "forbidden"});
      else
        offered.push_back(choice);
  }
  if (has_step<EdgeToEdge>(rules_.fixed))
    offers_.cut.push_back({"another clip", "an edge-to-edge repair is fixed"});
  else if (is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::Clip)))
    offers_.cut.push_back({"clip", "forbidden"});
  else if (!rules_.edge_to_edge)
    offers_.cut.push_back({"clip", "available on request"});
  else if (lesions_.empty())
    offers_.cut.push_back({"clip", why_no_lesion()});
  else
    offered.push_back(LeafletChoice::Clip);
  if (commissures_of(lesions_).empty() || has_step<EdgeToEdge>(rules_.fixed)) return offered;
  if (is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::Stitch)))
    offers_.cut.push_back({"closure of a commissure", "forbidden"});
  else
    offered.push_back(LeafletChoice::CommissuralClosure);
  return offered;
}

/// Wherever the diagnosis finds clefts that leak.
bool Offering::sutures_clefts() {
  if (!diagnosis_ || diagnosis_->clefts.empty() || has_step<EdgeToEdge>(rules_.fixed)) return false;
  const bool forbidden = is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::CleftSuture));
  if (forbidden) offers_.cut.push_back({"suture of clefts", "forbidden"});
  return !forbidden;
}

}  // namespace

OfferedTechniques offer_techniques(const Valve& valve, const SearchRules& rules,
                                   const LeafletCoordinates& coordinates,
                                   const std::optional<Diagnosis>& diagnosis,
                                   const std::vector<Lesion>& lesions) {
  return Offering(valve, rules, coordinates, diagnosis, lesions).all();
}

}  // namespace coapt
