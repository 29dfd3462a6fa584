#include "server/answers.h"

namespace coapt {

Answer store_problem(const Errors& errors) {
  switch (errors.front().code) {
    case ErrorCode::Busy:
      return problem(503, errors);
    case ErrorCode::NoSpace:
      return problem(507, errors);
    default:
      return problem(500, errors);
  }
}

Answer retry_later(int status, const std::string& why) {
  return problem(status, ErrorCode::Busy, why);
}

Answer too_busy() { return retry_later(503, "all cores are busy with other closures"); }

Answer not_found(const std::string& what) {
  return problem(404, ErrorCode::BadReference, "there is no such " + what);
}

}  // namespace coapt
