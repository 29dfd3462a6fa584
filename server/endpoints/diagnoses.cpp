#include "server/endpoints/diagnoses.h"

#include "core/closure/standing.h"
#include "io/json/diagnosis_json.h"
#include "server/repair_request.h"

namespace coapt {

Answer PostDiagnosis::operator()(const Request& request) const {
  return answer_repair(
      valves, compute, request, {},
      [](const RepairRequest& asked, RequestClosures& closures) {
        const ClosedValve closed = closures.close_and_measure(asked.repaired);
        const Expected<OpenedValve> opened = closures.open(asked.repaired, {});
        const auto diagnosis = diagnose(
            closed.valve, closed.closure, closed.measure,
            opened ? opened->measure.opening_area_mm2 : std::numeric_limits<double>::quiet_NaN());
        if (!diagnosis)
          return problem(422, ErrorCode::BadGeometry,
                         "the valve does not close, so that nothing can be diagnosed: " +
                             doubt_about(closed.closure));
        return json_answer(200, diagnosis_document(*diagnosis, closed.valve));
      },
      2);
}

}  // namespace coapt
