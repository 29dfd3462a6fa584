// A valve that Python holds: immutable, shared by what is made of it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/closure/closure_result.h"
#include "core/metrics/measure.h"
#include "core/repair/plan.h"
#include "core/valve/valve.h"

namespace coapt {

struct LocalValve {
  std::shared_ptr<const Valve> valve;  ///< not null
};

/// Of a coapt.valve/1. Throws Problems, whose paths begin below `path`.
LocalValve local_valve(std::string_view document, const std::string& path);

/// What is given takes the place of the valve's own. Throws Problems: it is no valve any more.
struct NewArrays {
  const Points* vertices_mm = nullptr;  ///< unstressed
  const Faces* faces = nullptr;
  const Points* annulus_mm = nullptr;  ///< under pressure
};
LocalValve with_arrays(const LocalValve& valve, const NewArrays& arrays);

/// With `material` (an object of material_table()'s names) in place of its own. Throws Problems, whose paths begin with "/material".
LocalValve with_material(const LocalValve& valve, std::string_view material);

/// A closure that Python holds, with all that it was made of; not null.
struct LocalClosure {
  std::shared_ptr<const Valve> valve, repaired;  ///< the same without a plan
  RepairPlan plan{};
  ClosureResult closure{};
  ValveMeasure measure{};
  double seconds = 0.0;                 ///< of closing
  std::vector<std::string> warnings{};  ///< as in coapt.closure/2
};

/// Closes the valve, repaired if `plan` (a coapt.plan/1) is not empty and with `material` (an object of material_table()'s names) if
/// that is not, and measures it: the service's closure, to the bit. Throws Problems, whose paths begin with "/plan" or "/material".
/// From many threads at once.
LocalClosure close_locally(const LocalValve& valve, std::string_view plan,
                           std::string_view material);

/// What the service answers of it (POST /v1/closures).
std::string document_of(const LocalClosure& closed);

}  // namespace coapt
