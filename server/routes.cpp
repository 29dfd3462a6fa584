#include "server/endpoints/closures.h"
#include "server/endpoints/evaluations.h"
#include "server/endpoints/exports.h"
#include "server/endpoints/health.h"
#include "server/endpoints/job_results.h"
#include "server/endpoints/jobs.h"
#include "server/endpoints/submissions.h"
#include "server/endpoints/valves.h"
#include "server/service.h"

namespace coapt {

Routes routes_of(const Service& service) {
  const auto& [limits, rings, store, jobs, known, parsing, compute, metrics, page, load] = service;
  const ValveSource valves{store, limits, known, parsing};
  const Submitting submitting{valves, jobs};
  return {
      {"POST", "/v1/valves", PostValve{store, valves}},
      {"POST", "/v1/valves:validate", ValidateValve{valves}},
      {"GET", "/v1/valves/{id}", GetValve{valves}},
      {"DELETE", "/v1/valves/{id}", DeleteValve{store, known}},
      {"GET", "/v1/presets", GetPresets{}},
      {"GET", "/v1/presets/{name}", GetValve{valves}},
      {"GET", "/v1/rings", GetRings{rings}},

      {"POST", "/v1/closures", PostClosures{valves, compute, rings}},
      {"POST", "/v1/scenes", PostScenes{valves, compute, rings}},
      {"POST", "/v1/evaluations", PostEvaluations{valves, compute, rings}},
      {"POST", "/v1/reports", PostReports{valves, compute, rings}},
      {"POST", "/v1/exports", PostExports{valves, compute, rings}},
      {"POST", "/v1/pictures", PostPictures{valves, compute, rings}},
      {"POST", "/v1/plans", PostPlans{submitting, rings}},
      {"POST", "/v1/studies", PostStudies{submitting}},

      {"GET", "/v1/jobs", GetJobs{store, jobs}},
      {"GET", "/v1/jobs/{id}", GetJob{jobs}},
      {"DELETE", "/v1/jobs/{id}", DeleteJob{store}},
      {"POST", "/v1/jobs/{id}:cancel", CancelJob{jobs}},
      {"GET", "/v1/jobs/{id}/events", GetJobEvents{store, jobs}},
      {"GET", "/v1/jobs/{id}/result", GetResult{store}},
      {"GET", "/v1/jobs/{id}/plans", GetPlans{store}},
      {"GET", "/v1/jobs/{id}/plans/{rank}", GetPlan{store}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/mesh", GetPlanMesh{store, compute, rings}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/picture", GetPlanPicture{store, compute, rings}},
      {"GET", "/v1/jobs/{id}/plans/{rank}/report", GetPlanReport{store}},
      {"GET", "/v1/jobs/{id}/report", GetReport{store}},
      {"GET", "/v1/jobs/{id}/files", GetFiles{store}},
      {"GET", "/v1/jobs/{id}/files/{name}", GetFile{store}},

      {"GET", "/healthz/live", GetLive{}},
      {"GET", "/healthz/ready", GetReady{store, jobs}},
      {"GET", "/metrics", GetMetrics{metrics, jobs, load}},
      {"GET", "/version", GetVersion{}},
      {"GET", "/openapi.json", GetOpenApi{}},
      {"GET", "/", GetPage{page}},
      {"GET", "/favicon.svg", GetPage{page}},
      {"GET", "/assets/{name}", GetPage{page}},
  };
}

}  // namespace coapt
