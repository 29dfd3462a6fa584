// Runs of the search and of its rivals on solved lattices, for `coapt-lab bench search`.
#pragma once

#include <string>
#include <vector>

#include "lab/lattices/lattice_benchmark.h"
#include "lab/rivals/ert.h"
#include "lab/rivals/lattice_table.h"

namespace coapt {

struct RivalTask {
  const SolvedLattice* lattice = nullptr;
  std::string method, file;  ///< file: that the lattice's table was written to
  std::uint64_t seed = 1;
};

rivals::LatticeTable table_of(const SolvedLattice& lattice);

/// The program with pagmo, dlib and COBYLA: the given one, or that beside this program; empty if there is none.
std::string outside_program(const std::string& given);

/// The search ("coapt"), the rivals of this process, those of the program outside (none if empty).
std::vector<std::string> compared_methods(const std::string& outside);

/// @param budget plans that a rival may close, 17 times each; dlib takes 500 at most. The search gets as many
/// closures.
rivals::MeasuredRun measured_run(const RivalTask& task, int budget, const std::string& outside);

}  // namespace coapt
