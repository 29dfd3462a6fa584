// Human valves: a healthy one, and one of each disease that is repaired, each of them the healthy one remodelled, on its chordae. The
// healthy and the functional one are what `coapt valve calibrate` found for examples/calibration/human.json; the others are a measured
// ratio of patients to controls, and what no source gives is said to be assumed in each valve's provenance. None is a patient.
#pragma once

#include <optional>
#include <string>

#include "core/valve/parametric.h"
#include "core/valve/remodel.h"

namespace coapt {

/// A valve by its dimensions in health, and what disease changed.
struct HumanValve {
  ParametricValve dimensions;
  std::optional<Remodelling> change;  ///< what disease did to it, if any
  std::string disease;                ///< in words, with sources
};

/// The valve itself, diseased. Errors are those of dimensions and change that make none.
Expected<Valve> make_human_valve(const HumanValve& human);

/// In health. Its slacks and tissue are what other healthy valves take.
HumanValve human_normal();
/// Functional regurgitation: a dilated, flattened annulus, papillary tips drawn away.
HumanValve human_functional_mr();
/// P2's marginal chordae ruptured, in an annulus dilated by 8 %.
HumanValve human_p2_prolapse();
/// Diffuse myxomatous disease: large, thick, extensible leaflets on long chordae in a large, flat annulus.
HumanValve barlow();
/// Fibroelastic deficiency: thin leaflets without excess tissue, P2's chordae ruptured.
HumanValve fibroelastic_flail();
/// Long, thin, extensible leaflets; both prolapse.
HumanValve marfan();
/// Secondary regurgitation of a remodelled ventricle, whose leaflets have remodelled, too.
HumanValve secondary_mr();
/// Hypertrophic obstructive cardiomyopathy: long, soft leaflets, muscles close together and anterior. Its own leak is by
/// systolic anterior motion, which a static closure does not have.
HumanValve hypertrophic();

}  // namespace coapt
