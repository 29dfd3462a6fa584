// Repair plans that somebody wants to find again, each with a name and its valve.
#pragma once

#include "server/json_body.h"
#include "server/page_tokens.h"
#include "server/route.h"

namespace coapt {

/// POST /v1/kept-plans {"name", "valve", "plan"}: the valve by its id or a preset's name; the plan must be possible on it.
struct PostKeptPlan {
  JobStore& store;
  ValveSource valves;
  Answer operator()(const Request& request) const;
};

/// GET /v1/kept-plans?valve=&page_size=&page_token=: newest first.
struct GetKeptPlans {
  const JobStore& store;
  const PageTokens& tokens;
  Answer operator()(const Request& request) const;
};

/// GET /v1/kept-plans/{id}
struct GetKeptPlan {
  const JobStore& store;
  Answer operator()(const Request& request) const;
};

/// PATCH /v1/kept-plans/{id} {"name"}: renames it; all else stays as it was kept.
struct RenameKeptPlan {
  JobStore& store;
  ValveSource valves;
  Answer operator()(const Request& request) const;
};

/// DELETE /v1/kept-plans/{id}
struct DeleteKeptPlan {
  JobStore& store;
  Answer operator()(const Request& request) const;
};

}  // namespace coapt
