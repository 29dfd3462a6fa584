// The module for browsers that searches, too.
#include "clients/engine/engine.h"
#include "operations/plan_operations.h"

namespace coapt {
namespace {

[[maybe_unused]] const bool kSearches = (further_operations = plan_operations, true);

}  // namespace
}  // namespace coapt

// NLopt's algorithms under the LGPL, which the module leaves out (cmake/packaging/wasm_libraries.sh): they answer that their
// arguments are invalid. Addresses are numbers of 32 bits there.
extern "C" {
constexpr int kInvalidArguments = -2;  // NLOPT_INVALID_ARGS
int luksan_plis(int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
int luksan_plip(int, int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
int luksan_pnet(int, int, int, int, int, int, int, int, int, int, int) { return kInvalidArguments; }
}
