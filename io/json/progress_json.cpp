#include "io/json/progress_json.h"

#include "io/json/plan_json.h"

namespace coapt {

Json to_json(const SearchProgress& progress) {
  Json json = {{"stage", progress.stage},
               {"closures", progress.closures},
               {"closures_planned", progress.closures_planned},
               {"best_leak_mm2", progress.best_leak_mm2},
               {"best_cost", progress.best_cost},
               {"random_cost", progress.random_cost}};
  if (const auto& best = progress.leading)
    json["best"] = {{"cost", best->cost},
                    {"nodes", best->nodes},
                    {"leak_mm2", best->leak_mm2},
                    {"description", best->description},
                    {"plan", to_json(best->plan)}};
  return json;
}

}  // namespace coapt
