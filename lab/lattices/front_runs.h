// Runs of the search for the front and of its rivals on solved lattices, for `coapt-lab bench front`.
#pragma once

#include <string>
#include <vector>

#include "lab/lattices/solved_front.h"
#include "lab/rivals/lattice_table.h"

namespace coapt {

/// What the program outside reads: each objective between 0 and about 1, less being better. Plans that practice does not accept are as good as
/// kWorstAccepted in opening and durability, and leak.
std::vector<rivals::LatticeTable> objective_tables(const SolvedFront& front);

struct FrontTask {
  const SolvedFront* front = nullptr;
  std::string method;
  std::uint64_t seed = 1;
  std::vector<std::string> files;  ///< of objective_tables(), for the program outside
};

struct FrontRun {
  std::string method, lattice;
  std::uint64_t seed = 0;
  VolumeRise rise;
};

/// "coapt", "random", and those of the program outside, if there is one.
std::vector<std::string> front_methods(const std::string& outside);

/// @param budget plans that a rival may ask for; ours ends by itself.
FrontRun front_run(const FrontTask& task, int budget, const std::string& outside);

/// Closures until a run has the share; infinite if it never has.
double closures_to_share(const FrontRun& run, double share);

/// "lattice,held_out,method,plans,accepted,share,closures,reached,runs": the median over runs of closures_to_share(), for 90, 95 and 99 %;
/// an infinite one is "inf".
std::string front_csv(const std::vector<SolvedFront>& fronts, const std::vector<FrontRun>& runs);
/// "held_out,method,closures,share": the mean over runs and lattices of the share found within so many closures.
std::string front_rise_csv(const std::vector<FrontRun>& runs);

/// The lattices that the search's settings were chosen on; the others are held out.
bool is_chosen_on(const std::string& lattice);

}  // namespace coapt
