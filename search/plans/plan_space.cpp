#include "search/plans/plan_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/edge_to_edge.h"
#include "core/repair/limits.h"
#include "core/repair/ring_sizing.h"
#include "core/repair/rings.h"
#include "core/valve/annulus_frame.h"
#include "core/valve/counted.h"
#include "core/valve/number_text.h"
#include "search/fit/fitted_draw.h"

namespace coapt {
namespace {

constexpr double kLeastMovement_mm = 3.0;  // less is the error of execution: 5 degrees at 33 mm
constexpr double kSpacing = 0.07;     // of `along`, between neochordae: 3 to 4 mm of the free edge
constexpr double kPlaceStep = 0.035;  // 2 mm of it
constexpr int kPlaces = 5;
constexpr double kNeochordaScope_mm = 8.0;     // either side of the usual length
constexpr Range kAnchorPlaces = {0.05, 0.25};  // beside the saddle peak to the commissure
constexpr double kAnchorPlaceStep = 0.025;     // 2 to 3 mm of the annulus
constexpr double kFirstAnchorPlace = 0.15;     // about the trigone
constexpr Range kShortenings_mm = {1.0, 6.0};
// Bases of wedges are 10 to 15 mm as a rule, clips 4 to 6 mm wide.
struct LeafletWidths {
  Range range_mm;
  double first_mm;
};
constexpr LeafletWidths kTriangular = {{6.0, 16.0}, 12.0}, kQuadrangular = {{8.0, 20.0}, 12.0},
                        kClip = {{4.0, 10.0}, 6.0}, kCommissural = {{4.0, 12.0}, 8.0};
constexpr Range kCleftWidths_mm = {4.0, 14.0};
constexpr double kLeafletWidthStep_mm = 2.0;
constexpr double kDegenerativeRing =
    0.75;                      // AP over transverse; shorter rings are made for tethered leaflets
constexpr int kShortened = 2;  // chordae, one on either side of the lesion as a rule
constexpr const char* kNotTethered = "the leaflets are not tethered";

std::string ring_called(const std::string& shape) {
  return shape == kOwnShape ? "ring of the annulus's own shape" : shape + " ring";
}

Side side_of(int index) { return index == 0 ? Side::Anterolateral : Side::Posteromedial; }

int step_count(const Choice& choice) {
  return (choice.ring.empty() ? 0 : 1) + (choice.anterolateral ? 1 : 0) +
         (choice.posteromedial ? 1 : 0) + choice.neochordae +
         (choice.chordal == ChordalChoice::None ? 0 : 1) +
         (choice.leaflet == LeafletChoice::None ? 0 : 1) + (choice.clefts ? 1 : 0);
}

bool is_resection(LeafletChoice leaflet) {
  return leaflet == LeafletChoice::Triangular || leaflet == LeafletChoice::Quadrangular;
}

/// Mends some lesions itself and leaves others to neochordae; a clip does for all.
bool mends_its_own(LeafletChoice leaflet) {
  return is_resection(leaflet) || leaflet == LeafletChoice::CommissuralClosure;
}

std::optional<LeafletWidths> widths_of(LeafletChoice leaflet) {
  switch (leaflet) {
    case LeafletChoice::None:
      return std::nullopt;
    case LeafletChoice::Triangular:
      return kTriangular;
    case LeafletChoice::Quadrangular:
      return kQuadrangular;
    case LeafletChoice::Clip:
      return kClip;
    case LeafletChoice::CommissuralClosure:
      return kCommissural;
  }
  return std::nullopt;
}

/// Commissures of which both scallops prolapse.
std::vector<Side> commissures_of(const std::vector<Lesion>& lesions) {
  std::vector<Side> sides;
  for (const Side side : {Side::Anterolateral, Side::Posteromedial})
    if (std::any_of(lesions.begin(), lesions.end(),
                    [side](const Lesion& lesion) { return lesion.commissure == side; }))
      sides.push_back(side);
  return sides;
}

template <class Step>
bool has_step(const RepairPlan& plan) {
  return std::any_of(plan.steps.begin(), plan.steps.end(),
                     [](const RepairStep& step) { return std::holds_alternative<Step>(step); });
}

double within(Range range, double value) { return std::clamp(value, range.min, range.max); }

std::string in_mm(double value) { return with_decimals(value, 1) + " mm"; }

}  // namespace

PlanSpace::PlanSpace(const Valve& valve, const SearchRules& rules,
                     const std::optional<Diagnosis>& diagnosis)
    : valve_(valve),
      rules_(rules),
      coordinates_(leaflet_coordinates(valve)),
      diagnosis_(diagnosis),
      lesions_(find_lesions(valve, coordinates_, diagnosis)) {
  ringed_[{"", 0}] = {rules.fixed, *apply_plan(valve, rules.fixed, coordinates_), 0.0};
  if (is_competent()) {
    branches_.push_back({});
    if (diagnosis_->competent_sure) {
      cut_.push_back({"all repairs", "the valve is competent"});
      return;
    }
  }
  const std::vector<std::string> rings = offer_rings();
  const auto anterolateral = offer_anchors(Side::Anterolateral);
  const auto posteromedial = offer_anchors(Side::Posteromedial);
  const std::vector<int> neochordae = offer_neochordae();
  const std::vector<ChordalChoice> chordals = offer_chordal();
  const std::vector<LeafletChoice> leaflets = offer_leaflet();
  const bool clefts = sutures_clefts();
  // Of what is indicated, a surgeon leaves out neither the ring nor what prolapses, if rules let him.
  const bool needs_ring = diagnosis_ && rings.size() > 1;
  const bool needs_mending =
      diagnosis_ && diagnosis_->type_sure && may_be(*diagnosis_, CarpentierType::II) &&
      (neochordae.size() > 1 || leaflets.size() > 1) && !has_step<Neochorda>(rules_.fixed) &&
      !has_step<LeafletResection>(rules_.fixed) && !has_step<EdgeToEdge>(rules_.fixed);
  for (const std::string& ring : rings)
    for (const auto& al : anterolateral)
      for (const auto& pm : posteromedial)
        for (const int count : neochordae)
          for (const ChordalChoice chordal : chordals)
            for (const LeafletChoice leaflet : leaflets)
              if (const Choice choice{ring, al, pm, count, chordal, leaflet, clefts};
                  (!ring.empty() || !needs_ring) && mends_rightly(choice, needs_mending))
                if (const auto branch = make_branch(choice)) branches_.push_back(*branch);
  std::stable_sort(branches_.begin(), branches_.end(), [](const Branch& a, const Branch& b) {
    return step_count(a.choice) < step_count(b.choice);
  });
}

bool PlanSpace::is_indicated(CarpentierType type) const {
  return !diagnosis_ || may_be(*diagnosis_, type);
}

/// And nothing was decided before.
bool PlanSpace::is_competent() const {
  return diagnosis_ && rules_.fixed.steps.empty() &&
         (diagnosis_->competent || !diagnosis_->competent_sure);
}

std::vector<std::string> PlanSpace::offer_rings() {
  if (has_step<Annuloplasty>(rules_.fixed)) {
    cut_.push_back({"other rings", "the ring is fixed"});
    return {""};
  }
  std::vector<std::string> offered = {""};
  const auto try_ring = [&](const Annuloplasty& step, double size) {
    RepairPlan plan = rules_.fixed;
    plan.steps.emplace_back(step);
    const Expected<Valve> valve = apply_plan(valve_, plan, coordinates_);
    const double below = valve ? ring_sizes_below(valve_, *valve) : 0.0;
    if (!valve || below > kMostSizesBelow) return false;
    ringed_[{shape_of(step), static_cast<int>(std::lround(2.0 * size))}] = {plan, *valve, below};
    return true;
  };
  const auto offer = [&](const std::string& shape, const std::vector<double>& sizes) {
    if (is_forbidden(rules_, "annuloplasty", shape)) {
      cut_.push_back({ring_called(shape), "forbidden"});
    } else if (sizes.empty()) {
      cut_.push_back({ring_called(shape), "no size is within " + shown(kMostSizesBelow) +
                                              " sizes of the true size of " +
                                              in_mm(true_ring_size_mm(valve_)) +
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
    cut_.push_back(
        {ring_called(kOwnShape), "no manufacturer offers it; it is available on request"});
  }
  for (const RingShape& shape : kRingShapes) {
    const std::string name(shape.name);
    if (shape.ap_over_transverse < kDegenerativeRing && !is_indicated(CarpentierType::IIIb)) {
      cut_.push_back({ring_called(name), kNotTethered});
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

/// Starts at the true size, or where rings are made smaller as a rule: for tethered leaflets.
Parameter PlanSpace::ring_sizes(const std::string& shape) const {
  const bool true_size = !lesions_.empty() || (diagnosis_ && !diagnosis_->clefts.empty());
  const double usual = true_size ? 0.0 : kUsualSizesBelow.min;
  double first = 1e9, last = -1e9, start = 0.0, nearest = 1e9;
  for (const auto& [key, ringed] : ringed_) {
    if (key.first != shape) continue;
    const double size = 0.5 * key.second;
    first = std::min(first, size);
    last = std::max(last, size);
    if (const double off = std::abs(ringed.sizes_below - usual); off < nearest) {
      nearest = off;
      start = size;
    }
  }
  return make_parameter(ParameterOf::RingSize, 0, {first, last},
                        shape == kOwnShape ? 1.0 : kRingSizeStep_mm, start);
}

std::vector<std::optional<Anchor>> PlanSpace::offer_anchors(Side side) {
  const std::string what = std::string("suture of the ") + to_string(side) + " muscle";
  if (suture_of(rules_.fixed, side) != nullptr) {
    cut_.push_back({what, "its suture is fixed"});
    return {std::nullopt};
  }
  if (is_forbidden(rules_, "papillary_approximation", to_string(side))) {
    cut_.push_back({what, "forbidden"});
    return {std::nullopt};
  }
  if (!is_indicated(CarpentierType::IIIb)) {
    cut_.push_back({what, kNotTethered});
    return {std::nullopt};
  }
  const double distance = anchor_distance_mm(valve_, {.side = side});
  if (distance <= kMostNormalTipToTrigone_mm) {
    cut_.push_back({what, "the papillary muscle is not displaced: " + in_mm(distance) +
                              " from its trigone, up to " + in_mm(kMostNormalTipToTrigone_mm) +
                              " is normal"});
    return {std::nullopt};
  }
  std::vector<std::optional<Anchor>> anchors = {std::nullopt};
  for (const Anchor anchor : {Anchor::IpsilateralTrigone, Anchor::SaddlePeak, Anchor::AnnulusPoint})
    if (is_forbidden(rules_, "papillary_approximation", to_string(anchor))) {
      cut_.push_back({what + " to " + to_string(anchor), "forbidden"});
    } else {
      anchors.push_back(anchor);
    }
  return anchors;
}

std::vector<int> PlanSpace::offer_neochordae() {
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
    cut_.push_back({"neochordae", why});
    return {0};
  }
  std::vector<int> counts;
  for (int count = 0; count <= rules_.most_neochordae; count += each) counts.push_back(count);
  return counts;
}

std::vector<ChordalChoice> PlanSpace::offer_chordal() {
  std::vector<ChordalChoice> offered = {ChordalChoice::None};
  const Lesion* const lesion = lesions_.empty() ? nullptr : &lesions_.front();
  const auto offer = [&](ChordalChoice choice, const std::string& what, const std::string& why) {
    if (why.empty())
      offered.push_back(choice);
    else
      cut_.push_back({what, why});
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

std::string PlanSpace::why_no_lesion() const {
  return diagnosis_ ? "no segment prolapses" : "no marginal chorda is ruptured";
}

std::vector<LeafletChoice> PlanSpace::offer_leaflet() {
  std::vector<LeafletChoice> offered = {LeafletChoice::None};
  const Lesion* const posterior = posterior_lesion();
  if (has_step<LeafletResection>(rules_.fixed)) {
    cut_.push_back({"another resection", "a resection is fixed"});
  } else if (is_forbidden(rules_, "leaflet_resection", "")) {
    cut_.push_back({"resection", "forbidden"});
  } else if (!rules_.leaflet_resection) {
    cut_.push_back({"resection", "available on request"});
  } else if (posterior == nullptr) {
    cut_.push_back({"resection", lesions_.empty() ? why_no_lesion()
                                                  : "the posterior leaflet does not prolapse"});
  } else {
    for (const auto& [shape, choice] :
         {std::pair(ResectionShape::Triangular, LeafletChoice::Triangular),
          std::pair(ResectionShape::Quadrangular, LeafletChoice::Quadrangular)})
      if (is_forbidden(rules_, "leaflet_resection", to_string(shape)) ||
          is_forbidden(rules_, "leaflet_resection", to_string(Leaflet::Posterior)))
        cut_.push_back({std::string(to_string(shape)) + " resection", "forbidden"});
      else
        offered.push_back(choice);
  }
  if (has_step<EdgeToEdge>(rules_.fixed))
    cut_.push_back({"another clip", "an edge-to-edge repair is fixed"});
  else if (is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::Clip)))
    cut_.push_back({"clip", "forbidden"});
  else if (!rules_.edge_to_edge)
    cut_.push_back({"clip", "available on request"});
  else if (lesions_.empty())
    cut_.push_back({"clip", why_no_lesion()});
  else
    offered.push_back(LeafletChoice::Clip);
  if (commissures_of(lesions_).empty() || has_step<EdgeToEdge>(rules_.fixed)) return offered;
  if (is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::Stitch)))
    cut_.push_back({"closure of a commissure", "forbidden"});
  else
    offered.push_back(LeafletChoice::CommissuralClosure);
  return offered;
}

/// Wherever the diagnosis finds clefts that leak.
bool PlanSpace::sutures_clefts() {
  if (!diagnosis_ || diagnosis_->clefts.empty() || has_step<EdgeToEdge>(rules_.fixed)) return false;
  const bool forbidden = is_forbidden(rules_, "edge_to_edge", to_string(EdgeDevice::CleftSuture));
  if (forbidden) cut_.push_back({"suture of clefts", "forbidden"});
  return !forbidden;
}

/// Of the posterior leaflet; null if it has none.
const Lesion* PlanSpace::posterior_lesion() const {
  const auto found = std::find_if(lesions_.begin(), lesions_.end(), [](const Lesion& lesion) {
    return lesion.leaflet == Leaflet::Posterior;
  });
  return found == lesions_.end() ? nullptr : &*found;
}

/// Lesions that are left to neochordae: a resection and the closure of commissures mend their own.
std::vector<const Lesion*> PlanSpace::held_by_neochordae(LeafletChoice leaflet) const {
  std::vector<const Lesion*> held;
  for (const Lesion& lesion : lesions_) {
    const bool mended = leaflet == LeafletChoice::CommissuralClosure
                            ? lesion.commissure.has_value()
                            : is_resection(leaflet) && &lesion == posterior_lesion();
    if (!mended) held.push_back(&lesion);
  }
  return held;
}

/// All lesions, or none; nothing twice.
bool PlanSpace::mends_rightly(const Choice& choice, bool all) const {
  const bool others = !held_by_neochordae(choice.leaflet).empty();
  if (choice.neochordae > 0 && !others) return false;
  if (!all) return true;
  if (mends_its_own(choice.leaflet)) return !others || choice.neochordae > 0;
  return choice.neochordae > 0 || choice.leaflet != LeafletChoice::None ||
         choice.chordal != ChordalChoice::None;
}

void PlanSpace::add_leaflet_step(RepairPlan& plan, LeafletChoice leaflet, double width_mm) const {
  switch (leaflet) {
    case LeafletChoice::None:
      return;
    case LeafletChoice::Triangular:
    case LeafletChoice::Quadrangular:
      plan.steps.emplace_back(LeafletResection{
          .shape = leaflet == LeafletChoice::Triangular ? ResectionShape::Triangular
                                                        : ResectionShape::Quadrangular,
          .along = within(kResectionAlong, posterior_lesion()->middle),
          .width_mm = width_mm});
      return;
    case LeafletChoice::Clip:
      plan.steps.emplace_back(
          EdgeToEdge{EdgeDevice::Clip, within(kEdgeAlong, lesions_.front().middle), width_mm});
      return;
    case LeafletChoice::CommissuralClosure:
      for (const Side side : commissures_of(lesions_))
        plan.steps.emplace_back(commissural_closure(valve_, coordinates_, side, width_mm));
      return;
  }
}

const PlanSpace::Ringed* PlanSpace::ringed(const std::string& shape, double size) const {
  const auto found = ringed_.find({shape, static_cast<int>(std::lround(2.0 * size))});
  return found == ringed_.end() ? nullptr : &found->second;
}

std::optional<Branch> PlanSpace::make_branch(const Choice& choice) const {
  if (step_count(choice) == 0 && rules_.fixed.steps.empty()) return std::nullopt;
  Branch branch{choice, {}};
  auto& parameters = branch.parameters;
  if (!choice.ring.empty()) parameters.push_back(ring_sizes(choice.ring));
  for (const int index : {0, 1}) {
    const auto& anchor = index == 0 ? choice.anterolateral : choice.posteromedial;
    if (!anchor) continue;
    const double displaced_mm =
        anchor_distance_mm(valve_, {.side = side_of(index)}) - kTipToTrigone_mm;
    parameters.push_back(make_parameter(ParameterOf::Movement, index,
                                        {kLeastMovement_mm, rules_.most_movement_mm},
                                        rules_.suture_lattice_mm, displaced_mm));
    if (*anchor == Anchor::AnnulusPoint)
      parameters.push_back(make_parameter(ParameterOf::AnchorPlace, index, kAnchorPlaces,
                                          kAnchorPlaceStep, kFirstAnchorPlace));
  }
  const std::vector<const Lesion*> held = held_by_neochordae(choice.leaflet);
  for (int k = 0; k < choice.neochordae; ++k) {
    const double lattice = rules_.neochorda_lattice_mm;
    const double usual =
        within(kUsualNeochordaMm, lattice * std::round(held[k % held.size()]->length_mm / lattice));
    parameters.push_back(
        make_parameter(ParameterOf::NeochordaLength, k,
                       {std::max(kUsualNeochordaMm.min, usual - kNeochordaScope_mm),
                        std::min(kUsualNeochordaMm.max, usual + kNeochordaScope_mm)},
                       rules_.neochorda_lattice_mm, usual));
    const double reach = kPlaceStep * (kPlaces / 2);
    parameters.push_back(
        make_parameter(ParameterOf::NeochordaPlace, k, {-reach, reach}, kPlaceStep, 0.0));
  }
  if (choice.chordal == ChordalChoice::Shorten)
    parameters.push_back(make_parameter(ParameterOf::Shortening, 0, kShortenings_mm, 1.0, 2.0));
  if (const std::optional<LeafletWidths> widths = widths_of(choice.leaflet))
    parameters.push_back(make_parameter(ParameterOf::LeafletWidth, 0, widths->range_mm,
                                        kLeafletWidthStep_mm, widths->first_mm));
  if (choice.clefts) {
    double deepest_mm = 0.0;
    for (const Cleft& cleft : diagnosis_->clefts) deepest_mm = std::max(deepest_mm, cleft.depth_mm);
    parameters.push_back(make_parameter(ParameterOf::CleftWidth, 0, kCleftWidths_mm,
                                        kLeafletWidthStep_mm, deepest_mm + kLeafletWidthStep_mm));
  }
  // The middle of every branch must be possible; single points beyond are found out when they are
  // tried.
  if (!apply_plan(valve_, plan(branch, start_of(branch)), coordinates_)) return std::nullopt;
  return branch;
}

void PlanSpace::add_suture(RepairPlan& plan, const Ringed& ringed, Side side, Anchor anchor,
                           double movement_mm, double place) const {
  PapillaryApproximation suture{.side = side, .anchor = anchor};
  if (anchor == Anchor::AnnulusPoint) {
    const double turn = side == Side::Anterolateral ? 0.25 + place : 0.25 - place;
    suture.annulus_around = turn < 0.0 ? turn + 1.0 : turn;
  }
  const double distance = anchor_distance_mm(ringed.valve, suture);
  const Range accepted = suture_range_mm(distance);
  const double lattice = rules_.suture_lattice_mm;
  const double least = std::ceil(accepted.min / lattice);
  const double most = std::floor(accepted.max / lattice);
  suture.suture_length_mm =
      least > most
          ? accepted.max  // no length of the lattice will do
          : lattice * std::clamp(std::round((distance - movement_mm) / lattice), least, most);
  plan.steps.emplace_back(suture);
}

RepairPlan PlanSpace::plan(const Branch& branch, const LatticePoint& at) const {
  const Choice& choice = branch.choice;
  std::array<double, 2> movement{}, place{};
  std::array<double, 4> shift{}, length{};
  double size = 0.0, shortening = 0.0, leaflet_width = 0.0, cleft_width = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Parameter& p = branch.parameters[k];
    const double value = p.lower + p.step * at[k];
    const int index = p.index;
    switch (p.of) {
      case ParameterOf::RingSize:
        size = value;
        break;
      case ParameterOf::Movement:
        movement[index] = value;
        break;
      case ParameterOf::AnchorPlace:
        place[index] = value;
        break;
      case ParameterOf::NeochordaPlace:
        shift[index] = value;
        break;
      case ParameterOf::NeochordaLength:
        length[index] = value;
        break;
      case ParameterOf::Shortening:
        shortening = value;
        break;
      case ParameterOf::LeafletWidth:
        leaflet_width = value;
        break;
      case ParameterOf::CleftWidth:
        cleft_width = value;
        break;
    }
  }
  const Ringed& base = *ringed(choice.ring, size);
  RepairPlan plan = base.plan;
  for (const int index : {0, 1}) {
    const auto& anchor = index == 0 ? choice.anterolateral : choice.posteromedial;
    if (anchor) add_suture(plan, base, side_of(index), *anchor, movement[index], place[index]);
  }
  const std::vector<const Lesion*> held = held_by_neochordae(choice.leaflet);
  for (std::size_t k = 0; k < static_cast<std::size_t>(choice.neochordae); ++k) {
    // In turn at each lesion, over the whole of it; what is left over goes to the first ones.
    const std::size_t lesions = held.size();
    const Lesion& lesion = *held[k % lesions];
    const double count =
        static_cast<double>((choice.neochordae - k % lesions + lesions - 1) / lesions);
    const double spacing =
        count > 1.0 ? std::max(kSpacing, 2.0 * lesion.reach / (count - 1.0)) : kSpacing;
    const double nth = static_cast<double>(k / lesions);
    const double usual = lesion.middle + spacing * (nth - 0.5 * (count - 1.0));
    Neochorda step = neochorda_at(valve_, coordinates_, lesion, usual + shift[k]);
    step.length_mm = length[k];
    plan.steps.emplace_back(step);
  }
  add_leaflet_step(plan, choice.leaflet, leaflet_width);
  if (choice.clefts)
    for (const Cleft& cleft : diagnosis_->clefts)
      plan.steps.emplace_back(
          EdgeToEdge{EdgeDevice::CleftSuture, within(kEdgeAlong, cleft.along), cleft_width});
  const auto id = [this](int chorda) { return valve_.chordae[chorda].id; };
  switch (choice.chordal) {
    case ChordalChoice::None:
      break;
    case ChordalChoice::CutStruts:
      for (const int chorda : anterior_struts(valve_, coordinates_))
        plan.steps.emplace_back(ChordalExcision{id(chorda)});
      break;
    case ChordalChoice::Shorten:
      for (const int chorda : chordae_beside(valve_, coordinates_, lesions_.front(), kShortened))
        plan.steps.emplace_back(ChordalLengthChange{id(chorda), -shortening});
      break;
    case ChordalChoice::Transfer:
      plan.steps.emplace_back(
          ChordalTransfer{id(chorda_opposite(valve_, coordinates_, lesions_.front())),
                          {lesions_.front().leaflet, lesions_.front().middle, 1.0}});
      break;
  }
  return plan;
}

Errors check_plan_space(const Valve& valve, const SearchRules& rules) {
  if (Errors errors = check_rules(valve, rules); !errors.empty()) return errors;
  return check_fitted_parameters(valve);
}

}  // namespace coapt
