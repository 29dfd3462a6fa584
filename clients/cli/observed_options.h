// Options that say what images show of a valve's closed state (Valve::observed): --leak and --leak-sd, and so on.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/valve/effective_leak.h"
#include "core/valve/valve.h"
#include "io/command_line/command_line.h"
#include "io/json/json.h"

namespace coapt {

struct ObservedOptions {
  std::array<std::optional<double>, kObservedFigures> values,
      sds;  ///< in the order of ObservedFigure
  std::optional<double> effective_mm2, effective_sd_mm2;
  EffectiveLeak discharge;  ///< its coefficient alone
  std::string source;
};

/// With the ranges of kObservedRows. @param source_option who or what saw it: "--source"
void add_observed_options(Command command, ObservedOptions& options,
                          const std::string& source_option);

/// "--leak and --leak-sd, ... or ...".
std::string observed_option_names();

bool any_observed(const ObservedOptions& options);

/// A value without its standard deviation, or the other way round; the leak twice.
Errors check_observed(const ObservedOptions& options);

/// As of a valve's "observed"; without the effective leak.
Json observed_json(const ObservedOptions& options);
/// None was given. @pre check_observed() is empty
std::optional<EffectiveLeak> effective_leak(const ObservedOptions& options);

/// A figure that was given before is replaced.
void take_observed(const ObservedOptions& options, Valve& valve);

}  // namespace coapt
