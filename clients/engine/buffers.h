// What the module's exports share.
#pragma once

#include <string>

#include "clients/engine/engine.h"

namespace coapt {

struct Buffers {
  std::string path, body;
  EngineAnswer given;
};
Buffers& buffers();

}  // namespace coapt
