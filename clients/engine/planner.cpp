// The module for browsers that searches, too.
#include "clients/engine/engine.h"

namespace coapt {
namespace {

[[maybe_unused]] const bool kSearches = (further_operations = plan_operations, true);

}  // namespace
}  // namespace coapt
