#include "core/closure/kernels/kernels.h"

namespace coapt::kernels {

extern const Kernels<float> kBaselineFloat, kAvx2Float, kAvx512Float;
extern const Kernels<double> kBaselineDouble, kAvx2Double, kAvx512Double;

InstructionSet best_instruction_set() {
  static const InstructionSet best = [] {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
      return InstructionSet::Avx512;
    return __builtin_cpu_supports("avx2") ? InstructionSet::Avx2 : InstructionSet::Baseline;
  }();
  return best;
}

template <>
const Kernels<float>& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::Baseline:
      return kBaselineFloat;
    case InstructionSet::Avx2:
      return kAvx2Float;
    case InstructionSet::Avx512:
      return kAvx512Float;
  }
  return kBaselineFloat;
}

template <>
const Kernels<double>& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::Baseline:
      return kBaselineDouble;
    case InstructionSet::Avx2:
      return kAvx2Double;
    case InstructionSet::Avx512:
      return kAvx512Double;
  }
  return kBaselineDouble;
}

const char* to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::Baseline:
      return "baseline";
    case InstructionSet::Avx2:
      return "avx2";
    case InstructionSet::Avx512:
      return "avx512";
  }
  return "";
}

}  // namespace coapt::kernels
