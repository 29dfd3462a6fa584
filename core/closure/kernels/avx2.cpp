#include "core/closure/kernels/lanes.h"

namespace coapt::kernels {
namespace {
#include "core/closure/kernels/kernels.inl"
}  // namespace
extern const Kernels<float> kAvx2Float;
extern const Kernels<double> kAvx2Double;
const Kernels<float> kAvx2Float = kTable<float>;
const Kernels<double> kAvx2Double = kTable<double>;
}  // namespace coapt::kernels
