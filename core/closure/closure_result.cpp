#include "core/closure/closure_result.h"

namespace coapt {

const char* to_string(ClosureStatus status) {
  switch (status) {
    case ClosureStatus::Converged:
      return "converged";
    case ClosureStatus::StepLimit:
      return "step_limit";
    case ClosureStatus::Diverged:
      return "diverged";
  }
  return "";
}

}  // namespace coapt
