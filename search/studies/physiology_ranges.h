// What was measured in hearts: the range of each quantity of physiology.h, with its source.
//
// A range is of one or more kinds of valve, and of human or porcine ones. Where a source gives mean ± sd, the range is two sd to
// either side unless it says otherwise; what no source gives is said to be assumed.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace coapt {

enum class ValveKind { Healthy, Functional, Prolapse };
enum class Species { Human, Porcine };
inline constexpr std::array kValveKinds = {ValveKind::Healthy, ValveKind::Functional,
                                           ValveKind::Prolapse};
inline constexpr std::array kSpecies = {Species::Human, Species::Porcine};

const char* to_string(ValveKind kind);
const char* to_string(Species species);

struct PhysiologyRange {
  const char* quantity;
  std::vector<ValveKind> kinds;
  std::vector<Species> species;
  double low, high;
  const char* source;
};

const std::vector<PhysiologyRange>& physiology_ranges();

/// Null if nothing is known of it.
const PhysiologyRange* find_range(const std::string& quantity, ValveKind kind, Species species);

}  // namespace coapt
