// A diagnosis in a sentence.
#pragma once

#include <string>

#include "core/closed/diagnosis.h"
#include "core/metrics/estimate.h"

namespace coapt {

/// Whether neither the diagnosis's own error nor the widest part of the leak's leaves a doubt that the valve is competent or that it is not.
bool is_competence_sure(const Diagnosis& diagnosis, const Estimate& leak);

/// Why it leaks: "The valve leaks 84 ± 7 mm² because the chordae of P2 are ruptured: its edge lies 9 mm too high above the opposite
/// leaflet over 25 mm of its length (Carpentier type II)."
/// @param leak what is known of its error, of which the widest part is told: "leaks 58 mm² (24 to 47 mm² with tissue error)"; of
/// nothing the diagnosis's own
std::string sentence_of(const Diagnosis& diagnosis, const Estimate& leak = {});

/// Without figures, below a leak that is told already: "It leaks because the chordae of P2 are ruptured (Carpentier type II)."
std::string summary_of(const Diagnosis& diagnosis);

}  // namespace coapt
