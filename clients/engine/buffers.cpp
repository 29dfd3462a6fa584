#include "clients/engine/buffers.h"

namespace coapt {

Buffers& buffers() {
  static Buffers all;
  return all;
}

}  // namespace coapt
