#include "search/preference/comparison.h"

#include <utility>

namespace coapt {

const char* to_string(Preference answer) {
  switch (answer) {
    case Preference::First:
      return "first";
    case Preference::Second:
      return "second";
    case Preference::Unable:
      return "unable";
  }
  return "";
}

Preference swapped(Preference answer) {
  switch (answer) {
    case Preference::First:
      return Preference::Second;
    case Preference::Second:
      return Preference::First;
    case Preference::Unable:
      return Preference::Unable;
  }
  return answer;
}

GivenAnswer in_order(const GivenAnswer& given) {
  if (given.pair.first <= given.pair.second) return given;
  return {{given.pair.of_case, given.pair.second, given.pair.first}, swapped(given.answer)};
}

CostTerms difference(const PlanPair& pair, const std::vector<PlanCase>& cases) {
  const auto terms = [&](int plan) -> const CostTerms& {
    const auto& plans = cases[static_cast<std::size_t>(pair.of_case)].plans;
    return plans[static_cast<std::size_t>(plan)].terms;
  };
  return {terms(pair.first).amounts - terms(pair.second).amounts};
}

}  // namespace coapt
