#include "io/json/build.h"

#include "core/closure/kernels/kernels.h"
#include "io/json/version.h"

namespace coapt {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "clang++ " __clang_version__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

}  // namespace

Json build_json(std::string_view program) {
  return {{"program", program},
          {"version", version()},
          {"revision", revision_json()},
          {"instruction_set", kernels::to_string(kernels::best_instruction_set())},
          {"compiler", kCompiler},
          {"notice", kResearchNotice}};
}

}  // namespace coapt
