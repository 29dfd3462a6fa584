#include "server/request.h"

namespace coapt {

void add_below(ProblemList& problems, const std::string& pointer, const Errors& errors) {
  for (const Error& error : errors) {
    problems.add(error.code, pointer + error.path, error.message);
  }
}

}  // namespace coapt
