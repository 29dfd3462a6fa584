// --converge and what belongs to it: closing on finer and finer meshes.
#pragma once

#include <optional>

#include "core/closed/mesh_convergence.h"
#include "io/command_line/command_line.h"
#include "io/json/json.h"

namespace coapt {

struct ConvergeOption {
  bool wanted = false;               ///< else the others are not given
  std::optional<double> within_mm2;  ///< empty: the default of MeshConvergenceOptions
  int most_vertices = MeshConvergenceOptions{}.most_vertices;
};

/// --converge, --within, --most-vertices.
void add_converge_option(Command command, ConvergeOption& option);

/// For a request's "converge".
Json converge_json(const ConvergeOption& option);

}  // namespace coapt
