// Exponential tissue in sixteen faces: core/closure/exponential.cpp, written for lanes. Included by
// kernels.inl, after sheets.inl, before faces.inl.

/// 2^k for whole k from the bits of k + 1.5 x 2^(bits of the mantissa): what is left of a sum whose
/// fraction has been rounded away.
COAPT_INLINE Vec<float> power_of_two(const Vec<float>& shifted) {
  using Bits = Registers<float>::Bits;
  using Real = Registers<float>::Real;
  return each<float>([&](int i) { return (Real)((((Bits)shifted.part[i]) << 23) + 0x3F800000); });
}
COAPT_INLINE Vec<double> power_of_two(const Vec<double>& shifted) {
  using Bits = Registers<double>::Bits;
  using Real = Registers<double>::Real;
  return each<double>(
      [&](int i) { return (Real)((((Bits)shifted.part[i]) << 52) + 0x3FF0000000000000); });
}

/// exp(a) for a in [0, 40]: a = k ln 2 + r, |r| <= ln 2 / 2, and the power series of r to the 7th
/// (float) or 13th power (double). Within 5e-7 and 1e-15 of the exact value.
template <class R>
COAPT_INLINE Vec<R> exponential(const Vec<R>& a) {
  constexpr bool kFloat = sizeof(R) == sizeof(float);
  constexpr int kTerms = kFloat ? 7 : 13;
  // Adding it leaves a whole number in the last bits; ln 2 in two parts, the first short enough for
  // exact products.
  constexpr R kShift = kFloat ? R(12582912.0) : R(6755399441055744.0);
  constexpr R kLog2High = kFloat ? R(0.693359375) : R(0.693147180369123816490);
  constexpr R kLog2Low = kFloat ? R(-2.12194440e-4) : R(1.90821492927058770002e-10);
  const Vec<R> shifted = a * all(R(1.4426950408889634)) + all(kShift);
  const Vec<R> k = shifted - all(kShift);
  const Vec<R> r = (a - k * all(kLog2High)) - k * all(kLog2Low);
  Vec<R> sum = all(R(1));
  for (int term = kTerms; term > 0; --term) sum = all(R(1)) + r * sum * all(R(1) / R(term));
  return sum * power_of_two(shifted);
}

template <class R>
void exponentials(const Lane<R>& from, Lane<R>& to) {
  store(exponential(load(from)), to);
}

/// W' and W'' at I1 - 3 = over.
template <class R>
struct Slope {
  Vec<R> first, second;
};
template <class R>
COAPT_INLINE Slope<R> slope(const ExponentialLane<R>& block, const Vec<R>& over) {
  const Vec<R> at = least(over, load(block.steepest)), c2 = load(block.c2);
  // A face cannot have less than 0; rounding can.
  const Vec<R> power = largest(c2 * at * at, all(R(0)));
  const Vec<R> grown = load(block.c1_mpa) * c2 * exponential(power);
  const Vec<R> second = grown * (all(R(1)) + (power + power));
  return {all(R(0.5)) * load(block.c0_mpa) + grown * at + second * (over - at), second};
}

template <class R>
COAPT_INLINE Stretched<R> stretch_exponential(const FaceInput<R>& in, int b,
                                              const Images<R>& image) {
  const Vec<R> one = all(R(1)), half = all(R(0.5)), two = all(R(2));
  const Vec3x<R>&f1 = image.f1, &f2 = image.f2;
  const Vec<R> c11 = dot(f1, f1), c22 = dot(f2, f2), c12 = dot(f1, f2);
  const Vec<R> area2 = largest(c11 * c22 - c12 * c12, all(in.least_area_stretch2));
  const Vec<R> per_area2 = one / area2, per_area4 = per_area2 * per_area2;
  const Vec3x<R> q1 = f1 - per_area4 * (c22 * f1 - c12 * f2),
                 q2 = f2 - per_area4 * (c11 * f2 - c12 * f1);
  const Vec<R> over = c11 + c22 + per_area2 - all(R(3));
  const Slope<R> tissue = slope(in.exponential[b], over);
  const Vec<R> volume = load(in.blocks[b].volume_mm3);
  const Vec<R> pull = two * volume * tissue.first;
  Stretched<R> now;
  now.p1 = pull * q1, now.p2 = pull * q2;

  // Bound of the second derivative: see exponential.cpp.
  const auto length = [&](const Vec<R>& length2) {
    const Vec<R> more = length2 + all(kTiny_mm2<R>);
    return more * inverse_sqrt(more);
  };
  const Vec<R> q1_length = length(dot(q1, q1)), q2_length = length(dot(q2, q2));
  const Vec<R> l1 = length(c11), l2 = length(c22), lengths = l1 + l2;
  const Vec<R> per_area3 = per_area2 * inverse_sqrt(area2);
  const Vec<R> both = two * tissue.first * (one + per_area3);
  const Vec<R> steep = all(R(6)) * tissue.first * per_area4 * lengths;
  const Vec<R> gradient = all(R(4)) * tissue.second * (q1_length + q2_length);
  // Half a row sum, as for springs: theirs is twice the stiffness.
  now.h1 = half * volume * (gradient * q1_length + both + steep * l2);
  now.h2 = half * volume * (gradient * q2_length + both + steep * l1);
  return now;
}
