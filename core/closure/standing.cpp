#include "core/closure/standing.h"

namespace coapt {

std::string doubt_about(const ClosureResult& closure) {
  if (trusted(closure)) return "";
  const char* rest = "";
  switch (closure.status) {
    case ClosureStatus::Converged:
      break;
    case ClosureStatus::StepLimit:
      rest = "not converged";
      break;
    case ClosureStatus::Diverged:
      return "UNRELIABLE: the closure diverged";
  }
  const char* crossing = closure.crossing ? "leaflets cross" : "";
  return std::string("UNRELIABLE: ") + rest + (*rest && *crossing ? ", " : "") + crossing;
}

std::string closure_name(const ClosureResult& closure) {
  return closure.crossing ? "crossing" : to_string(closure.status);
}

}  // namespace coapt
