// What the commands on solved lattices share.
#pragma once

#include <string>
#include <vector>

#include "lab/lattices/lattice_benchmark.h"

namespace coapt {

/// Whether it is among those asked for; all are if none are.
bool asked_for(const std::vector<std::string>& asked, const std::string& name);

/// The lattices asked for. Errors: --lattice names one that is not there.
Expected<std::vector<LatticeCase>> chosen_cases(const std::vector<std::string>& asked,
                                                const Valve& real);

}  // namespace coapt
