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
constexpr int kShortened = 2;  // chordae, one on either side of the lesion as a rule

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

double within(Range range, double value) { return std::clamp(value, range.min, range.max); }

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
  OfferedTechniques offers = offer_techniques(valve, rules_, coordinates_, diagnosis_, lesions_);
  ringed_.merge(offers.ringed);
  cut_ = std::move(offers.cut);
  // Of what is indicated, a surgeon leaves out neither the ring nor what prolapses, if rules let him.
  const bool needs_ring = diagnosis_ && offers.rings.size() > 1;
  const bool needs_mending = diagnosis_ && surely_prolapses(*diagnosis_) &&
                             (offers.neochordae.size() > 1 || offers.leaflet.size() > 1) &&
                             !has_step<Neochorda>(rules_.fixed) &&
                             !has_step<LeafletResection>(rules_.fixed) &&
                             !has_step<EdgeToEdge>(rules_.fixed);
  for (const std::string& ring : offers.rings)
    for (const auto& al : offers.anterolateral)
      for (const auto& pm : offers.posteromedial)
        for (const int count : offers.neochordae)
          for (const ChordalChoice chordal : offers.chordal)
            for (const LeafletChoice leaflet : offers.leaflet)
              if (const Choice choice{ring, al, pm, count, chordal, leaflet, offers.clefts};
                  (!ring.empty() || !needs_ring) && mends_rightly(choice, needs_mending))
                if (const auto branch = make_branch(choice)) branches_.push_back(*branch);
  std::stable_sort(branches_.begin(), branches_.end(), [](const Branch& a, const Branch& b) {
    return step_count(a.choice) < step_count(b.choice);
  });
}

/// And nothing was decided before.
bool PlanSpace::is_competent() const {
  return diagnosis_ && rules_.fixed.steps.empty() &&
         (diagnosis_->competent || !diagnosis_->competent_sure);
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

/// Lesions that are left to neochordae: a resection and the closure of commissures mend their own.
std::vector<const Lesion*> PlanSpace::held_by_neochordae(LeafletChoice leaflet) const {
  std::vector<const Lesion*> held;
  for (const Lesion& lesion : lesions_) {
    const bool mended = leaflet == LeafletChoice::CommissuralClosure
                            ? lesion.commissure.has_value()
                            : is_resection(leaflet) && &lesion == posterior_lesion(lesions_);
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
          .along = within(kResectionAlong, posterior_lesion(lesions_)->middle),
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

const RingedValve* PlanSpace::ringed(const std::string& shape, double size) const {
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

void PlanSpace::add_suture(RepairPlan& plan, const RingedValve& ringed, Side side, Anchor anchor,
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
  const RingedValve& base = *ringed(choice.ring, size);
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
