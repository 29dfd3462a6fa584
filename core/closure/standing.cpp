#include "core/closure/standing.h"

namespace coapt {

std::string doubt_about(const ClosureResult& closure) {
  return doubt_about(closure.status, closure.crossing);
}

std::string doubt_about(ClosureStatus status, bool crossing) {
  if (status == ClosureStatus::Converged && !crossing) return "";
  const char* rest = "";
  switch (status) {
    case ClosureStatus::Converged:
      break;
    case ClosureStatus::StepLimit:
      rest = "not converged";
      break;
    case ClosureStatus::Diverged:
      return "UNRELIABLE: the closure diverged";
  }
  return std::string("UNRELIABLE: ") + rest + (*rest && crossing ? ", " : "") +
         (crossing ? "leaflets cross" : "");
}

std::string closure_name(const ClosureResult& closure) {
  return closure.crossing ? "crossing" : to_string(closure.status);
}

}  // namespace coapt
