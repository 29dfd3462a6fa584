// A valve that Python holds: immutable, shared by what is made of it.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/closed/closed_valve.h"
#include "io/json/json.h"

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

/// A closure that Python holds.
struct LocalClosure {
  ClosedValve closed;
  Json answer;  ///< coapt.closure/2
};

/// Closes the valve and measures it as `POST /v1/closures` does, to the bit; `request` has its fields without "valve": "plan",
/// "material", "accuracy_mm2", ... Throws Problems. From many threads at once.
LocalClosure close_locally(const LocalValve& valve, std::string_view request);

/// What the service answers of it.
std::string document_of(const LocalClosure& closed);

}  // namespace coapt
