// Comparator `newton`: linearly implicit pseudo-time steps with a sparse Cholesky factorisation, for the
// map of stability alone. What it can do says how much an explicit method gives away.
#pragma once

#include "core/closure/contact.h"
#include "core/closure/model.h"
#include "core/closure/run.h"

namespace coapt::comparators {

struct NewtonSettings {
  double residual_tolerance = 0.01;
  int max_steps = 400;           ///< each factorises once
  double pseudo_time = 1.0;      ///< factor on every pseudo-time step
  double longest_move_mm = 0.3;  ///< of a node in a step
  ContactLaw contact;
};

/// @pre the model's membrane is springs.
ClosureRun run_newton(const ClosureModel& model, const NewtonSettings& settings);

}  // namespace coapt::comparators
