// Results in words, for people; scripts ask for --json. What is printed comes from the JSON, so that it is the
// same whether the work was done here or by a service.
#pragma once

#include <iosfwd>
#include <string>

#include "core/metrics/estimate.h"
#include "io/json/json_fwd.h"

namespace coapt {

/// Of coapt.closure/2.
void print_closure(std::ostream& out, const Json& closure);

/// "45.7 ± 2.1 mm2", or the widest known part of its error: "46 mm2; 16 to 78 mm2 with tissue error (5 to 95 %)".
std::string leak_and_error(const Json& leak);

/// Of "numerical", "tissue" and "execution", of which results of earlier releases have none.
Estimate estimate_of(const Json& json, double value);

/// A member of "estimates", so many of its units to one of what it is printed in, as leak_and_error(): "3.32 ± 0.23 N"; empty: not
/// known, as in results of earlier releases.
std::string figure_and_error(const Json& measured, const char* name, const std::string& unit,
                             double units = 1.0);

/// Of "draws", "chordae_drawn" and "fit_drawn": "64 variants of tissue and chordae".
std::string variants_words(const Json& draws);

/// Of "draws", "untrusted", "observed", "effective" and "contradicts_model": "64 draws of tissue and chordae, weighed by what was observed:
/// as many as 23 that weigh alike".
std::string draws_words(const Json& draws);

/// NaN if it is null.
double number_of(const Json& value);

/// Of what has a member "crossing".
const char* crossing_words(const Json& closure);

}  // namespace coapt
