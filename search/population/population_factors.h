// What varies between the valves of a population, by name: dimensions before disease, and what disease does.
#pragma once

#include "core/presets/human_presets.h"
#include "search/population/population.h"

namespace coapt {

struct PopulationFactor {
  const char* name;   ///< with its unit, as priors and files name it
  const char* words;  ///< for people
  double usual;       ///< anatomy: the human preset's; lesion: no lesion
  double min, max;    ///< accepted
};

const std::array<PopulationFactor, kAnatomyFactors>& anatomy_factors();
const std::array<PopulationFactor, kLesionFactors>& lesion_factors();
AnatomyValues usual_anatomy();
LesionValues no_lesions();

/// Before disease.
HumanValve healthy_valve(const AnatomyValues& anatomy);
/// As make_human_valve() takes it; ruptures are counted by ruptured_chordae().
HumanValve diseased_valve(Aetiology aetiology, const AnatomyValues& anatomy,
                          const LesionValues& lesions);
/// Of P2's marginal chordae, 0 to 2; of one, it is the posteromedial muscle's.
int ruptured_chordae(const LesionValues& lesions);

}  // namespace coapt
