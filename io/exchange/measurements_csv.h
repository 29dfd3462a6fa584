// What was measured, under the names of SlicerHeart's Valve Quantification, with which its users compare.
#pragma once

#include <string>

#include "io/exchange/exported_valve.h"

namespace coapt {

/// Columns Metric, Value, Unit as SlicerHeart's results table has them, then Definition: how coapt's differs,
/// where it does, then Error, where it is known: that which nine of ten keep. One decimal, as there. What coapt does not measure is left out (areas of the
/// annulus in three dimensions, tenting and billow volume, coaptation area, bending angles); so is what is not
/// finite.
std::string write_measurements_csv(const ClosedValve& exported);

}  // namespace coapt
