// Sixteen numbers at once: all SIMD of coapt. Included by the kernel sources only, each compiled
// for one instruction set; everything here is inlined into them.
//
// Only operations that IEEE 754 fixes to the bit, and no fused ones, so that all instruction sets
// agree. The portable set has no intrinsics: vectors of the compiler (GCC and clang), for any
// processor.
#pragma once

#if defined(__x86_64__) && !defined(COAPT_PORTABLE_LANES)
#include <immintrin.h>
#define COAPT_X86_LANES
#if defined(__AVX512F__)
#define COAPT_AVX512
#elif defined(__AVX2__)
#define COAPT_AVX2
#endif
#endif

#include <type_traits>

#include "core/closure/kernels/layout.h"

#define COAPT_INLINE inline __attribute__((always_inline))

namespace coapt::kernels {
namespace {

#if defined(COAPT_AVX512)
constexpr int kRegisterBytes = 64;
#elif defined(COAPT_AVX2)
constexpr int kRegisterBytes = 32;
#else
constexpr int kRegisterBytes = 16;
#endif

template <class R>
struct Registers;
template <>
struct Registers<float> {
  typedef float Real __attribute__((vector_size(kRegisterBytes)));
  using Bits = decltype(Real{} < Real{});
  typedef float Quad4 __attribute__((vector_size(16)));
};
template <>
struct Registers<double> {
  typedef double Real __attribute__((vector_size(kRegisterBytes)));
  using Bits = decltype(Real{} < Real{});
  typedef double Quad4 __attribute__((vector_size(32)));
};

template <class R>
constexpr int kWidth = kRegisterBytes / static_cast<int>(sizeof(R));
template <class R>
constexpr int kParts = kLanes / kWidth<R>;

template <class R>
struct Vec {
  typename Registers<R>::Real part[kParts<R>];
};
template <class R>
struct Mask {
  typename Registers<R>::Bits part[kParts<R>];
};

template <class R, class Operation>
COAPT_INLINE Vec<R> each(Operation operation) {
  Vec<R> result;
  for (int i = 0; i < kParts<R>; ++i) result.part[i] = operation(i);
  return result;
}
template <class R, class Operation>
COAPT_INLINE Mask<R> each_bits(Operation operation) {
  Mask<R> result;
  for (int i = 0; i < kParts<R>; ++i) result.part[i] = operation(i);
  return result;
}

template <class R>
COAPT_INLINE Vec<R> all(R value) {
  return each<R>([&](int) { return typename Registers<R>::Real{} + value; });
}
template <class R>
COAPT_INLINE Vec<R> load(const Lane<R>& lane) {
  Vec<R> result;
  __builtin_memcpy(&result, &lane.at, sizeof result);
  return result;
}
template <class R>
COAPT_INLINE void store(const Vec<R>& v, Lane<R>& lane) {
  __builtin_memcpy(&lane.at, &v, sizeof v);
}

template <class R>
COAPT_INLINE Vec<R> operator+(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) { return a.part[i] + b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator-(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) { return a.part[i] - b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator*(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) { return a.part[i] * b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator/(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) { return a.part[i] / b.part[i]; });
}
template <class R>
COAPT_INLINE Mask<R> operator<(const Vec<R>& a, const Vec<R>& b) {
  return each_bits<R>([&](int i) { return a.part[i] < b.part[i]; });
}
template <class R>
COAPT_INLINE Mask<R> operator<=(const Vec<R>& a, const Vec<R>& b) {
  return each_bits<R>([&](int i) { return a.part[i] <= b.part[i]; });
}
template <class R>
COAPT_INLINE Mask<R> operator&(const Mask<R>& a, const Mask<R>& b) {
  return each_bits<R>([&](int i) { return a.part[i] & b.part[i]; });
}
template <class R>
COAPT_INLINE Mask<R> operator|(const Mask<R>& a, const Mask<R>& b) {
  return each_bits<R>([&](int i) { return a.part[i] | b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> select(const Mask<R>& mask, const Vec<R>& yes, const Vec<R>& no) {
  return each<R>([&](int i) { return mask.part[i] ? yes.part[i] : no.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> least(const Vec<R>& a, const Vec<R>& b) {
  return select(a < b, a, b);
}
template <class R>
COAPT_INLINE Vec<R> largest(const Vec<R>& a, const Vec<R>& b) {
  return select(b < a, a, b);
}
template <class R>
COAPT_INLINE Vec<R> magnitude(const Vec<R>& a) {
  return largest(a, all(R(0)) - a);
}

/// 1 / sqrt(a) for a > 0. Doubles: correctly rounded root and quotient. Floats: first guess from
/// the bits and two Newton steps (Kadlec's constants for the first), within 7e-7 of the exact
/// value.
COAPT_INLINE Vec<float> inverse_sqrt(const Vec<float>& a) {
  using Bits = Registers<float>::Bits;
  using Real = Registers<float>::Real;
  return each<float>([&](int i) {
    const Real x = a.part[i];
    Real y = (Real)(0x5F1FFFF9 - (((Bits)x) >> 1));
    y = y * 0.703952253f * (2.38924456f - x * y * y);
    return y * (1.5f - 0.5f * x * y * y);
  });
}
COAPT_INLINE Vec<double> inverse_sqrt(const Vec<double>& a) {
  return each<double>([&](int i) {
#if defined(COAPT_AVX512)
    const auto root = (Registers<double>::Real)_mm512_sqrt_pd((__m512d)a.part[i]);
#elif defined(COAPT_AVX2)
    const auto root = (Registers<double>::Real)_mm256_sqrt_pd((__m256d)a.part[i]);
#elif defined(COAPT_X86_LANES)
    const auto root = (Registers<double>::Real)_mm_sqrt_pd((__m128d)a.part[i]);
#else
    Registers<double>::Real root = a.part[i];
    for (int k = 0; k < kWidth<double>; ++k) root[k] = __builtin_sqrt(root[k]);
#endif
    return 1.0 / root;
  });
}

/// Where the lanes have that value.
template <class R>
COAPT_INLINE Mask<R> lanes_with(const IndexLane& lanes, int value) {
  using Bits = typename Registers<R>::Bits;
  return each_bits<R>([&](int i) {
    Bits part = {};
    if constexpr (sizeof(R) == sizeof(int)) {
      __builtin_memcpy(&part, lanes.at + i * kWidth<R>, sizeof part);
    } else {
      for (int k = 0; k < kWidth<R>; ++k) part[k] = lanes.at[i * kWidth<R> + k];
    }
    return part == value;
  });
}

/// One bit per lane.
#if defined(COAPT_X86_LANES)
COAPT_INLINE unsigned bits(const Mask<float>& mask) {
#if defined(COAPT_AVX512)
  return _mm512_movepi32_mask((__m512i)mask.part[0]);
#elif defined(COAPT_AVX2)
  return static_cast<unsigned>(_mm256_movemask_ps((__m256)mask.part[0])) |
         static_cast<unsigned>(_mm256_movemask_ps((__m256)mask.part[1])) << 8;
#else
  unsigned result = 0;
  for (int i = 0; i < kParts<float>; ++i)
    result |= static_cast<unsigned>(_mm_movemask_ps((__m128)mask.part[i])) << (4 * i);
  return result;
#endif
}
COAPT_INLINE unsigned bits(const Mask<double>& mask) {
  unsigned result = 0;
  for (int i = 0; i < kParts<double>; ++i) {
#if defined(COAPT_AVX512)
    result |= static_cast<unsigned>(_mm512_movepi64_mask((__m512i)mask.part[i])) << (8 * i);
#elif defined(COAPT_AVX2)
    result |= static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask.part[i])) << (4 * i);
#else
    result |= static_cast<unsigned>(_mm_movemask_pd((__m128d)mask.part[i])) << (2 * i);
#endif
  }
  return result;
}
#else
template <class R>
COAPT_INLINE unsigned bits(const Mask<R>& mask) {
  unsigned result = 0;
  for (int i = 0; i < kLanes; ++i)
    result |= (mask.part[i / kWidth<R>][i % kWidth<R>] != 0 ? 1u : 0u) << i;
  return result;
}
#endif

/// Stores the numbers from `start` on whose lanes have a bit next to each other; may write sixteen in
/// all.
COAPT_INLINE void compress_numbers(int start, unsigned chosen, int* out) {
#if defined(COAPT_AVX512)
  const __m512i numbers =
      _mm512_add_epi32(_mm512_set1_epi32(start),
                       _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
  _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen), numbers));
#else
  for (; chosen != 0; chosen &= chosen - 1) *out++ = start + __builtin_ctz(chosen);
#endif
}
/// The same of the lanes themselves.
template <class R>
COAPT_INLINE void compress(const Vec<R>& v, unsigned chosen, R* out) {
#if defined(COAPT_AVX512)
  if constexpr (sizeof(R) == sizeof(float)) {
    _mm512_storeu_ps(out,
                     _mm512_maskz_compress_ps(static_cast<__mmask16>(chosen), (__m512)v.part[0]));
    return;
  }
#endif
  Lane<R> lanes;
  store(v, lanes);
  for (; chosen != 0; chosen &= chosen - 1) *out++ = lanes.at[__builtin_ctz(chosen)];
}

/// Four by four, in each 128-bit quarter of a float register: rows become columns and back.
using FloatRegister = Registers<float>::Real;
COAPT_INLINE void transpose(FloatRegister& a, FloatRegister& b, FloatRegister& c,
                            FloatRegister& d) {
#if defined(COAPT_X86_LANES)
#if defined(COAPT_AVX512)
#define COAPT_PS(name) _mm512_##name##_ps
#elif defined(COAPT_AVX2)
#define COAPT_PS(name) _mm256_##name##_ps
#else
#define COAPT_PS(name) _mm_##name##_ps
#endif
  const auto ab_low = COAPT_PS(unpacklo)(a, b), ab_high = COAPT_PS(unpackhi)(a, b);
  const auto cd_low = COAPT_PS(unpacklo)(c, d), cd_high = COAPT_PS(unpackhi)(c, d);
  a = COAPT_PS(shuffle)(ab_low, cd_low, 0x44);
  b = COAPT_PS(shuffle)(ab_low, cd_low, 0xEE);
  c = COAPT_PS(shuffle)(ab_high, cd_high, 0x44);
  d = COAPT_PS(shuffle)(ab_high, cd_high, 0xEE);
#undef COAPT_PS
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

template <class R>
struct Vec3x {
  Vec<R> x, y, z;
};
template <class R>
struct Vec4x {
  Vec<R> x, y, z, w;
};

/// What is at an offset.
template <class Thing>
COAPT_INLINE Thing& at_offset(Thing* things, int offset) {
  using Byte = std::conditional_t<std::is_const_v<Thing>, const char, char>;
  return *reinterpret_cast<Thing*>(reinterpret_cast<Byte*>(things) + static_cast<unsigned>(offset));
}

/// The numbers at sixteen offsets.
COAPT_INLINE Vec<float> gather(const float* numbers, const IndexLane& offset) {
#if defined(COAPT_AVX512)
  return {{(Registers<float>::Real)_mm512_i32gather_ps(_mm512_load_si512(offset.at), numbers, 1)}};
#elif defined(COAPT_AVX2)
  return each<float>([&](int i) {
    const auto at = _mm256_load_si256(reinterpret_cast<const __m256i*>(offset.at) + i);
    return (Registers<float>::Real)_mm256_i32gather_ps(numbers, at, 1);
  });
#else
  return each<float>([&](int i) {
    const int* at = offset.at + i * kWidth<float>;
    return Registers<float>::Real{at_offset(numbers, at[0]), at_offset(numbers, at[1]),
                                  at_offset(numbers, at[2]), at_offset(numbers, at[3])};
  });
#endif
}
COAPT_INLINE Vec<double> gather(const double* numbers, const IndexLane& offset) {
  return each<double>([&](int i) {
    Registers<double>::Real part;
    for (int k = 0; k < kWidth<double>; ++k)
      part[k] = at_offset(numbers, offset.at[i * kWidth<double> + k]);
    return part;
  });
}

/// The quads at sixteen offsets.
COAPT_INLINE Vec4x<float> gather(const Quad<float>* quads, const IndexLane& index) {
  Vec4x<float> v;
  for (int i = 0; i < kParts<float>; ++i) {
    const int* at = index.at + i * kWidth<float>;
    const auto row = [&](int k) {
      return every_fourth([&](int lane) { return at_offset(quads, at[k + lane]).at; });
    };
    v.x.part[i] = row(0), v.y.part[i] = row(1), v.z.part[i] = row(2), v.w.part[i] = row(3);
    transpose(v.x.part[i], v.y.part[i], v.z.part[i], v.w.part[i]);
  }
  return v;
}
COAPT_INLINE Vec4x<float> load_quads(const Quad<float>* quads) {
  Vec4x<float> v;
  for (int i = 0; i < kParts<float>; ++i) {
    const Quad<float>* first = quads + i * kWidth<float>;
    const auto row = [&](int k) {
      return every_fourth([&](int lane) { return first[k + lane].at; });
    };
    v.x.part[i] = row(0), v.y.part[i] = row(1), v.z.part[i] = row(2), v.w.part[i] = row(3);
    transpose(v.x.part[i], v.y.part[i], v.z.part[i], v.w.part[i]);
  }
  return v;
}
COAPT_INLINE void store_quads(Vec4x<float> v, Quad<float>* quads) {
  for (int i = 0; i < kParts<float>; ++i) {
    Quad<float>* first = quads + i * kWidth<float>;
    transpose(v.x.part[i], v.y.part[i], v.z.part[i], v.w.part[i]);
    const auto put = [&](FloatRegister r, int k) {
      put_every_fourth(r, [&](int lane) { return first[k + lane].at; });
    };
    put(v.x.part[i], 0), put(v.y.part[i], 1), put(v.z.part[i], 2), put(v.w.part[i], 3);
  }
}

COAPT_INLINE Vec4x<double> gather(const Quad<double>* quads, const IndexLane& index) {
  Lane<double> column[4];
  for (int lane = 0; lane < kLanes; ++lane)
    for (int k = 0; k < 4; ++k) column[k].at[lane] = at_offset(quads, index.at[lane]).at[k];
  return {load(column[0]), load(column[1]), load(column[2]), load(column[3])};
}
COAPT_INLINE Vec4x<double> load_quads(const Quad<double>* quads) {
  Lane<double> column[4];
  for (int lane = 0; lane < kLanes; ++lane)
    for (int k = 0; k < 4; ++k) column[k].at[lane] = quads[lane].at[k];
  return {load(column[0]), load(column[1]), load(column[2]), load(column[3])};
}
COAPT_INLINE void store_quads(const Vec4x<double>& v, Quad<double>* quads) {
  Lane<double> column[4];
  store(v.x, column[0]), store(v.y, column[1]), store(v.z, column[2]), store(v.w, column[3]);
  for (int lane = 0; lane < kLanes; ++lane)
    for (int k = 0; k < 4; ++k) quads[lane].at[k] = column[k].at[lane];
}

template <class R>
COAPT_INLINE Vec3x<R> xyz(const Vec4x<R>& v) {
  return {v.x, v.y, v.z};
}
template <class R>
COAPT_INLINE Vec3x<R> operator+(const Vec3x<R>& a, const Vec3x<R>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
COAPT_INLINE Vec3x<R> operator-(const Vec3x<R>& a, const Vec3x<R>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class R>
COAPT_INLINE Vec3x<R> operator*(const Vec<R>& s, const Vec3x<R>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class R>
COAPT_INLINE Vec<R> dot(const Vec3x<R>& a, const Vec3x<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
COAPT_INLINE Vec3x<R> cross(const Vec3x<R>& a, const Vec3x<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Sum and largest over the lanes, in their order.
template <class R>
COAPT_INLINE double sum(const Vec<R>& v) {
  Lane<R> lanes;
  store(v, lanes);
  double total = 0.0;
  for (int i = 0; i < kLanes; ++i) total += static_cast<double>(lanes.at[i]);
  return total;
}
template <class R>
COAPT_INLINE R largest_of(const Vec<R>& v) {
  Lane<R> lanes;
  store(v, lanes);
  R result = lanes.at[0];
  for (int i = 1; i < kLanes; ++i) result = lanes.at[i] > result ? lanes.at[i] : result;
  return result;
}
template <class R>
COAPT_INLINE R least_of(const Vec<R>& v) {
  return -largest_of(all(R(0)) - v);
}

}  // namespace
}  // namespace coapt::kernels
