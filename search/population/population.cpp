#include "search/population/population.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>
#include <random>

#include "core/closure/closure.h"
#include "core/metrics/measure.h"
#include "core/valve/problem_list.h"
#include "search/plans/objective.h"
#include "search/population/population_factors.h"
#include "search/population/truncated_normal.h"
#include "search/random_share.h"

namespace coapt {
namespace {

constexpr double kLeastEigenvalue =
    1e-6;  // of a correlation matrix: below, no Cholesky factor is to be trusted

/// Seeds of neighbouring members must not be alike (splitmix64, Steele 2014).
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9E3779B97F4A7C15u;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
  return value ^ (value >> 31);
}

void check_distribution(ProblemList& problems, const std::string& path,
                        const PriorDistribution& distribution, const PopulationFactor& factor) {
  const Range accepted{factor.min, factor.max};
  check_range(problems, path + "/mean", distribution.mean, accepted);
  check_range(problems, path + "/min", distribution.min, accepted);
  check_range(problems, path + "/max", distribution.max, accepted);
  check_range(problems, path + "/sd", distribution.sd, {0.0, factor.max - factor.min});
  if (distribution.min > distribution.mean || distribution.mean > distribution.max)
    problems.add(ErrorCode::OutOfRange, path + "/mean", "must be from min to max");
}

LesionValues draw_lesions(const AetiologyPrior& aetiology, std::mt19937_64& engine) {
  LesionValues values = no_lesions();
  for (const PriorFactor& lesion : aetiology.lesions)
    values[static_cast<std::size_t>(lesion.factor)] =
        truncated_normal(lesion.distribution, normal_share(engine));
  return values;
}

const AetiologyPrior& draw_aetiology(const PopulationPrior& prior, double share) {
  double sum = 0.0;
  for (const AetiologyPrior& aetiology : prior.aetiologies) sum += aetiology.share;
  double left = share * sum;
  for (const AetiologyPrior& aetiology : prior.aetiologies) {
    if (left < aetiology.share) return aetiology;
    left -= aetiology.share;
  }
  return prior.aetiologies.back();
}

enum class Judged { Invalid, Untrusted, Competent, Leaking };

Judged judge(const Expected<Valve>& valve, double& leak) {
  if (!valve) return Judged::Invalid;
  const ClosureResult closure = close_valve(*valve);
  if (!trusted(closure)) return Judged::Untrusted;
  leak = measure_leak(*valve, closure.closed_mm).area_mm2;
  if (!std::isfinite(leak)) return Judged::Untrusted;
  return leak <= kMildLeak_mm2 ? Judged::Competent : Judged::Leaking;
}

/// Whether an anatomy is one to give a disease; counts it.
bool count_anatomy(Judged judged, DrawCounts& draws) {
  ++draws.anatomies;
  draws.anatomies_invalid += judged == Judged::Invalid;
  draws.anatomies_untrusted += judged == Judged::Untrusted;
  draws.anatomies_leaking += judged == Judged::Leaking;
  return judged == Judged::Competent;
}

bool count_lesions(Judged judged, DrawCounts& draws) {
  ++draws.lesions;
  draws.lesions_invalid += judged == Judged::Invalid;
  draws.lesions_untrusted += judged == Judged::Untrusted;
  draws.lesions_competent += judged == Judged::Competent;
  return judged == Judged::Leaking;
}

std::string name_of(const PopulationMember& member) {
  return std::string(to_string(member.aetiology)) + "-" + std::to_string(member.index);
}

}  // namespace

const char* to_string(Aetiology aetiology) {
  switch (aetiology) {
    case Aetiology::Ischaemic:
      return "ischaemic";
    case Aetiology::Dilated:
      return "dilated";
    case Aetiology::P2Flail:
      return "p2_flail";
    case Aetiology::Barlow:
      return "barlow";
  }
  return "";
}

Eigen::MatrixXd correlation_matrix(const PopulationPrior& prior) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(kAnatomyFactors, kAnatomyFactors);
  for (const PriorCorrelation& pair : prior.correlations)
    matrix(pair.first, pair.second) = matrix(pair.second, pair.first) = pair.r;
  return matrix;
}

