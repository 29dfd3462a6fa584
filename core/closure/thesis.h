// Method thesis: springs, pressure and contact in double precision, symplectic Euler, viscous
// damping. Plain on purpose: every faster method is compared with it.
//
// Start: the unstressed shape. Annulus and papillary tips travel to their places under pressure in
// the first 4 ms while the full pressure already acts; then they are fixed. A step that would carry
// a node further than a tenth of the contact thickness is shortened to it, so that no leaflet jumps
// over another. At rest means: rms free force / rms pressure force below the tolerance.
#pragma once

#include "core/closure/allowance.h"
#include "core/closure/contact.h"
#include "core/closure/model.h"
#include "core/closure/run.h"

namespace coapt {

struct ThesisSettings {
  double residual_tolerance = 0.005;
  int max_steps = 40000;
  double damping_per_ms = 1.0;  ///< velocities decay by exp(-damping t); 0.5 to 1 settles fastest
  double speed = 1.0;           ///< of the time step and the longest move
  double step = 1.0;            ///< of the time step alone; above 1.4 the bound is left behind
  ContactLaw contact;
  int samples = 1;  ///< end states recorded, 0.5 ms apart (thesis 4.2.1), if so many steps are left
  Allowance* allowance = nullptr;  ///< may be null; must outlive the run
};

ClosureRun run_thesis(const ClosureModel& model, const ThesisSettings& settings);

}  // namespace coapt
