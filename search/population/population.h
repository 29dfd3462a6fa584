// Populations of valves: anatomies drawn from published distributions, each competent before disease and leaking after it.
//
// A prior says how anatomical dimensions are distributed among adults and what each aetiology does to them, every number with
// its source or marked as assumed. A member is a pure function of prior, seed and index: its aetiology is drawn by share, its
// anatomy until it closes uncrossed and competent, its lesions until it leaks. So the members of a population can be made in
// any order, on any machine, and the distributions of the members are those of the prior given competence before and a leak
// after disease.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/valve/parametric.h"

namespace coapt {

enum class Aetiology {
  Ischaemic,  ///< posteromedial tip displaced, annulus dilated
  Dilated,    ///< both tips displaced, annulus dilated
  P2Flail,    ///< fibroelastic deficiency: marginal chordae of P2 ruptured
  Barlow      ///< excess of thick leaflets, long chordae, a large flat annulus
};
inline constexpr std::array kAetiologies = {Aetiology::Ischaemic, Aetiology::Dilated,
                                            Aetiology::P2Flail, Aetiology::Barlow};
const char* to_string(Aetiology aetiology);  ///< "ischaemic", "dilated", "p2_flail", "barlow"

/// Values of anatomy_factors() and lesion_factors() (population_factors.h), in their order.
inline constexpr int kAnatomyFactors = 20, kLesionFactors = 16;
using AnatomyValues = std::array<double, kAnatomyFactors>;
using LesionValues = std::array<double, kLesionFactors>;

/// Normal, cut off at `min` and `max`; an sd of 0 fixes the mean.
struct PriorDistribution {
  double mean = 0.0, sd = 0.0;  ///< before it is cut off
  double min = 0.0, max = 0.0;
};

struct PriorFactor {
  int factor = 0;  ///< index of an anatomy or lesion factor
  PriorDistribution distribution{};
  std::string source{};
  bool assumed = false;  ///< mean or sd has no source
};

/// Of the normal variables behind two anatomy factors (a Gaussian copula); pairs that are not listed are independent.
struct PriorCorrelation {
  int first = 0, second = 0;  ///< anatomy factors
  double r = 0.0;
  std::string source{};
  bool assumed = false;
};

struct AetiologyPrior {
  Aetiology aetiology = Aetiology::Ischaemic;
  double share = 0.0;  ///< of the members, over the sum of all shares
  std::string source{};
  bool assumed = false;                ///< its share
  std::vector<PriorFactor> lesions{};  ///< independent of each other; factors left out do nothing
};

struct PopulationPrior {
  std::string name;
  std::vector<PriorFactor> anatomy;  ///< factors left out are the human preset's
  std::vector<PriorCorrelation> correlations;
  std::vector<AetiologyPrior> aetiologies;
};

/// What was drawn for one member, and why draws were rejected.
struct DrawCounts {
  int anatomies = 0;            ///< drawn
  int anatomies_invalid = 0;    ///< of these: no valve can be made of the dimensions
  int anatomies_untrusted = 0;  ///< not converged, or leaflets cross
  int anatomies_leaking = 0;    ///< more than 5 mm2 before disease
  int anatomies_resistant = 0;  ///< no lesion of kMostLesionDraws made them leak
  int lesions = 0;              ///< drawn
  int lesions_invalid = 0, lesions_untrusted = 0;
  int lesions_competent = 0;  ///< 5 mm2 or less with the disease
};

struct PopulationMember {
  int index = 0;  ///< in the population
  Aetiology aetiology = Aetiology::Ischaemic;
  AnatomyValues anatomy{};  ///< before disease
  LesionValues lesions{};
  double leak_healthy_mm2 = 0.0;  ///< at most kMildLeak_mm2
  double leak_mm2 = 0.0;          ///< with the disease, more than that
  DrawCounts draws{};
};

struct Population {
  PopulationPrior prior;
  std::uint64_t seed = 1;
  std::vector<PopulationMember> members;  ///< by index
};

inline constexpr int kMostLesionDraws = 40;    ///< of one anatomy, then another one is drawn
inline constexpr int kMostAnatomyDraws = 400;  ///< of one member, then it is given up

/// Problems with pointers into a coapt.population_prior/1 ("/anatomy/ap_mm/sd", "/correlations/3/r"): ranges, shares, a correlation matrix
/// that is not positive definite.
Errors check_prior(const PopulationPrior& prior);

/// The correlations as a matrix over all anatomy factors.
Eigen::MatrixXd correlation_matrix(const PopulationPrior& prior);

/// An anatomy of the prior, competent or not.
AnatomyValues draw_anatomy(const PopulationPrior& prior, std::mt19937_64& engine);

/// One member, on the calling thread; the same for every number of threads that make others. Error: nothing leaks or nothing
/// closes after kMostAnatomyDraws. @pre check_prior() is empty.
Expected<PopulationMember> member(const PopulationPrior& prior, std::uint64_t seed, int index);

/// The diseased valve, named "NAME-INDEX"; the same bits as the one that was judged. Errors: dimensions that cannot be made, of a member that
/// member() did not make.
Expected<Valve> make_valve(const PopulationMember& member);
/// The same before disease.
Expected<Valve> make_healthy_valve(const PopulationMember& member);

}  // namespace coapt
