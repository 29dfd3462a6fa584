#include "core/closure/kernels/kernels.h"

namespace coapt::kernels {

extern const Kernels<float> kPortableFloat;
extern const Kernels<double> kPortableDouble;

#if defined(__x86_64__)
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
#else
constexpr const auto &kBaselineFloat = kPortableFloat, &kAvx2Float = kPortableFloat,
                     &kAvx512Float = kPortableFloat;
constexpr const auto &kBaselineDouble = kPortableDouble, &kAvx2Double = kPortableDouble,
                     &kAvx512Double = kPortableDouble;

InstructionSet best_instruction_set() { return InstructionSet::Portable; }
#endif

template <>
const Kernels<float>& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::Portable:
      return kPortableFloat;
    case InstructionSet::Baseline:
      return kBaselineFloat;
    case InstructionSet::Avx2:
      return kAvx2Float;
    case InstructionSet::Avx512:
      return kAvx512Float;
  }
  return kPortableFloat;
}

template <>
const Kernels<double>& kernels(InstructionSet set) {
  switch (set) {
    case InstructionSet::Portable:
      return kPortableDouble;
    case InstructionSet::Baseline:
      return kBaselineDouble;
    case InstructionSet::Avx2:
      return kAvx2Double;
    case InstructionSet::Avx512:
      return kAvx512Double;
  }
  return kPortableDouble;
}

const char* to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::Portable:
      return "portable";
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
