// Which closures a configuration's closure is predicted from (core/closure/predicted_start.h).
//
// Configurations whose tips lie on a lattice of 3 mm are closed from the open state; every other one
// starts from the mean of lattice points around it, linear within each simplex of Kuhn's division of
// the lattice's cells. Tips that are displaced alike move along the lattice alike, so that no closure of
// muscles displaced apart is needed. A function of the configuration alone, not of what else is asked.
#pragma once

#include <vector>

#include "search/studies/configuration.h"

namespace coapt {

inline constexpr double kFrameStep_mm = 3.0;  ///< divides the thesis's displacements

struct ConfigurationShare {
  Configuration configuration;
  double share = 0.0;  ///< positive; their sum is 1
};

/// At most seven, with the configuration's annulus and ring. None: it is closed from the open state.
std::vector<ConfigurationShare> predicted_from(const Configuration& configuration);

}  // namespace coapt
