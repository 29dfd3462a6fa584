// The continuum membrane in sixteen faces: core/closure/continuum.cpp, written for lanes. Included by
// kernels.inl, before faces.inl.

/// Images of the unit vectors along and across, as sums of x0, x1 and x2 times a, b and c.
template <class R>
struct Images {
  Vec3x<R> f1, f2;
  Vec<R> a1, b1, c1, a2, b2, c2;
};
/// Gradients of the energy by f1 and f2, and what bounds their stiffness.
template <class R>
struct Stretched {
  Vec3x<R> p1, p2;
  Vec<R> h1, h2;
};

/// A direction of the faces: its image, and what its stretch does in fibres along it.
template <class R>
struct Direction {
  Vec<R> length, inverse;
  Vec<R> stress, stiffness;
};
template <class R>
COAPT_INLINE Direction<R> direction(const Vec3x<R>& image, const SheetFibres<R>& fibres,
                                    const Vec<R>& lookahead) {
  const Vec<R> length2 = dot(image, image) + all(kTiny_mm2<R>);
  Direction<R> d;
  d.inverse = inverse_sqrt(length2);
  d.length = length2 * d.inverse;
  const Vec<R> straight = all(fibres.straight), zero = all(R(0));
  d.stress = all(fibres.mpa) * largest(d.length - straight, zero);
  d.stiffness = select(straight < d.length + lookahead, largest(all(fibres.mpa), zero), zero);
  return d;
}

/// Bound of the second derivative by one of f1, f2: see continuum.cpp.
template <class R>
COAPT_INLINE Vec<R> block_bound(const Vec<R>& axial, const Vec<R>& tension, const Vec<R>& shear,
                                const Vec<R>& cosine) {
  const Vec<R> zero = all(R(0)), across = largest(zero, tension),
               more = largest(zero, axial - across);
  return across + largest(more, shear) + least(more, shear) * cosine;
}

template <class R>
COAPT_INLINE Stretched<R> stretch_continuum(const FaceInput<R>& in, const FaceBlock<R>& block,
                                            const Images<R>& image) {
  const SheetModuli<R>& law = in.continuum;
  const Vec<R> one = all(R(1)), half = all(R(0.5));
  const Vec<R> coupling = all(law.coupling_mpa), shear_mpa = all(law.shear_mpa);
  const R half_root = R(0.70710678118654752);
  const Vec3x<R>&f1 = image.f1, &f2 = image.f2;
  const Vec3x<R> f_plus = all(half_root) * (f1 + f2), f_minus = all(half_root) * (f1 - f2);
  // A node's move changes a length by this much at most.
  const Vec<R> move = all(R(0.5) * in.lookahead_mm);
  const Vec<R> ahead1 = move * (magnitude(image.a1) + magnitude(image.b1) + magnitude(image.c1));
  const Vec<R> ahead2 = move * (magnitude(image.a2) + magnitude(image.b2) + magnitude(image.c2));
  const Vec<R> ahead = all(half_root) * (ahead1 + ahead2);
  const Direction<R> along = direction(f1, law.along, ahead1),
                     across = direction(f2, law.across, ahead2),
                     plus = direction(f_plus, law.diagonal, ahead),
                     minus = direction(f_minus, law.diagonal, ahead);

  // What opens squeezed faces, per area that is left.
  const Vec<R> zero = all(R(0)), barrier_mpa = all(law.squeezed_mpa);
  const Vec<R> l1_2 = along.length * along.length, l2_2 = across.length * across.length,
               l12 = along.length * across.length, shear = dot(f1, f2);
  const Vec<R> area2 = largest(l1_2 * l2_2 - shear * shear, all(law.least_area2));
  const Vec<R> per_area = inverse_sqrt(area2);
  const Vec<R> missing = all(law.squeezed_area) - area2 * per_area;
  const Vec<R> missing_ahead = missing + ahead1 * across.length + ahead2 * along.length;
  const Vec<R> opening = barrier_mpa * largest(missing, zero) * per_area;
  const Vec<R> barrier = select(zero < missing_ahead, barrier_mpa, zero);

  const Vec<R> e1 = along.length - one, e2 = across.length - one;
  const Vec<R> stiff1 = all(law.along_mpa), stiff2 = all(law.across_mpa);
  const Vec<R> tension1 = (stiff1 * e1 + coupling * e2 + along.stress) * along.inverse;
  const Vec<R> tension2 = (coupling * e1 + stiff2 * e2 + across.stress) * across.inverse;
  const Vec<R> tension12 = shear_mpa * shear, squeezed12 = tension12 + opening * shear;
  const Vec<R> tension_plus = plus.stress * plus.inverse,
               tension_minus = minus.stress * minus.inverse;
  const Vec3x<R> pull_plus = all(half_root) * (tension_plus * f_plus),
                 pull_minus = all(half_root) * (tension_minus * f_minus);
  const Vec<R> volume = load(block.volume_mm3);
  Stretched<R> now;
  now.p1 = volume * ((tension1 - opening * l2_2) * f1 + squeezed12 * f2 + pull_plus + pull_minus);
  now.p2 = volume * ((tension2 - opening * l1_2) * f2 + squeezed12 * f1 + pull_plus - pull_minus);

  const Vec<R> cosine = magnitude(shear) * along.inverse * across.inverse;
  const Vec<R> rest =
      largest(coupling, shear_mpa * l12) * (one + cosine) + magnitude(tension12) + barrier * l12 +
      barrier_mpa * largest(missing_ahead, zero) +
      largest(largest(plus.stiffness, minus.stiffness), largest(tension_plus, tension_minus));
  // Half a row sum, as for springs: theirs is twice the stiffness.
  now.h1 =
      half * volume *
      (block_bound(stiff1 + along.stiffness + barrier * l2_2, tension1, shear_mpa * l2_2, cosine) +
       rest);
  now.h2 =
      half * volume *
      (block_bound(stiff2 + across.stiffness + barrier * l1_2, tension2, shear_mpa * l1_2, cosine) +
       rest);
  return now;
}
