// What a study of a population found, as JSON: coapt.population_study/1.
#pragma once

#include "io/json/json.h"
#include "search/population/population_study.h"

namespace coapt {

/// "groups" (families, candidates, anchors, undersizing, decided_by), "tree" (null without one; see below), "searched".
/// What is not known is null; intervals are [low, high], 95 %.
Json to_json(const PopulationStudy& study);

/// {"nodes", "words", "grown_on", "pruned_on", "judged_on", "single", "regret"...}: a node has a choice, and a "feature" with its
/// "threshold", "below" and "above" unless it is a leaf.
Json to_json(const PopulationTree& tree);

}  // namespace coapt
