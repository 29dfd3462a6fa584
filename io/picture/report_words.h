// Plans and leaks as a surgeon would say them.
#pragma once

#include <string>
#include <vector>

#include "io/picture/report.h"

namespace coapt {

/// One thing that is done, and what it means on this valve.
struct StepWords {
  std::string step, detail;
};

/// One for each step of the plan; without steps its description, or "no repair".
std::vector<StepWords> surgical_words(const ClosedValve& before, const RankedPlan& plan);

/// "ring generic-classic 32 + PM muscle to saddle peak, 24 mm": for a row of a table.
std::string short_words(const RankedPlan& plan);

/// Of the valve before: its dimensions, its ruptured chordae, and where it leaks how much.
std::string valve_words(const ClosedValve& before);

/// The steps in words; "no repair" if there are none.
std::vector<std::string> steps_of(const RankedPlan& plan);

/// Of its leak with errors of execution from 5 to 95 %: "0.1 to 1.4", "n/a".
std::string execution_words(const RankedPlan& plan);

/// "0.75", "> 1.00" where nothing leaks as far as the region goes.
std::string suture_margin(const LeakMargin& margin);
std::string angle_margin(const LeakMargin& margin);

/// "1.5 N", "n/a": with its unit only where it is known.
std::string with_unit(double value, int decimals, const char* unit);

}  // namespace coapt
