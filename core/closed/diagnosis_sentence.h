// A diagnosis in a sentence.
#pragma once

#include <string>

#include "core/closed/diagnosis.h"

namespace coapt {

/// Why it leaks: "The valve leaks 84 ± 7 mm² because the chordae of P2 are ruptured: its edge lies 9 mm too high above the opposite
/// leaflet over 25 mm of its length (Carpentier type II)."
std::string sentence_of(const Diagnosis& diagnosis);

}  // namespace coapt
