// Why a valve leaks, repaired if there is a plan: it is closed and opened. Answers coapt.diagnosis/1.
#include <limits>

#include "core/closure/standing.h"
#include "io/json/diagnosis_json.h"
#include "operations/repair_request.h"
#include "operations/table.h"

namespace coapt {
namespace {

constexpr std::ptrdiff_t kClosuresOfADiagnosis = 2;  // the opening takes as long

Expected<OperationAnswer> diagnosed(const RepairRequest& asked, Context& context) {
  const Expected<ClosedValve> closed = context.close(asked.repaired);
  if (!closed) return closed.errors();
  const Expected<OpenedValve> opened = context.open(asked.repaired);
  if (context.cancelled()) return context.refusal();
  const auto diagnosis = diagnose(
      closed->valve, closed->closure, closed->measure,
      opened ? opened->measure.opening_area_mm2 : std::numeric_limits<double>::quiet_NaN());
  if (!diagnosis)
    return Error{
        ErrorCode::BadGeometry, "",
        "the closure failed, so the valve cannot be diagnosed: " + doubt_about(closed->closure)};
  return OperationAnswer(diagnosis_document(*diagnosis, closed->valve));
}

}  // namespace

Expected<OperationTask> read_diagnose(const Json& request, const Context& context) {
  return plain_task(request, context, kClosuresOfADiagnosis, diagnosed);
}

}  // namespace coapt
