#define COAPT_PORTABLE_LANES
#include "core/closure/kernels/lanes.h"

namespace coapt::kernels {
namespace {
#include "core/closure/kernels/kernels.inl"
}  // namespace
extern const Kernels<float> kPortableFloat;
extern const Kernels<double> kPortableDouble;
const Kernels<float> kPortableFloat = kTable<float>;
const Kernels<double> kPortableDouble = kTable<double>;
}  // namespace coapt::kernels
