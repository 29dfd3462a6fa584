// A valve as it might be as well: its material (model_draw.h), and what a fit left uncertain of it (fit/fitted_draw.h) or, without one,
// its chordae where those were never seen (core/presets/synthetic_chordae.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/closure/closure_options.h"
#include "core/repair/plan.h"
#include "core/valve/valve.h"

namespace coapt {

/// Material by shares, and the unrepaired valve with other values where a fit left them uncertain, with other chordae where its own were
/// never seen, else as it is; empty where such a valve cannot be made.
struct ModelDraw {
  std::vector<double> shares;
  std::optional<Valve> valve;
};

/// One block of a valve's draws; blocks of one seed and count are different draws.
struct ModelDrawing {
  int count = 1, block = 0;
  std::uint64_t seed = 1;
};

class ModelDraws {
 public:
  /// @pre the valve is valid and mitral, and outlives this.
  ModelDraws(const Valve& valve, const ModelDrawing& drawing);

  /// From any thread; the same for whatever else is drawn. @param i in [0, count)
  ModelDraw at(int i, const ClosureBudget& budget = {}) const;

 private:
  const Valve& valve_;
  int first_;
  std::vector<std::vector<double>> shares_, fitted_;
};

/// The draw with its material, repaired by a plan unless that is null; nothing where that cannot be done.
std::optional<Valve> drawn_valve(const ModelDraw& draw, const RepairPlan* plan);

/// Whether each draw has chordae of its own; a closure is made to find their lengths.
inline bool redraws_chordae(const Valve& valve) { return !valve.fitted && valve.drawn_chordae; }

}  // namespace coapt
