#include "core/closure/kernels/lanes.h"

namespace coapt::kernels {
namespace {
#include "core/closure/kernels/kernels.inl"
}  // namespace
extern const Kernels<float> kAvx512Float;
extern const Kernels<double> kAvx512Double;
const Kernels<float> kAvx512Float = kTable<float>;
const Kernels<double> kAvx512Double = kTable<double>;
}  // namespace coapt::kernels
