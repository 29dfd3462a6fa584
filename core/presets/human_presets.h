// Human valves: a normal one, and one of each disease that is repaired. Geometry is a measured ratio of patients to controls
// applied to the normal valve; what no source gives is said to be assumed, here and in each valve's provenance. None is a
// patient.
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

/// Health, as ParametricValve describes it.
HumanValve human_normal();
/// Functional regurgitation: a dilated, flattened annulus of 36 x 44 mm (PMC7368231), papillary tips drawn away, leaflets a
/// little larger than in health.
HumanValve human_functional_mr();
/// P2's marginal chordae ruptured, in an annulus dilated by 12 %.
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
