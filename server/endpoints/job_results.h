// What an ended job has come to.
#pragma once

#include "io/store/job_store.h"
#include "server/compute.h"
#include "server/jobs/search_reports.h"
#include "server/limits.h"
#include "server/page_tokens.h"
#include "server/route.h"

namespace coapt {

/// GET /v1/jobs/{id}/result: coapt.plans/2, or a study's summary with its findings.
struct GetResult {
  const JobStore& store;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/plans?page_size=&page_token=
struct GetPlans {
  const JobStore& store;
  const PageTokens& tokens;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/plans/{rank}
struct GetPlan {
  const JobStore& store;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/plans/{rank}/mesh?format=: the valve as the plan leaves it, closed, as a file (io/exchange).
struct GetPlanMesh {
  const JobStore& store;
  const ServiceLimits& limits;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/plans/{rank}/picture: PNG, before and after.
struct GetPlanPicture {
  const JobStore& store;
  const ServiceLimits& limits;
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/plans/{rank}/report
struct GetPlanReport {
  const JobStore& store;
  SearchReports& reports;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/evaluations.csv: of a search, every plan that it closed.
struct GetTriedPlans {
  const JobStore& store;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/report: of a search or a study.
struct GetReport {
  const JobStore& store;
  SearchReports& reports;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/files
struct GetFiles {
  const JobStore& store;
  const ServiceLimits& limits;
  SearchReports& reports;
  Answer operator()(const Request& request) const;
};

/// GET /v1/jobs/{id}/files/{name}
struct GetFile {
  const JobStore& store;
  SearchReports& reports;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
