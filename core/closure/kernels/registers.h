// One register of the instruction set, and what the compiler's own vectors do not say, or say slowly:
// masks, the lesser and the greater of two, roots, packing. Included by lanes.h only.
//
// Masks have the form that the set compares into: a bit per lane in AVX-512, else whole numbers of all
// ones. Of 0 and -0, or with a NaN, lesser and greater give the second, as x86 does.
#pragma once

#if defined(__x86_64__) && !defined(COAPT_PORTABLE_LANES)
#include <immintrin.h>
#define COAPT_X86_LANES
#if defined(__AVX512F__)
#define COAPT_AVX512
#define COAPT_PS(name) _mm512_##name##_ps
#define COAPT_PD(name) _mm512_##name##_pd
#elif defined(__AVX2__)
#define COAPT_AVX2
#define COAPT_PS(name) _mm256_##name##_ps
#define COAPT_PD(name) _mm256_##name##_pd
#else
#define COAPT_PS(name) _mm_##name##_ps
#define COAPT_PD(name) _mm_##name##_pd
#endif
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#define COAPT_WASM_LANES
#endif

#include <cstdint>

#include "core/closure/kernels/layout.h"

#define COAPT_INLINE_LAMBDA __attribute__((always_inline))
#define COAPT_INLINE inline COAPT_INLINE_LAMBDA

