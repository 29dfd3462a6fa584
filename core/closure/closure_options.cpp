#include "core/closure/closure_options.h"

namespace coapt {

const char* to_string(Method method) {
  switch (method) {
    case Method::Fast:
      return "fast";
    case Method::Thesis:
      return "thesis";
  }
  return "";
}

}  // namespace coapt
