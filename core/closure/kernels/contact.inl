// Part of kernels.inl: how near the features of listed pairs are, and the forces that push them
// apart.

/// Contact force and its stiffness of pairs whose features are `d` apart.
template <class R>
struct Push {
  unsigned active;
  Vec3x<R> force;
  Vec<R> stiffness;
};
template <class R>
COAPT_INLINE Push<R> push(PairBlock<R>& pairs, R used, const Vec3x<R>& d) {
  const Vec<R> thickness = load(pairs.thickness_mm), law = load(pairs.force_n_per_mm2);
  const Vec<R> distance2 = dot(d, d);
  const Mask<R> near =
      (distance2 < thickness * magnitude(thickness)) & (all(kTiny_mm2<R>) < distance2);
  const Vec<R> inverse = inverse_sqrt(largest(distance2, all(kTiny_mm2<R>)));
  const unsigned active = bits(near);
  if (active == 0) {
    const Vec<R> room = distance2 * inverse - thickness;
    pairs.asleep_until = used + least_of(room * load(pairs.per_margin_mm));
    return {0, d, thickness};
  }
  const Vec<R> gap = largest(thickness - distance2 * inverse, all(R(0)));
  const Vec<R> per_mm = law * gap * gap * inverse;
  return {active, per_mm * d, largest(all(R(2)) * law * gap, per_mm)};
}

template <class R>
struct FourQuads {
  Vec3x<R> point[4];
};
/// The nodes of sixteen pairs and, where asked for, the largest fourth of each pair.
template <class R>
COAPT_INLINE FourQuads<R> four_quads(const IndexLane* node, const Quad<R>* x,
                                     Vec<R>* largest_fourth) {
  FourQuads<R> found;
  for (int k = 0; k < 4; ++k) {
    const Vec4x<R> quad = gather(x, node[k]);
    found.point[k] = xyz(quad);
    if (largest_fourth) *largest_fourth = k == 0 ? quad.w : largest(*largest_fourth, quad.w);
  }
  return found;
}

/// How the features of sixteen pairs lie: from the nearest point of the second to that of the
/// first, and the weights of those points on their nodes.
template <class R>
struct FaceApart {
  Vec3x<R> d;
  Vec<R> wb, wc;  ///< on the face's second and third node
};
template <class R>
COAPT_INLINE FaceApart<R> face_apart(const IndexLane* node, const Quad<R>* x,
                                     Vec<R>* largest_fourth = nullptr) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const FourQuads<R> at = four_quads(node, x, largest_fourth);
  const Vec3x<R>&p = at.point[0], &a = at.point[1];
  const Vec3x<R> ab = at.point[2] - a, ac = at.point[3] - a;
  const Vec3x<R> ap = p - a;
  // Ericson 2005, 5.1.5, all regions at once: weights of b and c as fractions of one denominator.
  const Vec<R> ab2 = dot(ab, ab), ac2 = dot(ac, ac), bc = dot(ab, ac);
  const Vec<R> d1 = dot(ab, ap), d2 = dot(ac, ap);
  const Vec<R> d3 = d1 - ab2, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - ac2;
  const Vec<R> va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const Vec<R> along_bc = d4 - d3, back_bc = d5 - d6;
  Vec<R> wb = vb, wc = vc, whole = va + vb + vc;
  const auto in_case = [&](const Mask<R>& mask, const Vec<R>& b_part, const Vec<R>& c_part,
                           const Vec<R>& denominator) {
    wb = select(mask, b_part, wb);
    wc = select(mask, c_part, wc);
    whole = select(mask, denominator, whole);
  };
  in_case((va <= zero) & (zero <= along_bc) & (zero <= back_bc), back_bc, along_bc,
          along_bc + back_bc);
  in_case((vb <= zero) & (zero <= d2) & (d6 <= zero), zero, d2, d2 - d6);
  in_case((zero <= d6) & (d5 <= d6), zero, one, one);
  in_case((vc <= zero) & (zero <= d1) & (d3 <= zero), d1, zero, d1 - d3);
  in_case((zero <= d3) & (d4 <= d3), one, zero, one);
  in_case((d1 <= zero) & (d2 <= zero), zero, zero, one);
  const Vec<R> inverse = one / whole;
  wb = wb * inverse, wc = wc * inverse;
  return {ap - wb * ab - wc * ac, wb, wc};
}

template <class R>
struct EdgesApart {
  Vec3x<R> d;
  Vec<R> s, t;  ///< share of the way along the first and the second edge
};
template <class R>
COAPT_INLINE EdgesApart<R> edges_apart(const IndexLane* node, const Quad<R>* x,
                                       Vec<R>* largest_fourth = nullptr) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const auto clamp = [&](const Vec<R>& v) { return largest(zero, least(one, v)); };
  const FourQuads<R> at = four_quads(node, x, largest_fourth);
  const Vec3x<R>&a = at.point[0], &c = at.point[2];
  const Vec3x<R> ab = at.point[1] - a, cd = at.point[3] - c;
  const Vec3x<R> ca = a - c;
  // Ericson 2005, 5.1.9.
  const Vec<R> ab2 = largest(dot(ab, ab), all(kTiny_mm2<R>)),
               cd2 = largest(dot(cd, cd), all(kTiny_mm2<R>));
  const Vec<R> mixed = dot(ab, cd), along_ab = dot(ab, ca), along_cd = dot(cd, ca);
  const Vec<R> square = ab2 * cd2, determinant = square - mixed * mixed;
  const Mask<R> skew = all(R(1e-6)) * square < determinant;
  const Vec<R> on_line = (mixed * along_cd - along_ab * cd2) / select(skew, determinant, one);
  const Vec<R> s = select(skew, clamp(on_line), zero);
  const Vec<R> free_t = (mixed * s + along_cd) / cd2;
  const Vec<R> t = clamp(free_t);
  const Vec<R> beside = clamp((mixed * t - along_ab) / ab2);
  const Vec<R> place = select(free_t < zero, beside, select(one < free_t, beside, s));
  return {ca + place * ab - t * cd, place, t};
}

template <class R>
void push_faces(PairBlock<R>* blocks, int count, R used, const Quad<R>* x, Quad<R>* force) {
  for (int b = 0; b < count; ++b) {
    PairBlock<R>& pairs = blocks[b];
    if (used < pairs.asleep_until) continue;
    const FaceApart<R> apart = face_apart(pairs.node, x);
    const Push<R> pushed = push(pairs, used, apart.d);
    if (pushed.active == 0) continue;
    const Vec<R> one = all(R(1));
    const Vec<R> weight[4] = {one, one - apart.wb - apart.wc, apart.wb, apart.wc};
    scatter(pairs.node, pushed.active, pushed.force, pushed.stiffness, weight, 1, force);
  }
}

template <class R>
void push_edges(PairBlock<R>* blocks, int count, R used, const Quad<R>* x, Quad<R>* force) {
  for (int b = 0; b < count; ++b) {
    PairBlock<R>& pairs = blocks[b];
    if (used < pairs.asleep_until) continue;
    const EdgesApart<R> apart = edges_apart(pairs.node, x);
    const Push<R> pushed = push(pairs, used, apart.d);
    if (pushed.active == 0) continue;
    const Vec<R> one = all(R(1));
    const Vec<R> weight[4] = {one - apart.s, apart.s, one - apart.t, apart.t};
    scatter(pairs.node, pushed.active, pushed.force, pushed.stiffness, weight, 2, force);
  }
}