namespace coapt::kernels {
namespace {

#if defined(COAPT_AVX512)
constexpr int kRegisterBytes = 64;
#elif defined(COAPT_AVX2)
constexpr int kRegisterBytes = 32;
#else
constexpr int kRegisterBytes = 16;
#endif

/// Bits: whole numbers as wide as the real ones. Chosen: lanes that a comparison chose.
template <class R>
struct Registers;
template <>
struct Registers<float> {
  typedef float Real __attribute__((vector_size(kRegisterBytes)));
  typedef int Bits __attribute__((vector_size(kRegisterBytes)));
#if defined(COAPT_AVX512)
  using Chosen = __mmask16;
#else
  using Chosen = Bits;
#endif
  typedef float Quad4 __attribute__((vector_size(16)));
  static constexpr int kAllButSign = 0x7FFFFFFF;
};
template <>
struct Registers<double> {
  typedef double Real __attribute__((vector_size(kRegisterBytes)));
  typedef std::int64_t Bits __attribute__((vector_size(kRegisterBytes)));
#if defined(COAPT_AVX512)
  using Chosen = __mmask8;
#else
  using Chosen = Bits;
#endif
  typedef double Quad4 __attribute__((vector_size(32)));
  static constexpr std::int64_t kAllButSign = 0x7FFFFFFFFFFFFFFF;
};
using FloatRegister = Registers<float>::Real;
using DoubleRegister = Registers<double>::Real;

template <class R>
constexpr int kWidth = kRegisterBytes / static_cast<int>(sizeof(R));

#if defined(COAPT_AVX512)
COAPT_INLINE __mmask16 less(FloatRegister a, FloatRegister b) {
  return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
}
COAPT_INLINE __mmask8 less(DoubleRegister a, DoubleRegister b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
COAPT_INLINE __mmask16 at_most(FloatRegister a, FloatRegister b) {
  return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ);
}
COAPT_INLINE __mmask8 at_most(DoubleRegister a, DoubleRegister b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
COAPT_INLINE __mmask16 equal(Registers<float>::Bits a, Registers<float>::Bits b) {
  return _mm512_cmpeq_epi32_mask((__m512i)a, (__m512i)b);
}
COAPT_INLINE __mmask8 equal(Registers<double>::Bits a, Registers<double>::Bits b) {
  return _mm512_cmpeq_epi64_mask((__m512i)a, (__m512i)b);
}
COAPT_INLINE FloatRegister choose(__mmask16 chosen, FloatRegister yes, FloatRegister no) {
  return _mm512_mask_blend_ps(chosen, no, yes);
}
COAPT_INLINE DoubleRegister choose(__mmask8 chosen, DoubleRegister yes, DoubleRegister no) {
  return _mm512_mask_blend_pd(chosen, no, yes);
}
COAPT_INLINE unsigned lane_bits(__mmask16 chosen) { return chosen; }
COAPT_INLINE unsigned lane_bits(__mmask8 chosen) { return chosen; }
#else
template <class Real>
COAPT_INLINE auto less(Real a, Real b) {
  return a < b;
}
template <class Real>
COAPT_INLINE auto at_most(Real a, Real b) {
  return a <= b;
}
template <class Bits>
COAPT_INLINE auto equal(Bits a, Bits b) {
  return a == b;
}
#if defined(COAPT_AVX2)
COAPT_INLINE FloatRegister choose(Registers<float>::Bits chosen, FloatRegister yes,
                                  FloatRegister no) {
  return _mm256_blendv_ps(no, yes, (__m256)chosen);
}
COAPT_INLINE DoubleRegister choose(Registers<double>::Bits chosen, DoubleRegister yes,
                                   DoubleRegister no) {
  return _mm256_blendv_pd(no, yes, (__m256d)chosen);
}
#elif defined(COAPT_WASM_LANES)
template <class Bits, class Real>
COAPT_INLINE Real choose(Bits chosen, Real yes, Real no) {
  return (Real)wasm_v128_bitselect((v128_t)yes, (v128_t)no, (v128_t)chosen);
}
#else
template <class Bits, class Real>
COAPT_INLINE Real choose(Bits chosen, Real yes, Real no) {
  return (Real)((chosen & (Bits)yes) | (~chosen & (Bits)no));
}
#endif
#if defined(COAPT_X86_LANES)
COAPT_INLINE unsigned lane_bits(Registers<float>::Bits chosen) {
  return static_cast<unsigned>(COAPT_PS(movemask)((FloatRegister)chosen));
}
COAPT_INLINE unsigned lane_bits(Registers<double>::Bits chosen) {
  return static_cast<unsigned>(COAPT_PD(movemask)((DoubleRegister)chosen));
}
#elif defined(COAPT_WASM_LANES)
COAPT_INLINE unsigned lane_bits(Registers<float>::Bits chosen) {
  return wasm_i32x4_bitmask((v128_t)chosen);
}
COAPT_INLINE unsigned lane_bits(Registers<double>::Bits chosen) {
  return wasm_i64x2_bitmask((v128_t)chosen);
}
#else
template <class Bits>
COAPT_INLINE unsigned lane_bits(Bits chosen) {
  unsigned result = 0;
  for (unsigned i = 0; i < sizeof chosen / sizeof chosen[0]; ++i)
    result |= (chosen[i] != 0 ? 1u : 0u) << i;
  return result;
}
#endif
#endif

#if defined(COAPT_X86_LANES)
COAPT_INLINE FloatRegister lesser(FloatRegister a, FloatRegister b) { return COAPT_PS(min)(a, b); }
COAPT_INLINE DoubleRegister lesser(DoubleRegister a, DoubleRegister b) {
  return COAPT_PD(min)(a, b);
}
COAPT_INLINE FloatRegister greater(FloatRegister a, FloatRegister b) { return COAPT_PS(max)(a, b); }
COAPT_INLINE DoubleRegister greater(DoubleRegister a, DoubleRegister b) {
  return COAPT_PD(max)(a, b);
}
COAPT_INLINE DoubleRegister root(DoubleRegister a) { return COAPT_PD(sqrt)(a); }
#elif defined(COAPT_WASM_LANES)
// pmin(a, b) is b < a ? b : a.
COAPT_INLINE FloatRegister lesser(FloatRegister a, FloatRegister b) {
  return (FloatRegister)wasm_f32x4_pmin((v128_t)b, (v128_t)a);
}
COAPT_INLINE DoubleRegister lesser(DoubleRegister a, DoubleRegister b) {
  return (DoubleRegister)wasm_f64x2_pmin((v128_t)b, (v128_t)a);
}
COAPT_INLINE FloatRegister greater(FloatRegister a, FloatRegister b) {
  return (FloatRegister)wasm_f32x4_pmax((v128_t)b, (v128_t)a);
}
COAPT_INLINE DoubleRegister greater(DoubleRegister a, DoubleRegister b) {
  return (DoubleRegister)wasm_f64x2_pmax((v128_t)b, (v128_t)a);
}
COAPT_INLINE DoubleRegister root(DoubleRegister a) {
  return (DoubleRegister)wasm_f64x2_sqrt((v128_t)a);
}
#else
template <class Real>
COAPT_INLINE Real lesser(Real a, Real b) {
  return choose(a < b, a, b);
}
template <class Real>
COAPT_INLINE Real greater(Real a, Real b) {
  return choose(b < a, a, b);
}
COAPT_INLINE DoubleRegister root(DoubleRegister a) {
  for (int k = 0; k < kWidth<double>; ++k) a[k] = __builtin_sqrt(a[k]);
  return a;
}
#endif

/// Four by four, in each 128-bit quarter: rows become columns and back.
COAPT_INLINE void transpose(FloatRegister& a, FloatRegister& b, FloatRegister& c,
                            FloatRegister& d) {
#if defined(COAPT_X86_LANES)
  const auto ab_low = COAPT_PS(unpacklo)(a, b), ab_high = COAPT_PS(unpackhi)(a, b);
  const auto cd_low = COAPT_PS(unpacklo)(c, d), cd_high = COAPT_PS(unpackhi)(c, d);
  a = COAPT_PS(shuffle)(ab_low, cd_low, 0x44);
  b = COAPT_PS(shuffle)(ab_low, cd_low, 0xEE);
  c = COAPT_PS(shuffle)(ab_high, cd_high, 0x44);
  d = COAPT_PS(shuffle)(ab_high, cd_high, 0xEE);
#else
  const FloatRegister rows[4] = {a, b, c, d};
  for (int k = 0; k < 4; ++k)
    a[k] = rows[k][0], b[k] = rows[k][1], c[k] = rows[k][2], d[k] = rows[k][3];
#endif
}

/// Quads next to each other in a register: quad(0), quad(4), quad(8), quad(12) of its part.
template <class QuadAt>
COAPT_INLINE FloatRegister every_fourth(QuadAt quad) {
#if defined(COAPT_AVX512)
  __m512 r = _mm512_castps128_ps512(_mm_load_ps(quad(0)));
  r = _mm512_insertf32x4(r, _mm_load_ps(quad(4)), 1);
  r = _mm512_insertf32x4(r, _mm_load_ps(quad(8)), 2);
  return _mm512_insertf32x4(r, _mm_load_ps(quad(12)), 3);
#elif defined(COAPT_AVX2)
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(quad(0))), _mm_load_ps(quad(4)),
                              1);
#else
  FloatRegister r;
  __builtin_memcpy(&r, quad(0), sizeof r);
  return r;
#endif
}
template <class QuadAt>
COAPT_INLINE void put_every_fourth(FloatRegister r, QuadAt quad) {
#if defined(COAPT_AVX512)
  _mm_store_ps(quad(0), _mm512_castps512_ps128(r));
  _mm_store_ps(quad(4), _mm512_extractf32x4_ps(r, 1));
  _mm_store_ps(quad(8), _mm512_extractf32x4_ps(r, 2));
  _mm_store_ps(quad(12), _mm512_extractf32x4_ps(r, 3));
#elif defined(COAPT_AVX2)
  _mm_store_ps(quad(0), _mm256_castps256_ps128(r));
  _mm_store_ps(quad(4), _mm256_extractf128_ps(r, 1));
#else
  __builtin_memcpy(quad(0), &r, sizeof r);
#endif
}

#if defined(COAPT_AVX2)
/// [bits of eight lanes]: those that have a bit, in order, a byte each.
struct PackingOrders {
  unsigned long at[256] = {};
  constexpr PackingOrders() {
    for (unsigned chosen = 0; chosen < 256; ++chosen)
      for (unsigned long lane = 0, shift = 0; lane < 8; ++lane)
        if (chosen >> lane & 1) at[chosen] |= lane << shift, shift += 8;
  }
};
constexpr PackingOrders kPackingOrders;

/// Stores the lanes that have a bit next to each other, and eight in all; where the next goes.
template <class Word>  // of 32 bits
COAPT_INLINE Word* pack_eight(const void* lanes, unsigned chosen, Word* out) {
  const __m256i order =
      _mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i*)&kPackingOrders.at[chosen]));
  _mm256_storeu_si256((__m256i*)out,
                      _mm256_permutevar8x32_epi32(_mm256_load_si256((const __m256i*)lanes), order));
  return out + __builtin_popcount(chosen);
}
#endif

}  // namespace
}  // namespace coapt::kernels
