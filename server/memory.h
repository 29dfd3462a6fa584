// What the server does with little memory: an answer is lost, never the process.
#pragma once

namespace coapt {

/// Before any other thread: stacks of a size that all threads together can have, memory that goes back to the system as
/// soon as a large request is answered, and a reserve. When there is no more memory, only what stands in a MayRunOut
/// fails (std::bad_alloc); the rest, and the destructors that run then, take the reserve: json's allocate.
void set_up_memory();

/// Makes up the reserve again, if it was taken and there is memory.
void refill_memory_reserve();

/// As long as it lives this thread does without the reserve: what clients can make large is read and computed in it.
class MayRunOut {
 public:
  MayRunOut();
  ~MayRunOut();
  MayRunOut(const MayRunOut&) = delete;
};

}  // namespace coapt
