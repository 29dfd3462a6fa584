#include "core/closure/membrane.h"

namespace coapt {

const char* to_string(Membrane membrane) {
  switch (membrane) {
    case Membrane::Springs:
      return "springs";
    case Membrane::Continuum:
      return "continuum";
  }
  return "";
}

}  // namespace coapt
