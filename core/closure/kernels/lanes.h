// Sixteen numbers at once: all SIMD of coapt. Included by the kernel sources only, each compiled
// for one instruction set; everything here is inlined into them.
//
// Only operations that IEEE 754 fixes to the bit, and no fused ones, so that all instruction sets
// agree. The portable set has no intrinsics: vectors of the compiler (GCC and clang), for any
// processor.
//
// Registers are loaded and stored one by one: g++ 12 copies a whole Vec in pieces of 16 bytes, and a
// processor that then loads 32 of them waits until they are in the cache (1.7 times the time of a
// closure by AVX2).
#pragma once

#include <type_traits>

#include "core/closure/kernels/registers.h"

namespace coapt::kernels {
namespace {

template <class R>
constexpr int kParts = kLanes / kWidth<R>;

template <class R>
struct Vec {
  typename Registers<R>::Real part[kParts<R>];
};
template <class R>
struct Mask {
  typename Registers<R>::Chosen part[kParts<R>];
};

/// The numbers of the parts, as a list: g++ takes an array apart only if no index is a variable.
template <int... numbers>
struct Numbers {};
template <int count, int... numbers>
struct NumbersTo : NumbersTo<count - 1, count - 1, numbers...> {};
template <int... numbers>
struct NumbersTo<0, numbers...> {
  using List = Numbers<numbers...>;
};
template <class Parts, class Operation, int... i>
COAPT_INLINE Parts each_of(Operation operation, Numbers<i...>) {
  return {{operation(i)...}};
}
template <class R, class Operation>
COAPT_INLINE Vec<R> each(Operation operation) {
  return each_of<Vec<R>>(operation, typename NumbersTo<kParts<R>>::List{});
}
template <class R, class Operation>
COAPT_INLINE Mask<R> each_bits(Operation operation) {
  return each_of<Mask<R>>(operation, typename NumbersTo<kParts<R>>::List{});
}

template <class R>
COAPT_INLINE Vec<R> all(R value) {
  return each<R>([&](int) COAPT_INLINE_LAMBDA { return typename Registers<R>::Real{} + value; });
}
template <class R>
COAPT_INLINE Vec<R> load(const R* first) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA {
    typename Registers<R>::Real part;
    __builtin_memcpy(&part, first + i * kWidth<R>, sizeof part);
    return part;
  });
}
template <class R>
COAPT_INLINE Vec<R> load(const Lane<R>& lane) {
  return load(static_cast<const R*>(__builtin_assume_aligned(lane.at, alignof(Lane<R>))));
}
template <class R>
COAPT_INLINE void store(const Vec<R>& v, R* first) {
  for (int i = 0; i < kParts<R>; ++i)
    __builtin_memcpy(first + i * kWidth<R>, &v.part[i], sizeof v.part[i]);
}
template <class R>
COAPT_INLINE void store(const Vec<R>& v, Lane<R>& lane) {
  store(v, static_cast<R*>(__builtin_assume_aligned(lane.at, alignof(Lane<R>))));
}

template <class R>
COAPT_INLINE Vec<R> operator+(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return a.part[i] + b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator-(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return a.part[i] - b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator*(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return a.part[i] * b.part[i]; });
}
template <class R>
COAPT_INLINE Vec<R> operator/(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return a.part[i] / b.part[i]; });
}
template <class R>
COAPT_INLINE Mask<R> operator<(const Vec<R>& a, const Vec<R>& b) {
  return each_bits<R>([&](int i) COAPT_INLINE_LAMBDA { return less(a.part[i], b.part[i]); });
}
template <class R>
COAPT_INLINE Mask<R> operator<=(const Vec<R>& a, const Vec<R>& b) {
  return each_bits<R>([&](int i) COAPT_INLINE_LAMBDA { return at_most(a.part[i], b.part[i]); });
}
template <class R>
COAPT_INLINE Mask<R> operator&(const Mask<R>& a, const Mask<R>& b) {
  return each_bits<R>([&](int i) COAPT_INLINE_LAMBDA {
    return static_cast<typename Registers<R>::Chosen>(a.part[i] & b.part[i]);
  });
}
template <class R>
COAPT_INLINE Mask<R> operator|(const Mask<R>& a, const Mask<R>& b) {
  return each_bits<R>([&](int i) COAPT_INLINE_LAMBDA {
    return static_cast<typename Registers<R>::Chosen>(a.part[i] | b.part[i]);
  });
}
template <class R>
COAPT_INLINE Vec<R> select(const Mask<R>& mask, const Vec<R>& yes, const Vec<R>& no) {
  return each<R>([&](int i)
                     COAPT_INLINE_LAMBDA { return choose(mask.part[i], yes.part[i], no.part[i]); });
}
template <class R>
COAPT_INLINE Vec<R> least(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return lesser(a.part[i], b.part[i]); });
}
template <class R>
COAPT_INLINE Vec<R> largest(const Vec<R>& a, const Vec<R>& b) {
  return each<R>([&](int i) COAPT_INLINE_LAMBDA { return greater(a.part[i], b.part[i]); });
}
template <class R>
COAPT_INLINE Vec<R> magnitude(const Vec<R>& a) {
  using Register = Registers<R>;
  return each<R>([&](int i) COAPT_INLINE_LAMBDA {
    return (typename Register::Real)((typename Register::Bits)a.part[i] & Register::kAllButSign);
  });
}

