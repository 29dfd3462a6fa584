// On 64-bit ARM Eigen 3.4 asks for fused multiplication and addition by name, whatever -ffp-contract says, in
// NEON/PacketMath.h and NEON/GeneralBlockPanelKernel.h. Read before Eigen, this makes two roundings of them, as on x86-64.
#pragma once

#ifdef EIGEN_CORE_H
#error "Eigen was read before"
#endif

#include <arm_neon.h>

#undef __ARM_FEATURE_FMA
#define vfmaq_n_f32(sum, a, b) vaddq_f32(sum, vmulq_n_f32(a, b))
#define vfmaq_n_f64(sum, a, b) vaddq_f64(sum, vmulq_n_f64(a, b))
#define vfmaq_laneq_f32(sum, a, b, lane) vaddq_f32(sum, vmulq_laneq_f32(a, b, lane))
#define vfmaq_laneq_f64(sum, a, b, lane) vaddq_f64(sum, vmulq_laneq_f64(a, b, lane))
