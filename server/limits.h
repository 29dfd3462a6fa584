// What the service takes, each a flag of coapt-server (those of HTTP: http.h).
#pragma once

#include "io/store/job_store.h"

namespace coapt {

struct ServiceLimits {
  int vertices = 5000;            ///< of a valve: some 10,000 triangles
  int chordae = 500;              ///< of a valve
  int evaluations = 100'000;      ///< of a search
  double vertex_steps = 25e6;     ///< steps times vertices, of a closure that a client waits for
  double request_seconds = 10.0;  ///< of computing for a client that waits
  std::size_t import_bytes = std::size_t{1} << 30;  ///< of address space, to read an import's files
  double seconds = 3600.0;  ///< of a job's running; asked for more, or for no limit, it gets this
  Retention retention =
      {};  ///< enforced when a job or a valve comes; of closures, when a job has ended
  int kept_plans = 1000;  ///< in all; over it 409
  int queue = 100;        ///< jobs that wait to be run; over it 429
  int evaluation_closures =
      500;  ///< of POST /v1/evaluations: plans times region points, evidence and draws, of 650 triangles; fewer of larger valves
  int wait_seconds = 60;    ///< of Prefer: wait
  int threads = 0;          ///< of a running job; 0: all cores. Does not change any answer
  int request_threads = 1;  ///< of an evaluation that a client waits for; likewise
  int running_jobs = 2;     ///< at once
};

}  // namespace coapt
