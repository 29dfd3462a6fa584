#include "core/closure/kernels/lanes.h"

namespace coapt::kernels {
namespace {
#include "core/closure/kernels/kernels.inl"
}  // namespace
extern const Kernels<float> kBaselineFloat;
extern const Kernels<double> kBaselineDouble;
const Kernels<float> kBaselineFloat = kTable<float>;
const Kernels<double> kBaselineDouble = kTable<double>;
}  // namespace coapt::kernels
