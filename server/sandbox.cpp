// The filter is a list of the system calls that computing takes (seccomp(2), in every Linux since 3.5); all others fail with EPERM.
// Limits (setrlimit(2)) hold without it, too: with no descriptor to be had nothing can be opened.
#include "server/sandbox.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#define COAPT_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define COAPT_ADDRESS_SANITIZER 1
#endif
#endif

namespace coapt {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;  // no filter
#endif

constexpr int kAllowed[] = {SYS_read,          SYS_write,          SYS_close,
                            SYS_lseek,         SYS_pread64,        SYS_brk,
                            SYS_munmap,        SYS_mremap,         SYS_madvise,
                            SYS_futex,         SYS_sched_yield,    SYS_sched_getaffinity,
                            SYS_clock_gettime, SYS_gettimeofday,   SYS_getrandom,
                            SYS_getpid,        SYS_gettid,         SYS_rt_sigprocmask,
                            SYS_rt_sigreturn,  SYS_sysinfo,        SYS_exit,
                            SYS_exit_group,    SYS_restart_syscall};
constexpr int kAllowedWithoutCode[] = {SYS_mmap, SYS_mprotect};  // memory that cannot be executed
constexpr std::uint32_t kProtection = 2;  // the argument that says so, of both

// Little-endian: the lower half of an argument comes first.
constexpr std::uint32_t offset_of_argument(std::uint32_t i) {
  return static_cast<std::uint32_t>(offsetof(seccomp_data, args) + i * sizeof(std::uint64_t));
}

sock_filter load(std::size_t offset) {
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}
sock_filter end_with(std::uint32_t action) { return BPF_STMT(BPF_RET | BPF_K, action); }
sock_filter skip_unless(std::uint32_t value, std::uint8_t skipped) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skipped);
}

void filter_system_calls() {
  if (kMachine == 0) return;
  constexpr std::uint32_t kRefused = SECCOMP_RET_ERRNO | EPERM;
  std::vector<sock_filter> program = {load(offsetof(seccomp_data, arch)),
                                      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0),
                                      end_with(kRefused), load(offsetof(seccomp_data, nr))};
  for (const int call : kAllowed) {
    program.push_back(skip_unless(static_cast<std::uint32_t>(call), 1));
    program.push_back(end_with(SECCOMP_RET_ALLOW));
  }
  for (const int call : kAllowedWithoutCode) {
    program.push_back(skip_unless(static_cast<std::uint32_t>(call), 4));
    program.push_back(load(offset_of_argument(kProtection)));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, PROT_EXEC, 0, 1));
    program.push_back(end_with(kRefused));
    program.push_back(end_with(SECCOMP_RET_ALLOW));
  }
  program.push_back(end_with(kRefused));
  sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  // A kernel without filters says no: the limits stay.
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

void limit(__rlimit_resource resource, rlim_t most, rlim_t hard) {
  rlimit now{};
  getrlimit(resource, &now);
  const rlimit next{std::min(most, now.rlim_max), std::min(hard, now.rlim_max)};
  setrlimit(resource, &next);
}

}  // namespace

void enter_sandbox(const SandboxLimits& limits) {
  prctl(PR_SET_DUMPABLE, 0);
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#ifndef COAPT_ADDRESS_SANITIZER
  limit(RLIMIT_AS, limits.bytes, limits.bytes);
#endif
  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  limit(RLIMIT_CPU, seconds, seconds + 1);
  for (const __rlimit_resource none : {RLIMIT_NOFILE, RLIMIT_FSIZE, RLIMIT_NPROC, RLIMIT_CORE})
    limit(none, 0, 0);
  filter_system_calls();
}

}  // namespace coapt
