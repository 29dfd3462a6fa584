#include "clients/python/engine/space.h"

#include <stdexcept>
#include <utility>

#include "clients/python/engine/problems.h"
#include "core/closed/closed_valve.h"
#include "core/closed/diagnosis.h"
#include "core/repair/apply_plan.h"
#include "io/json/parse_json.h"
#include "io/json/plan_json.h"
#include "io/json/search_options_json.h"
#include "search/plans/place_model.h"
#include "search/plans/plan_evaluations.h"

namespace coapt {
namespace {

std::string name_of(const Parameter& parameter, const Choice& choice) {
  const std::string side = parameter.index == 0 ? "anterolateral" : "posteromedial";
  const std::string number = std::to_string(parameter.index + 1);
  switch (parameter.of) {
    case ParameterOf::RingSize:
      return choice.ring == kOwnShape ? "ring_sizes_below" : "ring_size_mm";
    case ParameterOf::Movement:
      return side + "_movement_mm";
    case ParameterOf::AnchorPlace:
      return side + "_anchor_place";
    case ParameterOf::NeochordaPlace:
      return "neochorda_" + number + "_shift";
    case ParameterOf::NeochordaLength:
      return "neochorda_" + number + "_length_mm";
    case ParameterOf::Shortening:
      return "shortening_mm";
    case ParameterOf::LeafletWidth:
      return "leaflet_width_mm";
    case ParameterOf::CleftWidth:
      return "cleft_width_mm";
  }
  return {};
}

std::string word(ChordalChoice choice) {
  switch (choice) {
    case ChordalChoice::None:
      return "none";
    case ChordalChoice::CutStruts:
      return "cut struts";
    case ChordalChoice::Shorten:
      return "shorten";
    case ChordalChoice::Transfer:
      return "transfer";
  }
  return {};
}

std::string word(LeafletChoice choice) {
  switch (choice) {
    case LeafletChoice::None:
      return "none";
    case LeafletChoice::Triangular:
      return "triangular resection";
    case LeafletChoice::Quadrangular:
      return "quadrangular resection";
    case LeafletChoice::Clip:
      return "clip";
    case LeafletChoice::CommissuralClosure:
      return "commissural closure";
  }
  return {};
}

std::string word(const std::optional<Anchor>& anchor) {
  return anchor ? to_string(*anchor) : "none";
}

Json branch_json(const Branch& branch) {
  const Choice& choice = branch.choice;
  Json parameters = Json::array();
  for (const Parameter& p : branch.parameters)
    parameters.push_back({{"name", name_of(p, choice)},
                          {"lower", p.lower},
                          {"step", p.step},
                          {"count", p.count},
                          {"start", p.start}});
  return {{"ring", choice.ring.empty() ? "none" : choice.ring},
          {"anterolateral", word(choice.anterolateral)},
          {"posteromedial", word(choice.posteromedial)},
          {"neochordae", std::to_string(choice.neochordae)},
          {"chordal", word(choice.chordal)},
          {"leaflet", word(choice.leaflet)},
          {"parameters", std::move(parameters)}};
}

/// @throws std::out_of_range
RepairPlan checked_plan(const LocalSpace& space, int branch, const LatticePoint& at) {
  const auto& branches = space.space->branches();
  const Branch& of = branches.at(static_cast<std::size_t>(branch));
  if (at.size() != of.parameters.size()) throw std::out_of_range("no point of this branch");
  for (std::size_t k = 0; k < at.size(); ++k)
    if (at[k] < 0 || at[k] >= of.parameters[k].count)
      throw std::out_of_range("no point of this branch");
  return space.space->plan(of, at);
}

std::vector<Eigen::VectorXd> vectors(const std::vector<std::vector<double>>& rows) {
  std::vector<Eigen::VectorXd> made;
  for (const std::vector<double>& row : rows)
    made.emplace_back(Eigen::Map<const Eigen::VectorXd>(row.data(), std::ssize(row)));
  return made;
}

}  // namespace

LocalSpace space_of(const LocalValve& valve, std::string_view search, bool indicated) {
  const SearchOptions options = taken(search_options_from_json(taken(parse_json(search))));
  std::optional<Diagnosis> diagnosis;
  if (indicated) {
    const ClosedValve closed = close_and_measure(*valve.valve);
    diagnosis = diagnose(closed.valve, closed.closure, closed.measure);
  }
  // The rules leave no plan, or nothing is indicated.
  const auto refuse = [](Errors errors) -> Expected<LocalSpace> { return errors; };
  if (Errors errors = check_plan_space(*valve.valve, options.rules); !errors.empty())
    return taken(refuse(std::move(errors)), "/rules");
  LocalSpace made{valve.valve,
                  std::make_shared<const PlanSpace>(*valve.valve, options.rules, diagnosis)};
  if (!made.space->branches().empty()) return made;
  std::string why;
  for (const CutBranches& cut : made.space->cut()) why += "; " + cut.what + ": " + cut.why;
  return taken(refuse({{ErrorCode::ImpossibleStep, "", "leave no plan to try" + why}}), "/rules");
}

std::string space_document(const LocalSpace& space) {
  Json branches = Json::array(), cut = Json::array();
  for (const Branch& branch : space.space->branches()) branches.push_back(branch_json(branch));
  for (const CutBranches& one : space.space->cut())
    cut.push_back({{"what", one.what}, {"why", one.why}});
  return Json{{"branches", std::move(branches)}, {"cut", std::move(cut)}}.dump();
}

std::string plan_at(const LocalSpace& space, int branch, const LatticePoint& at) {
  return to_json(checked_plan(space, branch, at)).dump();
}

std::vector<double> place_at(const LocalSpace& space, int branch, const LatticePoint& at) {
  const RepairPlan plan = checked_plan(space, branch, at);
  const Expected<Valve> repaired = apply_plan(*space.valve, plan, space.space->coordinates());
  if (!repaired) return {};
  const Eigen::VectorXd place = place_of(*repaired, plan);
  return {place.begin(), place.end()};
}

Guesses guess(const std::vector<std::vector<double>>& places, const std::vector<double>& values,
              double usual_sd, const std::vector<std::vector<double>>& at) {
  const PlaceModel model(vectors(places),
                         Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)),
                         usual_sd);
  Guesses guesses;
  for (const Eigen::VectorXd& place : vectors(at)) {
    const PlaceModel::Guess told = model.at(place);
    guesses.mean.push_back(told.mean);
    guesses.sd.push_back(told.sd);
  }
  return guesses;
}

}  // namespace coapt
