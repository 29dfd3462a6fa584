// What a ring is designed for: the members of a population, or one valve.
#pragma once

#include <string>
#include <vector>

#include "core/valve/problem_list.h"
#include "search/rings/ring_trial.h"

namespace coapt {

struct DesignInputs {
  std::vector<RingMember> members;
  std::string made_for;  ///< in words
};

/// @param path a population's directory, or its file (coapt.population/1). @param aetiology of the members taken; empty: all
Expected<DesignInputs> read_population_members(const std::string& path,
                                               const std::string& aetiology);

/// @param argument as kValveHelp has it
Expected<DesignInputs> read_one_patient(const std::string& argument);

}  // namespace coapt
