#include "search/plans/plan_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/repair/apply_plan.h"
#include "core/repair/approximation.h"
#include "core/repair/limits.h"

namespace coapt {
namespace {

constexpr double kLeastMovement_mm = 2.0;  // less is not worth a suture
constexpr double kNormalTipToTrigone_mm =
    23.5;                             // mean of 57 cadavers: where a muscle is moved first
constexpr double kSpacing = 0.07;     // of `along`, between neochordae: 3 to 4 mm of the free edge
constexpr double kPlaceStep = 0.035;  // 2 mm of it
constexpr int kPlaces = 5;
constexpr double kNeochordaScope_mm = 8.0;     // either side of the usual length
constexpr Range kAnchorPlaces = {0.05, 0.35};  // beside the saddle peak to behind the commissure
constexpr double kAnchorPlaceStep = 0.025;     // 2 to 3 mm of the annulus
constexpr double kFirstAnchorPlace = 0.15;     // about the trigone
constexpr Range kShortenings_mm = {1.0, 6.0};
constexpr int kShortened = 2;  // chordae, one on either side of the lesion as a rule

Side side_of(int index) { return index == 0 ? Side::Anterolateral : Side::Posteromedial; }

int step_count(const Choice& choice) {
  return (choice.ring.empty() ? 0 : 1) + (choice.anterolateral ? 1 : 0) +
         (choice.posteromedial ? 1 : 0) + choice.neochordae +
         (choice.chordal == ChordalChoice::None ? 0 : 1);
}

}  // namespace

PlanSpace::PlanSpace(const Valve& valve, const std::vector<RingShape>& catalogue,
                     const SearchRules& rules)
    : valve_(valve),
      catalogue_(catalogue),
      rules_(rules),
      coordinates_(leaflet_coordinates(valve)),
      lesion_(find_lesion(valve, coordinates_)) {
  ringed_[{"", 0}] = {rules.fixed, *apply_plan(valve, rules.fixed, catalogue)};
  const std::vector<std::string> rings = offer_rings();
  const auto anterolateral = offer_anchors(Side::Anterolateral);
  const auto posteromedial = offer_anchors(Side::Posteromedial);
  const std::vector<int> neochordae = offer_neochordae();
  for (const std::string& ring : rings)
    for (const auto& al : anterolateral)
      for (const auto& pm : posteromedial)
        for (const int count : neochordae)
          for (const ChordalChoice chordal : offer_chordal())
            if (const auto branch = make_branch({ring, al, pm, count, chordal}))
              branches_.push_back(*branch);
  std::stable_sort(branches_.begin(), branches_.end(), [](const Branch& a, const Branch& b) {
    return step_count(a.choice) < step_count(b.choice);
  });
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
        anchor_distance_mm(valve_, {.side = side_of(index)}) - kNormalTipToTrigone_mm;
    parameters.push_back(make_parameter(ParameterOf::Movement, index,
                                        {kLeastMovement_mm, rules_.most_movement_mm},
                                        rules_.suture_lattice_mm, displaced_mm));
    if (*anchor == Anchor::AnnulusPoint)
      parameters.push_back(make_parameter(ParameterOf::AnchorPlace, index, kAnchorPlaces,
                                          kAnchorPlaceStep, kFirstAnchorPlace));
  }
  for (int k = 0; k < choice.neochordae; ++k) {
    const double usual =
        std::clamp(std::round(lesion_->length_mm), kUsualNeochordaMm.min, kUsualNeochordaMm.max);
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
  // The middle of every branch must be possible; single points beyond are found out when they are tried.
  if (!apply_plan(valve_, plan(branch, start_of(branch)), catalogue_)) return std::nullopt;
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
  double size = 0.0, shortening = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const Parameter& p = branch.parameters[k];
    const double value = p.lower + p.step * at[k];
    const auto index = static_cast<std::size_t>(p.index);
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
    }
  }
  const Ringed& base = *ringed(choice.ring, size);
  RepairPlan plan = base.plan;
  for (const std::size_t index : {0u, 1u}) {
    const auto& anchor = index == 0 ? choice.anterolateral : choice.posteromedial;
    if (anchor)
      add_suture(plan, base, side_of(static_cast<int>(index)), *anchor, movement[index],
                 place[index]);
  }
  for (int k = 0; k < choice.neochordae; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const double usual = lesion_->middle + kSpacing * (k - 0.5 * (choice.neochordae - 1));
    Neochorda step = neochorda_at(valve_, coordinates_, *lesion_, usual + shift[index]);
    step.length_mm = length[index];
    plan.steps.emplace_back(step);
  }
  const auto id = [this](int chorda) {
    return valve_.chordae[static_cast<std::size_t>(chorda)].id;
  };
  switch (choice.chordal) {
    case ChordalChoice::None:
      break;
    case ChordalChoice::CutStruts:
      for (const int chorda : anterior_struts(valve_, coordinates_))
        plan.steps.emplace_back(ChordalExcision{id(chorda)});
      break;
    case ChordalChoice::Shorten:
      for (const int chorda : chordae_beside(valve_, coordinates_, *lesion_, kShortened))
        plan.steps.emplace_back(ChordalLengthChange{id(chorda), -shortening});
      break;
    case ChordalChoice::Transfer:
      plan.steps.emplace_back(ChordalTransfer{id(chorda_opposite(valve_, coordinates_, *lesion_)),
                                              {lesion_->leaflet, lesion_->middle, 1.0}});
      break;
  }
  return plan;
}

}  // namespace coapt
