#include "server/routes.h"

#include "operations/operations.h"
#include "server/endpoints/health.h"
#include "server/endpoints/imports.h"
#include "server/endpoints/job_events.h"
#include "server/endpoints/job_results.h"
#include "server/endpoints/jobs.h"
#include "server/endpoints/kept_plans.h"
#include "server/endpoints/operations.h"
#include "server/endpoints/submissions.h"
#include "server/endpoints/valves.h"
#include "server/service.h"

namespace coapt {

Routes routes_of(const Service& service) {
  const auto& [limits, store, jobs, known, parsing, compute, imports, reports, farm, metrics, page,
               tokens, load] = service;
  const ValveSource valves{store, limits, known, parsing};
  const Submitting submitting{valves, jobs};
  Routes routes = {
      {"POST", "/v1/valves", PostValve{store, valves}},
      {"GET", "/v1/valves", GetValves{store, tokens}},
      {"POST", "/v1/valves:import", ImportValve{store, imports, compute}, true},
      {"GET", "/v1/valves/{id}", GetValve{valves}},
      {"DELETE", "/v1/valves/{id}", DeleteValve{store, known}},
      {"GET", "/v1/presets", GetPresets{}},
      {"GET", "/v1/presets/{name}", GetValve{valves}},
      {"GET", "/v1/rings", GetRings{}},

      {"POST", "/v1/kept-plans", PostKeptPlan{store, valves}},
      {"GET", "/v1/kept-plans", GetKeptPlans{store, tokens}},
      {"GET", "/v1/kept-plans/{id}", GetKeptPlan{store}},
      {"PATCH", "/v1/kept-plans/{id}", RenameKeptPlan{store, valves}},
      {"DELETE", "/v1/kept-plans/{id}", DeleteKeptPlan{store}},

      {"POST", "/v1/plans", PostPlans{submitting}},
      {"POST", "/v1/imports", PostImports{submitting, imports, compute}, true},
      {"POST", "/v1/imports:preview", PreviewImport{imports, compute}, true},
      {"POST", "/v1/studies", PostStudies{submitting}},

      {"GET", "/v1/jobs", GetJobs{store, jobs, tokens}},
      {"GET", "/v1/jobs/{id}", GetJob{jobs}},
      {"DELETE", "/v1/jobs/{id}", DeleteJob{store}},
      {"POST", "/v1/jobs/{id}:cancel", CancelJob{jobs}},
      {"GET", "/v1/jobs/{id}/events", GetJobEvents{store, jobs}},
      {"GET", "/v1/jobs/{id}/result", GetResult{store}},
      {"GET", "/v1/jobs/{id}/plans", GetPlans{store, tokens}},
      {"GET", "/v1/jobs/{id}/plans/{rank}", GetPlan{store}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/mesh", GetPlanMesh{store, limits, compute}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/picture", GetPlanPicture{store, limits, compute}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/report", GetPlanReport{store, reports}},
      {"GET", "/v1/jobs/{id}/evaluations.csv", GetTriedPlans{store}},
      {"GET", "/v1/jobs/{id}/report", GetReport{store, reports}},
      {"GET", "/v1/jobs/{id}/files", GetFiles{store, limits, reports}},
      {"GET", "/v1/jobs/{id}/files/{name}", GetFile{store, reports}},

      {"GET", "/v1/farm", GetFarm{farm}},

      {"GET", "/healthz/live", GetLive{}},
      {"GET", "/healthz/ready", GetReady{store, jobs}},
      {"GET", "/metrics", GetMetrics{metrics, jobs, load}},
      {"GET", "/version", GetVersion{farm}},
      {"GET", "/openapi.json", GetOpenApi{}},
      {"GET", "/", GetPage{page}},
      {"GET", "/favicon.svg", GetPage{page}},
      {"GET", "/coapt-engine.wasm", GetPage{page}},
      {"GET", "/assets/{name}", GetPage{page}},
  };
  for (const Operation& operation : operations()) {
    if (operation.read == nullptr || (operation.doors & door::kService) == 0) continue;
    if (operation.as_job)
      routes.push_back(
          {"POST", operation.path, SubmitOperation{operation, submitting, imports, compute}});
    else if (!operation.needs_store)
      routes.push_back(
          {"POST", operation.path, PostOperation{operation, valves, imports, compute}});
  }
  return routes;
}

}  // namespace coapt
