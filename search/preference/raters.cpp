#include "search/preference/raters.h"

#include <Eigen/Core>
#include <map>

namespace coapt {
namespace {

std::map<PlanPair, Preference> first_answers(const std::vector<GivenAnswer>& given) {
  std::map<PlanPair, Preference> answers;
  for (const GivenAnswer& of : given) {
    const GivenAnswer ordered = in_order(of);
    answers.emplace(ordered.pair, ordered.answer);
  }
  return answers;
}

}  // namespace

std::optional<double> consistency(const std::vector<GivenAnswer>& given) {
  std::map<PlanPair, Preference> before;
  int repeats = 0, alike = 0;
  for (const GivenAnswer& of : given) {
    const GivenAnswer ordered = in_order(of);
    const auto [first, is_new] = before.emplace(ordered.pair, ordered.answer);
    if (is_new) continue;
    ++repeats;
    if (first->second == ordered.answer) ++alike;
  }
  if (repeats == 0) return {};
  return static_cast<double>(alike) / repeats;
}

Agreement agreement(const std::vector<GivenAnswer>& one, const std::vector<GivenAnswer>& other) {
  const std::map<PlanPair, Preference> of_other = first_answers(other);
  Eigen::Matrix3d counts = Eigen::Matrix3d::Zero();  // answers of one x answers of the other
  for (const auto& [pair, answer] : first_answers(one))
    if (const auto found = of_other.find(pair); found != of_other.end())
      ++counts(static_cast<int>(answer), static_cast<int>(found->second));
  const double pairs = counts.sum();
  Agreement result;
  result.pairs = static_cast<int>(pairs);
  if (result.pairs == 0) return result;
  result.share = counts.trace() / pairs;
  const double by_chance =
      counts.rowwise().sum().dot(counts.colwise().sum().transpose()) / (pairs * pairs);
  if (by_chance < 1.0) result.kappa = (result.share - by_chance) / (1.0 - by_chance);
  return result;
}

}  // namespace coapt
