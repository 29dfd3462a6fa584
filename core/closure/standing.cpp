#include "core/closure/standing.h"

namespace coapt {

std::string doubt_about(const ClosureResult& closure) {
  if (trusted(closure)) return "";
  const char* rest = "";
  switch (closure.status) {
    case ClosureStatus::Converged:
      break;
    case ClosureStatus::StepLimit:
      rest = "not at rest";
      break;
    case ClosureStatus::Diverged:
      return "NOT TO BE TRUSTED: the closure flew apart";
  }
  const char* crossing = closure.crossing ? "leaflets cross" : "";
  return std::string("NOT TO BE TRUSTED: ") + rest + (*rest && *crossing ? ", " : "") + crossing;
}

}  // namespace coapt
