// Hinges between faces, sixteen at a time: core/closure/hinges.cpp, written for lanes. What a hinge
// does goes along the normals of its two faces, so that pull_faces() hands it on.

template <class R>
void turn_hinges(const HingeInput<R>& in) {
  const Vec<R> zero = all(R(0)), half = all(R(0.5)), one = all(R(1));
  const Vec<R> least_cosine = all(R(1e-3)), tiny = all(kTiny_mm2<R>);
  for (int b = 0; b < in.block_count; ++b) {
    const HingeBlock<R>& hinge = in.blocks[b];
    const Vec3x<R> x0 = xyz(gather(in.x, hinge.node[0]));
    const Vec3x<R> e = xyz(gather(in.x, hinge.node[1])) - x0,
                   to2 = xyz(gather(in.x, hinge.node[2])) - x0,
                   to3 = xyz(gather(in.x, hinge.node[3])) - x0;
    const Vec3x<R> n1 = cross(e, to2), n2 = cross(to3, e);
    const Vec<R> e2 = dot(e, e) + tiny, per_length = inverse_sqrt(e2);
    const Vec<R> per_area1 = inverse_sqrt(largest(dot(n1, n1), load(hinge.least_mm4[0]))),
                 per_area2 = inverse_sqrt(largest(dot(n2, n2), load(hinge.least_mm4[1])));
    const Vec<R> per_areas = per_area1 * per_area2;
    const Vec<R> cosine = largest(zero - one, least(one, dot(n1, n2) * per_areas));
    const Vec<R> sine = dot(cross(n1, n2), e) * per_areas * per_length;
    const Vec<R> half_cosine2 = largest(half * (one + cosine), tiny);
    const Vec<R> half_cosine = half_cosine2 * inverse_sqrt(half_cosine2);
    // 4 tan(a / 4) = 4 sin(a / 2) / (1 + cos(a / 2)), sin(a / 2) = sin a / (2 cos(a / 2)).
    const Vec<R> turned =
        (sine + sine) / (largest(half_cosine, least_cosine) * (one + half_cosine)) -
        load(hinge.rest);
    // Sizes of the gradients at nodes 2 and 3, with their shares of the edge's two.
    const Vec<R> s2 = dot(to2, e), s3 = dot(to3, e);
    const Vec<R> sizes = per_length * (per_area1 * (e2 + magnitude(s2) + magnitude(s2 - e2)) +
                                       per_area2 * (e2 + magnitude(s3) + magnitude(s3 - e2)));
    const Vec<R> stiffness = load(hinge.stiffness_n_mm);
    const Vec<R> quarter = all(R(0.25)) * (turned + load(hinge.rest));
    store(stiffness * turned, in.pulls[b].moment_n_mm);
    store(half * stiffness * (one + quarter * quarter + magnitude(turned)) * sizes,
          in.pulls[b].stiffness_n);
  }
}
