// What is answered at once: an operation by HTTP.
#pragma once

#include "operations/operation.h"
#include "server/compute.h"
#include "server/jobs/import_reading.h"
#include "server/json_body.h"
#include "server/route.h"

namespace coapt {

/// POST of a request of `operation`: what it answers, with the research-only notice if it is a document.
struct PostOperation {
  Operation operation;
  ValveSource valves;
  const ImportReader& imports;  ///< of files in requests
  Compute& compute;
  Answer operator()(const Request& request) const;
};

/// A file as it is answered: under its name, if it has one, and with how its closure went.
Answer file_answer(AnswerFile file);

}  // namespace coapt
