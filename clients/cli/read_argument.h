// Valves and plans that the arguments of a command name.
#pragma once

#include <string>
#include <vector>

#include "core/valve/valve.h"
#include "io/json/plan_document.h"

namespace coapt {

/// Help text of an argument read by read_valve_argument.
inline constexpr const char* kValveHelp =
    "Valve file (coapt.valve/1), - for standard input, or the name of a preset if no such file "
    "exists";

/// A valve file, standard input ("-"), or a preset if no file has that name.
Expected<Valve> read_valve_argument(const std::string& argument);

/// The same; the file may also hold a valve that is not mitral (coapt.valve/2).
Expected<Valve> read_any_valve_argument(const std::string& argument);

/// The plans of a file or of standard input ("-"): see io/json/plan_document.h.
Expected<std::vector<NamedPlan>> read_plans_argument(const std::string& path);

/// The one of them at `rank`, from 1.
Expected<RepairPlan> read_plan_argument(const std::string& path, int rank = 1);

}  // namespace coapt