/// 1 / sqrt(a) for a > 0. Doubles: correctly rounded root and quotient. Floats: first guess from
/// the bits and two Newton steps (Kadlec's constants for the first), within 7e-7 of the exact
/// value.
COAPT_INLINE Vec<float> inverse_sqrt(const Vec<float>& a) {
  using Bits = Registers<float>::Bits;
  using Real = Registers<float>::Real;
  return each<float>([&](int i) COAPT_INLINE_LAMBDA {
    const Real x = a.part[i];
    Real y = (Real)(0x5F1FFFF9 - (((Bits)x) >> 1));
    y = y * 0.703952253f * (2.38924456f - x * y * y);
    return y * (1.5f - 0.5f * x * y * y);
  });
}
COAPT_INLINE Vec<double> inverse_sqrt(const Vec<double>& a) {
  return each<double>([&](int i) COAPT_INLINE_LAMBDA { return 1.0 / root(a.part[i]); });
}

/// Where the lanes have that value.
template <class R>
COAPT_INLINE Mask<R> lanes_with(const IndexLane& lanes, int value) {
  using Bits = typename Registers<R>::Bits;
  typedef int Indices __attribute__((vector_size(kWidth<R> * sizeof(int))));
  return each_bits<R>([&](int i) COAPT_INLINE_LAMBDA {
    Indices part;
    __builtin_memcpy(&part, lanes.at + i * kWidth<R>, sizeof part);
    return equal(__builtin_convertvector(part, Bits), Bits{} + value);
  });
}

/// One bit per lane.
template <class R>
COAPT_INLINE unsigned bits(const Mask<R>& mask) {
  unsigned result = 0;
  for (int i = 0; i < kParts<R>; ++i) result |= lane_bits(mask.part[i]) << (kWidth<R> * i);
  return result;
}

/// Stores the lanes that have a bit next to each other; may write sixteen in all.
template <class Lanes, class Word>  // Lane<Word> or IndexLane
COAPT_INLINE void compress(const Lanes& lanes, unsigned chosen, Word* out) {
#if defined(COAPT_AVX512)
  if constexpr (sizeof(Word) == 4) {
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen),
                                                         _mm512_load_si512(lanes.at)));
    return;
  }
#elif defined(COAPT_AVX2)
  if constexpr (sizeof(Word) == 4) {
    pack_eight(lanes.at + 8, chosen >> 8, pack_eight(lanes.at, chosen & 0xFF, out));
    return;
  }
#endif
  for (; chosen != 0; chosen &= chosen - 1) *out++ = lanes.at[__builtin_ctz(chosen)];
}
template <class R>
COAPT_INLINE void compress(const Vec<R>& v, unsigned chosen, R* out) {
  Lane<R> lanes;
  store(v, lanes);
  compress(lanes, chosen, out);
}
/// Of the numbers from `start` on.
COAPT_INLINE void compress_numbers(int start, unsigned chosen, int* out) {
  IndexLane numbers;
  for (int i = 0; i < kLanes; ++i) numbers.at[i] = start + i;
  compress(numbers, chosen, out);
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
  return each<float>([&](int i) COAPT_INLINE_LAMBDA {
    const auto at = _mm256_load_si256(reinterpret_cast<const __m256i*>(offset.at) + i);
    return (Registers<float>::Real)_mm256_i32gather_ps(numbers, at, 1);
  });
#else
  return each<float>([&](int i) COAPT_INLINE_LAMBDA {
    const int* at = offset.at + i * kWidth<float>;
    return Registers<float>::Real{at_offset(numbers, at[0]), at_offset(numbers, at[1]),
                                  at_offset(numbers, at[2]), at_offset(numbers, at[3])};
  });
#endif
}
COAPT_INLINE Vec<double> gather(const double* numbers, const IndexLane& offset) {
  return each<double>([&](int i) COAPT_INLINE_LAMBDA {
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
