// How much of an answer is the model's: one valve, repaired or not, closed under many draws of its
// material (model_draw.h), and which property decides.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "search/evaluator.h"
#include "search/studies/sobol_indices.h"

namespace coapt {

struct ModelStudyOptions {
  int draws = 256;  ///< at least 1
  std::uint64_t seed = 1;
  int threads = 0;                         ///< 0: all cores; does not change the answer
  std::function<void(int, int)> progress;  ///< closures made, planned; from one thread at a time
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null; what is closed by then counts
  Evaluator evaluate;                            ///< closes and measures the least surface if empty
};

struct ModelStudyDraw {
  std::vector<double> shares;  ///< order of model_parameters()
  bool trusted = false;
  double leak_mm2 = 0.0;
};

/// The leak over the draws whose closure is trusted; NaN without any.
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
  ModelUncertainty leak;
};

/// Each closure starts from the open state, as close_valve() alone does. @pre the valve is valid and
/// mitral.
ModelStudy study_model(const Valve& valve, const ModelStudyOptions& options = {});

}  // namespace coapt
