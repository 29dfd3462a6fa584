#include "lab/lattices/flat_space.h"

#include <algorithm>
#include <array>

namespace coapt {
namespace {

constexpr std::array kDecisions = {"ring",       "anterolateral", "posteromedial",
                                   "neochordae", "chordal",       "leaflet"};

std::string word(const Choice& choice, std::size_t decision) {
  const auto anchor = [](const std::optional<Anchor>& a) {
    return std::string(a ? to_string(*a) : "none");
  };
  switch (decision) {
    case 0:
      return choice.ring;
    case 1:
      return anchor(choice.anterolateral);
    case 2:
      return anchor(choice.posteromedial);
    case 3:
      return std::to_string(choice.neochordae);
    case 4:
      return std::to_string(static_cast<int>(choice.chordal));
    default:
      return std::to_string(static_cast<int>(choice.leaflet));
  }
}

std::string word(const Parameter& parameter) {
  const std::string index = "_" + std::to_string(parameter.index + 1);
  switch (parameter.of) {
    case ParameterOf::RingSize:
      return "ring_size";
    case ParameterOf::Movement:
      return "movement" + index;
    case ParameterOf::AnchorPlace:
      return "anchor_place" + index;
    case ParameterOf::NeochordaPlace:
      return "neochorda_place" + index;
    case ParameterOf::NeochordaLength:
      return "neochorda_length" + index;
    case ParameterOf::Shortening:
      return "shortening";
    case ParameterOf::LeafletWidth:
      return "leaflet_width";
    case ParameterOf::CleftWidth:
      return "cleft_width";
  }
  return "";
}

}  // namespace

FlatSpace::FlatSpace(const PlanSpace& space) : space_(space) {
  for (std::size_t d = 0; d < kDecisions.size(); ++d) {
    Decision decision;
    for (const Branch& branch : space.branches()) {
      const std::string value = word(branch.choice, d);
      if (std::find(decision.values.begin(), decision.values.end(), value) == decision.values.end())
        decision.values.push_back(value);
    }
    if (decision.values.size() > 1) {
      decision.variable = static_cast<int>(variables_.size());
      variables_.push_back({kDecisions[d], kDecisions[d] == std::string("neochordae"),
                            static_cast<int>(decision.values.size())});
    }
    decisions_.push_back(decision);
  }
  for (const Branch& branch : space.branches())
    for (const Parameter& parameter : branch.parameters) {
      if (parameter.count < 2) continue;
      const std::string name = word(parameter);
      const auto found = std::find_if(variables_.begin(), variables_.end(),
                                      [&](const FlatVariable& v) { return v.name == name; });
      if (found == variables_.end()) {
        variables_.push_back({name, true, parameter.count});
      } else {
        found->count = std::max(found->count, parameter.count);
      }
    }
}

std::optional<FlatSpace::Point> FlatSpace::point(const std::vector<int>& values) const {
  const auto is_chosen = [&](const Branch& branch) {
    for (std::size_t d = 0; d < decisions_.size(); ++d) {
      const Decision& decision = decisions_[d];
      if (decision.variable < 0) continue;
      const auto value =
          static_cast<std::size_t>(values[static_cast<std::size_t>(decision.variable)]);
      if (decision.values[value] != word(branch.choice, d)) return false;
    }
    return true;
  };
  const std::vector<Branch>& branches = space_.branches();
  const auto branch = std::find_if(branches.begin(), branches.end(), is_chosen);
  if (branch == branches.end()) return std::nullopt;
  Point point{static_cast<std::size_t>(branch - branches.begin()), {}};
  for (const Parameter& parameter : branch->parameters) {
    int at = 0;
    for (std::size_t v = 0; v < variables_.size(); ++v)
      if (variables_[v].name == word(parameter))
        at = values[v] * parameter.count / variables_[v].count;
    point.at.push_back(at);
  }
  return point;
}

}  // namespace coapt
