#include "lab/closures/study_json.h"

#include <algorithm>
#include <cmath>

#include "core/metrics/quantile.h"

namespace coapt {
namespace {

Json spread(const std::vector<double>& values) {
  return {{"median", quantile(values, 0.5)},
          {"p90", quantile(values, 0.9)},
          {"max", quantile(values, 1.0)}};
}

Json errors(const std::vector<ClosureError>& all) {
  std::vector<double> rms, max, leak, height;
  for (const ClosureError& error : all) {
    rms.push_back(error.rms_mm);
    max.push_back(error.max_mm);
    leak.push_back(std::abs(error.leak_mm2));
    height.push_back(std::abs(error.coaptation_height_mm));
  }
  return {{"scenes", all.size()},
          {"rms_mm", spread(rms)},
          {"max_mm", spread(max)},
          {"leak_mm2", spread(leak)},
          {"coaptation_height_mm", spread(height)}};
}

}  // namespace

Json to_json(const ClosureStudyOptions& options, const ClosureStudy& study) {
  std::vector<ClosureError> from_end, of_other;
  for (const SceneOutcome& scene : study.scenes) {
    if (scene.compared) from_end.push_back(scene.from_end);
    if (scene.other_equilibrium) of_other.push_back(scene.from_other);
  }
  Json json = {{"method", to_string(options.closure.method)},
               {"membrane", to_string(options.closure.membrane)},
               {"count", options.count},
               {"seed", options.seed},
               {"warm", options.warm},
               {"predicted", options.predicted},
               {"library", options.library},
               {"closures_per_second_per_core", study.closures_per_second_per_core},
               {"median_ms", study.median_ms},
               {"p90_ms", study.p90_ms},
               {"median_steps", study.median_steps},
               {"second_attempts", study.retried},
               {"unconverged", study.unconverged},
               {"crossed", study.crossed}};
  if (options.predicted) {
    json["not_predicted"] = study.not_predicted;
    json["frames_per_second_per_core"] = study.frames_per_second_per_core;
  }
  if (options.library > 0) {
    json["not_predicted"] = study.not_predicted;
    json["library_seconds"] = study.library_seconds;
  }
  Json accuracy = nullptr, others = nullptr, equilibria = nullptr;
  if (options.accuracy) {
    equilibria = study.other_equilibria;
    json["elsewhere_share"] =
        static_cast<double>(study.other_equilibria) / std::max(1, study.compared);
    json["leak_difference_p90_mm2"] = study.leak_difference_p90_mm2;
    json["leak_difference_max_mm2"] = study.leak_difference_max_mm2;
    accuracy = errors(from_end);
    others = errors(of_other);
  }
  json["other_equilibria"] = equilibria;
  json["from_own_end"] = accuracy;
  json["between_equilibria"] = others;
  return json;
}

Json to_json(const AccuracyTier& tier, Membrane membrane) {
  const TierError& error = error_of(tier, membrane);
  return {{"residual_tolerance", tier.residual_tolerance},
          {"way_tolerance_mm", tier.way_tolerance_mm},
          {"leak_error_p99_mm2", error.p99_mm2},
          {"leak_error_max_mm2", error.max_mm2},
          {"scenes", kAccuracyScenes},
          {"of", "stopping early on this mesh; not of the mesh"}};
}

}  // namespace coapt
