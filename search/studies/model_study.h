// How much of an answer is the model's: one valve, repaired or not, closed under many draws of what
// is not known of it (valve_draw.h), and which property of its material decides.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/closed_figures.h"
#include "core/metrics/estimate.h"
#include "search/conditioning.h"
#include "search/evaluator.h"
#include "search/information.h"
#include "search/plans/valve_draw.h"
#include "search/studies/sobol_indices.h"

namespace coapt {

struct ModelStudyOptions {
  int draws = 256;  ///< at least 1; where something was observed as many as draw_blocks() says
  std::uint64_t seed = 1;
  int threads = 0;                         ///< 0: all cores; does not change the answer
  std::function<void(int, int)> progress;  ///< closures made, planned; from one thread at a time
  std::function<bool()> cancelled;         ///< from any thread; what is closed by then counts
  /// The repair whose leak is asked for; the valve itself, of which Valve::observed was seen, is closed in each draw, too. Null: none.
  const RepairPlan* plan = nullptr;
  Evaluator evaluate;  ///< closes and measures the least surface if empty
};

struct ModelStudyDraw {
  std::vector<double> shares;  ///< order of model_parameters()
  bool trusted = false;
  double leak_mm2 = 0.0;
  /// Of the valve as it was observed, where it closes; of one that is not repaired the same closure.
  std::optional<ModelFigures> figures{};
  ShapeFigures closed_shape{};  ///< of the same
  double weight = 0.0;          ///< among the draws that are trusted, sum 1
  ClosedFigures closed{};       ///< as the leak, of the valve that is asked for
};

/// The leak over the draws whose closure is trusted, as they weigh; NaN without any.
struct ModelUncertainty {
  double as_it_is_mm2 = 0.0;
  double mean_mm2 = 0.0, sd_mm2 = 0.0;
  double p5_mm2 = 0.0, p95_mm2 = 0.0;
  SobolIndices decided_by;  ///< order of model_parameters()
};

struct ModelStudy {
  Evaluation as_it_is;
  std::vector<ModelStudyDraw> draws;  ///< those closed, in order
  int untrusted = 0;                  ///< of them; refused ones, too
  /// That the draws are weighed by; empty: all alike.
  std::vector<Observation> observed;
  double effective = 0.0;    ///< Conditioning::effective, of the draws that are trusted
  bool contradicts = false;  ///< what was observed contradicts the model: the draws are not weighed
  bool draws_chordae = false;  ///< each with chordae of its own: the valve's were never seen
  bool draws_fit = false;      ///< each with other values of what a fit left uncertain
  ModelUncertainty leak;
};

/// The tissue's part of the leak's error: none without enough draws, and where what was observed contradicts the model.
std::optional<Interval> tissue_interval(const ModelStudy& study);

/// The same of one of closed_figures(), over those draws where it is known.
std::optional<Interval> tissue_interval(const ModelStudy& study, std::size_t figure);

/// Of its draws where the unrepaired valve closes.
std::vector<InformationRow> information_rows(const ModelStudy& study);

/// Each closure starts from the open state, as close_valve() alone does. @pre the valve is valid and
/// mitral, the plan can be applied to it.
ModelStudy study_model(const Valve& valve, const ModelStudyOptions& options = {});

}  // namespace coapt
