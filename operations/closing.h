// How a request has valves closed: once on the mesh as given, on finer and finer ones until the leak settles, or as finely as an error needs.
#pragma once

#include <optional>
#include <vector>

#include "core/closed/mesh_convergence.h"
#include "io/json/json_reader.h"
#include "operations/certainty.h"
#include "operations/operation.h"

namespace coapt {

struct Closing {
  ClosureOptions closure{};
  std::optional<double> accuracy_mm2{};
  std::optional<MeshConvergenceOptions> converge{};
  Certainty certainty = Certainty::Quick;
};

/// "method", "membrane", "accuracy_mm2", "converge" and "certainty", each optional.
std::vector<JsonField> closing_fields(Closing& asked);

/// What of it cannot be asked for together.
void add_contradictions(const Closing& asked, ProblemList& problems);

/// As it is closed: what its certainty says of meshes, and the samples of the thesis for a mitral valve.
Closing settled(Closing asked, bool mitral);

/// Closures of the mesh as given that take as long.
std::ptrdiff_t closures_of(const Closing& asked);

/// What there is to say of how the mesh was refined goes into `more`. Errors: refusal(); an accuracy that cannot be reached.
Expected<ClosedValve> close_as(const Valve& valve, const Closing& asked, Context& context,
                               Json& more);

}  // namespace coapt
