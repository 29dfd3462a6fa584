// The kernels of the instruction set that this machine has.
#pragma once

#include "core/closure/kernels/layout.h"

namespace coapt::kernels {

enum class InstructionSet { Baseline, Avx2, Avx512 };

/// The best that this processor offers; asked once.
InstructionSet best_instruction_set();

/// @pre R is float or double.
template <class R>
const Kernels<R>& kernels(InstructionSet set);

const char* to_string(InstructionSet set);

}  // namespace coapt::kernels
