#include "clients/cli/design_inputs.h"

#include "clients/cli/population_directory.h"
#include "clients/cli/read_argument.h"
#include "search/population/population.h"

namespace coapt {
Expected<DesignInputs> read_population_members(const std::string& path,
                                               const std::string& aetiology) {
  const Expected<Population> population = read_population_directory(path);
  if (!population) return population.errors();
  DesignInputs inputs;
  for (const PopulationMember& member : population->members) {
    if (!aetiology.empty() && aetiology != to_string(member.aetiology)) continue;
    const Expected<Valve> valve = make_valve(member);
    if (!valve) return valve.errors();
    inputs.members.push_back({valve->name, to_string(member.aetiology), *valve});
  }
  if (inputs.members.size() < 4)
    return Error{ErrorCode::OutOfRange, "/members",
                 "has " + std::to_string(inputs.members.size()) +
                     (aetiology.empty() ? "" : " " + aetiology) +
                     " members, must have at least 4, because every second one is held out"};
  inputs.made_for = "population " + population->prior.name + ", seed " +
                    std::to_string(population->seed) +
                    (aetiology.empty() ? "" : ", " + aetiology + " members alone");
  return inputs;
}

Expected<DesignInputs> read_one_patient(const std::string& argument) {
  const Expected<Valve> valve = read_valve_argument(argument);
  if (!valve) return valve.errors();
  return DesignInputs{{{valve->name, "", *valve}}, "one patient, " + valve->name};
}

}  // namespace coapt
