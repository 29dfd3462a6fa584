// What a closure is of, as a name: closures under one name are interchangeable.
#pragma once

#include <string>
#include <string_view>

#include "core/closure/closure.h"

namespace coapt {

/// 32 hexadecimal digits of all that decides a closure: the valve's file without name and
/// provenance, every field of the options, version(). One bit of one coordinate changes it, and so
/// does a new version of coapt; a new build of the same version does not. @pre validate(valve) is
/// empty.
std::string subject_of(const Valve& valve, const ClosureOptions& options);

/// The same of all that, with plan and disturbance, decides the closure of a plan (PlanStore): never
/// the name that subject_of() gives. @pre validate(valve) is empty.
std::string plan_subject_of(const Valve& valve, const ClosureOptions& options);

/// Version and revisions that these names hold: builds that say the same give the same closures under a name.
std::string closures_revision();

/// FNV-1a in 128 bits (Fowler, Noll, Vo; draft-eastlake-fnv), as 32 hexadecimal digits. The same on
/// every machine. No guard against collisions made on purpose.
std::string fnv1a_128(std::string_view bytes);

}  // namespace coapt
