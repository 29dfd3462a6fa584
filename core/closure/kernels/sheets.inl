// Faces of the continuum membrane, sixteen at a time: core/closure/continuum.cpp, written for
// lanes. Included by kernels.inl, after motion.inl.

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
COAPT_INLINE void add_to_nodes(const IndexLane& node, unsigned active, const Vec4x<R>& forces,
                               Quad<R>* force) {
  Quad<R> quads[kLanes];
  store_quads(forces, quads);
  for (; active != 0; active &= active - 1) {
    const int lane = __builtin_ctz(active);
    add_quad(load_quad(quads[lane]), force[node.at[lane]]);
  }
}

template <class R>
void pull_sheets(const SheetInput<R>& in) {
  const Vec<R> one = all(R(1)), zero = all(R(0)), half = all(R(0.5));
  const Vec<R> coupling = all(in.law.coupling_mpa), shear_mpa = all(in.law.shear_mpa);
  const R half_root = R(0.70710678118654752);
  for (int i = 0; i < in.block_count; ++i) {
    const SheetBlock<R>& block = in.blocks[i];
    const Vec3x<R> a = xyz(gather(in.x, block.node[0]));
    const Vec3x<R> ab = xyz(gather(in.x, block.node[1])) - a,
                   ac = xyz(gather(in.x, block.node[2])) - a;
    const Vec<R> b1 = load(block.along[0]), c1 = load(block.along[1]), a1 = zero - b1 - c1;
    const Vec<R> b2 = load(block.across[0]), c2 = load(block.across[1]), a2 = zero - b2 - c2;
    const Vec3x<R> f1 = b1 * ab + c1 * ac, f2 = b2 * ab + c2 * ac;
    const Vec3x<R> f_plus = all(half_root) * (f1 + f2), f_minus = all(half_root) * (f1 - f2);
    // A node's move changes a length by this much at most.
    const Vec<R> move = all(R(0.5) * in.lookahead_mm);
    const Vec<R> ahead1 = move * (magnitude(a1) + magnitude(b1) + magnitude(c1));
    const Vec<R> ahead2 = move * (magnitude(a2) + magnitude(b2) + magnitude(c2));
    const Vec<R> ahead = all(half_root) * (ahead1 + ahead2);
    const Direction<R> along = direction(f1, in.law.along, ahead1),
                       across = direction(f2, in.law.across, ahead2),
                       plus = direction(f_plus, in.law.diagonal, ahead),
                       minus = direction(f_minus, in.law.diagonal, ahead);

    const Vec<R> e1 = along.length - one, e2 = across.length - one;
    const Vec<R> stiff1 = all(in.law.along_mpa), stiff2 = all(in.law.across_mpa);
    const Vec<R> tension1 = (stiff1 * e1 + coupling * e2 + along.stress) * along.inverse;
    const Vec<R> tension2 = (coupling * e1 + stiff2 * e2 + across.stress) * across.inverse;
    const Vec<R> shear = dot(f1, f2), tension12 = shear_mpa * shear;
    const Vec<R> tension_plus = plus.stress * plus.inverse,
                 tension_minus = minus.stress * minus.inverse;
    const Vec3x<R> pull_plus = all(half_root) * (tension_plus * f_plus),
                   pull_minus = all(half_root) * (tension_minus * f_minus);
    const Vec<R> volume = load(block.volume_mm3);
    const Vec3x<R> p1 = volume * (tension1 * f1 + tension12 * f2 + pull_plus + pull_minus);
    const Vec3x<R> p2 = volume * (tension2 * f2 + tension12 * f1 + pull_plus - pull_minus);

    const Vec<R> cosine = magnitude(shear) * along.inverse * across.inverse;
    const Vec<R> crossed = shear_mpa * along.length * across.length;
    const Vec<R> rest =
        largest(coupling, crossed) * (one + cosine) + magnitude(tension12) +
        largest(largest(plus.stiffness, minus.stiffness), largest(tension_plus, tension_minus));
    // Half a row sum, as for springs: theirs is twice the stiffness.
    const Vec<R> h1 = half * volume *
                      (block_bound(stiff1 + along.stiffness, tension1,
                                   shear_mpa * across.length * across.length, cosine) +
                       rest);
    const Vec<R> h2 = half * volume *
                      (block_bound(stiff2 + across.stiffness, tension2,
                                   shear_mpa * along.length * along.length, cosine) +
                       rest);
    const Vec<R> with_ab = magnitude(h1 * a1 * b1 + h2 * a2 * b2),
                 with_bc = magnitude(h1 * b1 * c1 + h2 * b2 * c2),
                 with_ca = magnitude(h1 * c1 * a1 + h2 * c2 * a2);
    const unsigned active = bits(zero < volume);
    const auto pull = [&](int corner, const Vec<R>& g1, const Vec<R>& g2, const Vec<R>& others) {
      const Vec3x<R> f = g1 * p1 + g2 * p2;
      const Vec<R> stiffness = h1 * g1 * g1 + h2 * g2 * g2 + others;
      add_to_nodes(block.node[corner], active,
                   Vec4x<R>{zero - f.x, zero - f.y, zero - f.z, stiffness}, in.force);
    };
    pull(0, a1, a2, with_ab + with_ca);
    pull(1, b1, b2, with_ab + with_bc);
    pull(2, c1, c2, with_bc + with_ca);
  }
}
