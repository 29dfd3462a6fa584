#include "server/memory.h"

#include <malloc.h>
#include <pthread.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <new>

namespace coapt {
namespace {

// By itself glibc raises this threshold with each large block that is freed, up to 32 MiB, and keeps what is below: half
// a GiB after a hundred bodies of 64 MiB.
constexpr int kMapFrom_bytes = 1 << 20;
// Each arena keeps the most that a request ever had in it, and by itself glibc makes eight to a core.
constexpr int kArenas = 2;
constexpr std::size_t kStack_bytes = std::size_t{1} << 20;  // by itself 8 MiB, of 128 threads a GiB
constexpr std::size_t kReserve_bytes = std::size_t{32} << 20;

std::atomic<void*> reserve = nullptr;
thread_local int may_run_out = 0;

/// Returns once there may be memory.
void find_memory() {
  if (may_run_out == 0 || std::uncaught_exceptions() > 0) {
    if (void* const block = reserve.exchange(nullptr)) return std::free(block);
  }
  throw std::bad_alloc();
}

}  // namespace

void set_up_memory() {
  mallopt(M_MMAP_THRESHOLD, kMapFrom_bytes);
  mallopt(M_ARENA_MAX, kArenas);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack_bytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
  std::set_new_handler(find_memory);
  refill_memory_reserve();
}

void refill_memory_reserve() {
  if (reserve != nullptr) return;
  void* none = nullptr;
  void* const block = std::malloc(kReserve_bytes);
  if (!reserve.compare_exchange_strong(none, block)) std::free(block);
}

MayRunOut::MayRunOut() { ++may_run_out; }
MayRunOut::~MayRunOut() { --may_run_out; }

}  // namespace coapt
