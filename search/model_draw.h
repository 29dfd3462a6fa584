// What the model does not know of a valve: its own material, each property within what its sources allow.
//
// A draw multiplies the valve's own values, so that imported valves move as presets do. A share of a
// half is the valve itself; 0 and 1 are the ends of the range, and the factor runs along a logarithm
// from the valve to either end. So half of all draws lie on each side of the valve, however uneven
// the range. The properties move independently of each other: no source couples them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/valve/valve.h"

namespace coapt {

/// Factors of the valve's own value; lower < 1 < upper.
struct ModelParameter {
  const char* name;
  double lower, upper;
};
inline constexpr int kModelParameters = 9;
const std::array<ModelParameter, kModelParameters>& model_parameters();

/// Of the moduli above the transition.
const ModelParameter& post_moduli();

/// Of a parameter at a share in [0, 1]; exactly 1 at a half.
double model_factor(const ModelParameter& parameter, double share);

/// The valve with its properties at these shares, but for those that a fit has found. Annulus, tips, rest shape and what a surgeon has
/// chosen (length and modulus of neochordae) stay. Errors: a value that validate() refuses, of a
/// valve near its limits. @pre the valve is valid and mitral; shares.size() == kModelParameters.
Expected<Valve> with_model(const Valve& valve, const std::vector<double>& shares);

/// The same draws for whatever is compared: a Latin hypercube of shares.
std::vector<std::vector<double>> model_draws(int count, std::uint64_t seed);

}  // namespace coapt
