#include "server/endpoints/openings.h"

#include <chrono>

#include "server/answers.h"
#include "server/repair_request.h"

namespace coapt {
namespace {

Answer opened_answer(const RepairRequest& asked, RequestClosures& closures,
                     const OpeningOptions& options, int frames) {
  const auto start = std::chrono::steady_clock::now();
  const Expected<OpenedValve> opened = closures.open(asked.repaired, options);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!opened) {
    ProblemList problems;
    add_below(problems, "/valve", opened.errors());
    return problem(422, std::move(problems).take());
  }
  return json_answer(200, opening_answer(asked, *opened, frames, seconds.count()));
}

}  // namespace

Answer PostOpenings::operator()(const Request& request) const {
  OpeningOptions options;
  int frames = 0;
  std::vector<JsonField> fields = opening_fields(options);
  fields.push_back(frames_field(frames));
  return answer_repair(valves, compute, request, std::move(fields),
                       [&](const RepairRequest& asked, RequestClosures& closures) {
                         options.motion = frames > 0;
                         return opened_answer(asked, closures, options, frames);
                       });
}

}  // namespace coapt
