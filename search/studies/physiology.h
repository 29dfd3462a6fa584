// Whether a valve bears load, closes and opens as valves do: what it does, beside what was measured in hearts (physiology_ranges.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "search/studies/physiology_ranges.h"
#include "search/studies/physiology_values.h"

namespace coapt {

struct PhysiologyQuantity {
  const char* name;  ///< of rows and files
  const char* what;
  const char* unit;
  PhysiologyTrial trial;
  double PhysiologyValues::*value;
};

/// In the order of their rows.
const std::vector<PhysiologyQuantity>& physiology_quantities();
/// Null if there is none of that name.
const PhysiologyQuantity* find_quantity(const std::string& name);

/// Leaks less than 5 mm2: healthy. Else prolapse, if a marginal chorda is ruptured or the leaflets billow above the hinge line
/// in the mid-valve section; else functional.
ValveKind kind_of(const Valve& valve, const PhysiologyValues& values);
Species species_of(const Valve& valve);

enum class PhysiologyVerdict { Met, Below, Above, Unknown, NoRange };
const char* to_string(PhysiologyVerdict verdict);

struct PhysiologyRow {
  const PhysiologyQuantity* quantity;
  double value;
  const PhysiologyRange* range;  ///< null: none is published for this kind of valve
  PhysiologyVerdict verdict;
};

PhysiologyRow physiology_row(const PhysiologyQuantity& quantity, const PhysiologyValues& values,
                             ValveKind kind, Species species);

struct Physiology {
  ValveKind kind = ValveKind::Healthy;
  Species species = Species::Human;
  bool kind_judged = false, species_judged = false;  ///< else as the options say
  std::vector<PhysiologyRow> rows;                   ///< of the trials made
  bool unfinished = false;                           ///< PhysiologyValues::unfinished
};

Physiology study_physiology(const Valve& valve, const PhysiologyOptions& options = {});

}  // namespace coapt
