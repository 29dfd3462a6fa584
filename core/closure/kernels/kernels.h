// The kernels of the instruction set that this machine has.
#pragma once

#include "core/closure/kernels/layout.h"

namespace coapt::kernels {

/// Portable: of any processor, without intrinsics; the others are those of x86-64.
enum class InstructionSet { Portable, Baseline, Avx2, Avx512 };

/// The best that this processor offers; asked once.
InstructionSet best_instruction_set();

/// @pre R is float or double, and the processor has the set.
template <class R>
const Kernels<R>& kernels(InstructionSet set);
template <>
const Kernels<float>& kernels(InstructionSet set);
template <>
const Kernels<double>& kernels(InstructionSet set);

const char* to_string(InstructionSet set);

}  // namespace coapt::kernels