Errors check_prior(const PopulationPrior& prior) {
  ProblemList problems;
  for (const PriorFactor& factor : prior.anatomy) {
    const PopulationFactor& known = anatomy_factors()[static_cast<std::size_t>(factor.factor)];
    check_distribution(problems, std::string("/anatomy/") + known.name, factor.distribution, known);
  }
  for (std::size_t i = 0; i < prior.correlations.size(); ++i) {
    const PriorCorrelation& pair = prior.correlations[i];
    const std::string path = "/correlations/" + std::to_string(i);
    check_range(problems, path + "/r", pair.r, {-0.99, 0.99});
    if (pair.first == pair.second)
      problems.add(ErrorCode::BadReference, path + "/second", "is the first, must be another one");
  }
  if (problems.empty() &&
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(correlation_matrix(prior)).eigenvalues()[0] <
          kLeastEigenvalue)
    problems.add(ErrorCode::OutOfRange, "/correlations",
                 "contradict each other: their matrix is not positive definite");
  if (prior.aetiologies.empty())
    problems.add(ErrorCode::OutOfRange, "/aetiologies", "is empty, must contain at least one");
  for (std::size_t i = 0; i < prior.aetiologies.size(); ++i) {
    const AetiologyPrior& aetiology = prior.aetiologies[i];
    const std::string path = "/aetiologies/" + std::to_string(i);
    check_range(problems, path + "/share", aetiology.share, {1e-6, 1e6});
    for (const PriorFactor& lesion : aetiology.lesions) {
      const PopulationFactor& known = lesion_factors()[static_cast<std::size_t>(lesion.factor)];
      check_distribution(problems, path + "/lesions/" + known.name, lesion.distribution, known);
    }
  }
  return std::move(problems).take();
}

AnatomyValues draw_anatomy(const PopulationPrior& prior, std::mt19937_64& engine) {
  const Eigen::MatrixXd factor_of_r = correlation_matrix(prior).llt().matrixL();
  Eigen::VectorXd independent(kAnatomyFactors);
  for (double& value : independent) value = normal_share(engine);
  const Eigen::VectorXd correlated = factor_of_r * independent;
  AnatomyValues values = usual_anatomy();
  for (const PriorFactor& factor : prior.anatomy)
    values[static_cast<std::size_t>(factor.factor)] =
        truncated_normal(factor.distribution, correlated[factor.factor]);
  return values;
}

Expected<PopulationMember> member(const PopulationPrior& prior, std::uint64_t seed, int index) {
  std::mt19937_64 engine(mixed(mixed(seed) + static_cast<std::uint64_t>(index)));
  const AetiologyPrior& aetiology = draw_aetiology(prior, random_share(engine));
  PopulationMember drawn;
  drawn.index = index;
  drawn.aetiology = aetiology.aetiology;
  while (drawn.draws.anatomies < kMostAnatomyDraws) {
    drawn.anatomy = draw_anatomy(prior, engine);
    if (!count_anatomy(judge(make_healthy_valve(drawn), drawn.leak_healthy_mm2), drawn.draws))
      continue;
    for (int attempt = 0; attempt < kMostLesionDraws; ++attempt) {
      drawn.lesions = draw_lesions(aetiology, engine);
      if (count_lesions(judge(make_valve(drawn), drawn.leak_mm2), drawn.draws)) return drawn;
    }
    ++drawn.draws.anatomies_resistant;
  }
  return Error{ErrorCode::OutOfRange, "",
               "no " + std::string(to_string(drawn.aetiology)) + " valve among " +
                   std::to_string(kMostAnatomyDraws) +
                   " anatomies that is competent before disease and leaks after it"};
}

Expected<Valve> make_healthy_valve(const PopulationMember& member) {
  HumanValve human = healthy_valve(member.anatomy);
  human.dimensions.name = name_of(member) + "-healthy";
  return make_human_valve(human);
}

Expected<Valve> make_valve(const PopulationMember& member) {
  HumanValve human = diseased_valve(member.aetiology, member.anatomy, member.lesions);
  human.dimensions.name = name_of(member);
  Expected<Valve> valve = make_human_valve(human);
  if (!valve) return valve;
  int left = ruptured_chordae(member.lesions);
  for (const Side side : {Side::Posteromedial, Side::Anterolateral})
    for (Chorda& chorda : valve->chordae) {
      if (chorda.kind != ChordaKind::Marginal || chorda.id.find("-P2-") == std::string::npos ||
          valve->heads[static_cast<std::size_t>(chorda.head)].side != side || left == 0)
        continue;
      chorda.ruptured = true;
      --left;
    }
  return valve;
}

}  // namespace coapt
